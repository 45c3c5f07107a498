#include "firmware/host/realtime/realtime_rights.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <system_error>
#include <utility>

namespace surefoot::host {
namespace {

constexpr const char* kLatencyFile = "/dev/cpu_dma_latency";

/// The processors that the thread may use, e.g. "0, 1".
std::string permitted_cpus() {
  cpu_set_t set;
  CPU_ZERO(&set);
  sched_getaffinity(0, sizeof set, &set);
  std::string list;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(static_cast<unsigned>(cpu), &set)) list += fmt::format("{}{}", list.empty() ? "" : ", ", cpu);
  }
  return list;
}

}  // namespace

RealtimeRights::RealtimeRights(const RealtimeRequest& request) : missing_(make_resident(request.memory)) {
  // The kernel may merge an ordinary thread's wake-ups within 50 us. Real-time threads have no slack;
  // this is for the loop that did not get its priority. Asked of one's own thread it cannot fail.
  prctl(PR_SET_TIMERSLACK, 1UL);
  if (request.cpu != RealtimeRequest::kAnyCpu) pin(request.cpu);
  if (request.keep_cpu_awake) keep_cpu_awake();
  if (request.fifo_priority != 0) set_priority(request.fifo_priority);
}

void RealtimeRights::set_priority(int fifo_priority) {
  sched_param parameters{};
  parameters.sched_priority = fifo_priority;
  // FIFO: runs before every ordinary thread, until it waits. Reset on fork: what it starts does not.
  if (sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) == 0) return;
  const int error_number = errno;
  MissingRight right{fmt::format("SCHED_FIFO priority {}", fifo_priority),
                     std::generic_category().message(error_number), ""};
  if (error_number == EPERM) {
    rlimit limit{};
    getrlimit(RLIMIT_RTPRIO, &limit);
    right.why += fmt::format("; the limit of real-time priority (ulimit -r) is {}", limit.rlim_cur);
    right.remedy = fmt::format(
        "{}; or ulimit -r {} ('rtprio {}' in /etc/security/limits.conf, LimitRTPRIO={} of systemd); or start it with "
        "sudo chrt -f {}",
        grant_capabilities_command(), fifo_priority, fifo_priority, fifo_priority, fifo_priority);
  } else {
    right.remedy = fmt::format("chrt -m shows the priorities that there are; ask for one of {} to {}",
                               sched_get_priority_min(SCHED_FIFO), sched_get_priority_max(SCHED_FIFO));
  }
  missing_.push_back(std::move(right));
}

void RealtimeRights::pin(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (cpu >= 0 && cpu < CPU_SETSIZE) CPU_SET(static_cast<unsigned>(cpu), &set);
  // Moving to another processor costs the caches, and waits for that processor's turn.
  if (sched_setaffinity(0, sizeof set, &set) == 0) return;
  missing_.push_back({fmt::format("processor {} to itself", cpu), std::generic_category().message(errno),
                      fmt::format("ask for one of the processors that this process may use: {} (nproc --all and "
                                  "taskset -cp $$ show them)",
                                  permitted_cpus())});
}

void RealtimeRights::keep_cpu_awake() {
  latency_file_ = FileDescriptor(open(kLatencyFile, O_WRONLY | O_CLOEXEC));
  constexpr std::int32_t kLatencyUs = 0;
  // Holds while the file is open (kernel's PM quality of service): idle processors stay where waking is immediate.
  if (latency_file_.get() >= 0 && write(latency_file_.get(), &kLatencyUs, sizeof kLatencyUs) == sizeof kLatencyUs)
    return;
  const int error_number = errno;
  missing_.push_back(
      {fmt::format("idle states without delay ({})", kLatencyFile), std::generic_category().message(error_number),
       error_number == ENOENT ? std::string("boot with processor.max_cstate=1 (this kernel has no such file)")
                              : fmt::format("sudo setfacl -m u:$USER:rw {} (or a udev rule that does)", kLatencyFile)});
}

}  // namespace surefoot::host
