# shellcheck shell=bash
# The host's side of with-vcan's User Mode Linux: starts the guest, passes data and signals, cleans up.
# Sourced by tools/with-vcan, which sets the variables that stand here with a question mark.
: "${root?}" "${interfaces?}" "${backend?}" "${memory?}" "${timeout_s?}" "${grace_s?}"

readonly boot_limit_s=120
readonly chunks_ahead=8  # how far a piped stdin may be ahead of the command

folder=""          # all files of this guest; gone when with-vcan ends, however it ends
terminal_state=""  # what stty says of the caller's terminal
life_end=""        # write end of a pipe: when with-vcan ends, its readers see the end of the file
priority=()        # words in front of the guest's program: processors, scheduling
timed_out=false
asked_to_end=false

temporary_folder() {
  local parent="${TMPDIR:-/tmp}"
  # It becomes part of the kernel's command line.
  [[ "$parent" =~ ^/[A-Za-z0-9/_.+-]+$ && -w "$parent" ]] || parent=/tmp
  mktemp -d "$parent/with-vcan.XXXXXX"
}

# Memory of the guest is a deleted file: on a tmpfs where it fits and may be executed (in Docker it may not).
memory_folder() {
  local wanted_kib free_kib options
  wanted_kib=$(($(numfmt --from=iec "$memory") / 1024))
  free_kib="$(df --output=avail /dev/shm 2>/dev/null | tail -n 1)" || true
  options="$(findmnt -n -o OPTIONS -T /dev/shm)" || true
  if [[ -w /dev/shm && ",$options," != *,noexec,* && "${free_kib:-0}" -gt "$wanted_kib" ]]; then
    echo /dev/shm
  else
    echo "$folder"
  fi
}

# Turns a background shell into a program with a session of its own, which ends when with-vcan does.
become_session() {
  exec {life_end}>&-
  # shellcheck disable=SC2016  # expands in the inner shell
  exec setsid bash -c 'echo "$$" >>"$1/sessions"; shift; exec "$@"' - "$folder" "$@"
}

# Even after a kill -9 of with-vcan nothing stays: no process, no file. Not a child of it: a whole tree may be killed.
start_keeper() {
  mkfifo "$folder/life"
  # shellcheck disable=SC2016
  (setsid bash -c '
    trap "" HUP INT TERM
    cat "$1/life" >/dev/null
    [[ -d "$1" ]] || exit 0
    while read -r leader; do kill -KILL -- "-$leader"; done <"$1/sessions"
    until rm -rf "$1"; do :; done' - "$folder" </dev/null >/dev/null 2>&1 &)
  exec {life_end}>"$folder/life"
}

clean_up() {
  local leader
  while read -r leader; do
    kill -KILL -- "-$leader" 2>/dev/null || true
  done <"$folder/sessions"
  : >"$folder/sessions"
  exec {life_end}>&-
  { wait; } 2>/dev/null
  rm -rf "$folder"
  if [[ -n "$terminal_state" ]]; then stty "$terminal_state" <&"$caller_stdin"; fi
}

tell_guest() { echo "$*" >&"$control"; }

# Waits in a background shell; ends that shell if with-vcan ends meanwhile.
pause() {  # pause SECONDS
  local life
  exec {life}<"$folder/life"
  read -rt "$1" _ <&"$life" || (($? > 128)) || exit 0
  exec {life}<&-
}

outlive_signals() {
  trap "" HUP INT TERM
  exec {life_end}>&-
}

# Sends a signal to this shell later.
alarm() {  # alarm SECONDS SIGNAL
  (outlive_signals && pause "$1" && kill -s "$2" "$$") &
}

# Once the guest listens: the time-out begins; what was said to the guest before is heard with the next word only.
# Nothing may come from outside into virtual time, unless somebody asks for it.
on_guest_ready() {
  (
    outlive_signals
    until [[ -e "$folder/ready" ]]; do pause 0.05; done
    [[ "$backend" == uml-time-travel ]] || tell_guest hello
    [[ -z "$timeout_s" ]] || { pause "$timeout_s" && kill -s VTALRM "$$"; }
  ) &
}

on_signal() {  # on_signal NAME
  tell_guest signal "$1"
  if [[ "$1" != USR* ]] && ! "$asked_to_end"; then
    asked_to_end=true
    alarm "$grace_s" XCPU
  fi
}

on_resize() {
  local size
  size="$(stty size <&"$caller_stdin")" && tell_guest size "$size"
}

on_timeout() {
  timed_out=true
  on_signal TERM
}

on_grace_over() {
  kill -KILL -- "-$guest" 2>/dev/null || true
}

on_alarm() {
  if [[ ! -e "$folder/ready" ]]; then on_grace_over; fi
}

# Processors with AMX have more state than User Mode Linux before 6.13 allows for.
whole_xstate() {
  grep -q -w amx_tile /proc/cpuinfo || return 0
  TMPDIR="$folder" cc -x c -O2 -shared -fPIC -o "$folder/whole_xstate.so" "$root/tools/vcan/whole_xstate.inc" >&2 ||
    fail 77 "User Mode Linux needs help on a processor with AMX, and that does not compile" \
      "as root, run: apt-get install -y gcc libc6-dev"
  echo "$folder/whole_xstate.so"
}

write_settings() {
  printf '%s\0' "$@" >"$folder/argv"
  { cat "/proc/$$/environ"; printf 'SUREFOOT_VCAN=%s\0' "$backend"; } >"$folder/environment"
  printf '%s\n' "$PWD" >"$folder/directory"
  cat >"$folder/settings" <<TEXT
interfaces=$interfaces
mask=$(umask)
host_name=$(printf %q "$HOSTNAME")
stdin=/dev/null
stdin_is_piped=$stdin_is_piped
on_terminal=$on_terminal
rows=$rows
columns=$columns
TEXT
  cp "$root/tools/vcan/guest-init" "$root/tools/vcan/network-up" "$folder/"
}

# A job in the background must leave the terminal's input to the shell.
has_terminal() {
  local status
  [[ -t 0 && -t 1 && -t 2 ]] || return 1
  status="$(<"/proc/$$/stat")"
  read -r -a status <<<"${status##*) }"  # proc(5): from the third field on
  [[ "${status[2]}" == "${status[5]}" ]]  # own group and the terminal's
}

# A terminal is handed over as it is, a file is copied from where it stands, a pipe is passed on in chunks.
prepare_stdin() {
  local position
  stdin_is_piped=false on_terminal=false rows=0 columns=0
  if has_terminal; then
    on_terminal=true
    terminal_state="$(stty -g)"
    read -r rows columns < <(stty size)
  elif [[ -f /dev/stdin ]]; then
    position="$(sed -n 's/^pos:\s*//p' /proc/self/fdinfo/0)"
    tail -c "+$((position + 1))" /proc/self/fd/0 >"$folder/stdin" 2>/dev/null || cat >"$folder/stdin"
  elif [[ "$backend" == uml-time-travel && ! -c /dev/stdin ]]; then
    cat >"$folder/stdin"  # complete before time begins
  elif [[ ! -c /dev/stdin ]]; then
    stdin_is_piped=true
  fi
}

feed_stdin() {
  # shellcheck disable=SC2016
  become_session bash -c '
    cd "$1"
    for ((n = 0; ; n++)); do
      dd of=stdin.part bs=64K count=1 status=none
      [[ -s stdin.part ]] || break
      mv stdin.part "stdin.$n"
      echo "stdin $n" >control
      while [[ -e "stdin.$((n - $2))" ]]; do read -rt 0.02 _ <>never; done
    done
    echo "stdin end" >control' - "$folder" "$chunks_ahead" <&"$caller_stdin" &
}

# Follows what the guest writes until the guest is gone. A reader who went away is reported to the guest.
follow() {  # follow NAME
  : >"$folder/$1"
  # shellcheck disable=SC2016
  become_session bash -c 'tail -c +1 -s 0.05 --pid="$3" -f "$1/$2" 2>/dev/null || echo "closed $2" >"$1/control"' \
    - "$folder" "$1" "$guest" &
}

start_guest() {  # start_guest PROGRAM
  local arguments=("mem=$memory" "umid=guest" "uml_dir=$folder/uml/" rootfstype=hostfs rw "init=$folder/guest-init"
    "surefoot_run=$folder" "con=null" "con0=null,fd:1" "con1=fd:$control_in,null")
  if "$on_terminal"; then arguments+=("con2=fd:$caller_stdin,fd:$caller_stdout"); fi
  [[ "$backend" != uml-time-travel ]] || arguments+=(time-travel=inf-cpu time-travel-start=1600000000000000000)
  local environment
  environment=("TMPDIR=$(memory_folder)" "LD_PRELOAD=$(whole_xstate)")
  become_session setpriv --pdeathsig KILL "${priority[@]}" env "${environment[@]}" "$1" "${arguments[@]}" \
    </dev/null >"$folder/console" 2>&1 &
  guest=$!
}

fail_with_console() {  # fail_with_console EXIT_CODE MESSAGE REMEDY
  sed 's/^/  guest: /' "$folder/console" | tail -n 20 >&2
  fail "$@"
}

exit_code() {
  if "$timed_out"; then
    echo "with-vcan: the time of $timeout_s s is over" >&2
    exit 124
  fi
  [[ ! -e "$folder/status" ]] || exit "$(<"$folder/status")"
  if "$asked_to_end"; then exit 137; fi
  [[ -e "$folder/ready" ]] || fail_with_console 77 \
    "User Mode Linux does not start here; the end of its messages stands above" \
    "run it where ptrace is allowed, with $memory of free memory"
  fail_with_console 70 "the guest ended before the command did; the end of its messages stands above" \
    "give it more memory (--memory 1G), or report it with those messages"
}

run_in_guest() {  # run_in_guest PROGRAM COMMAND...
  local program="$1"
  shift
  [[ -e /proc/self/fd/0 ]] || exec </dev/null
  folder="$(temporary_folder)"
  mkfifo "$folder/control" "$folder/never"
  : >"$folder/sessions"
  trap clean_up EXIT
  start_keeper
  exec {caller_stdin}<&0 {caller_stdout}>&1 {control}<>"$folder/control"
  exec {control_in}<"$folder/control"
  prepare_stdin
  write_settings "$@"
  local signal
  for signal in INT TERM HUP QUIT USR1 USR2; do
    # shellcheck disable=SC2064  # this signal
    trap "on_signal $signal" "$signal"
  done
  if "$on_terminal"; then trap on_resize WINCH; fi
  trap on_timeout VTALRM
  trap on_grace_over XCPU
  trap on_alarm ALRM
  start_guest "$program"
  if "$stdin_is_piped"; then feed_stdin; fi
  follow stdout
  local stdout_reader=$!
  follow stderr >&2
  local stderr_reader=$!
  alarm "$boot_limit_s" ALRM
  on_guest_ready
  {  # bash would report how they ended
    while kill -0 "$guest"; do wait "$guest" || true; done
    wait "$stdout_reader" "$stderr_reader" || true
  } 2>/dev/null
  exit_code
}
