const LIVE_WINDOW_S = 12;
const LEAST_RANGE_S = 0.005;

/** The one instant and the one range that everything on a page shows. It ends with its page: `closed`. */
export class TimeAxis {
  /** @param {boolean} isLive  it grows, and follows what comes until somebody looks elsewhere */
  constructor(from_s, to_s, isLive = false) {
    Object.assign(this, { from_s, to_s, time_s: from_s, range: [from_s, to_s], speed: 1, isPlaying: false });
    Object.assign(this, { isLive, isFollowing: isLive });
    this.listeners = [];
    this.ending = new AbortController();
  }

  /** @returns {AbortSignal} for listeners beyond the page's own elements */
  get closed() {
    return this.ending.signal;
  }

  close() {
    this.isPlaying = false;
    this.listeners = [];
    this.ending.abort();
  }

  /**
   * @param {(what: "time" | "range" | "play") => void} listener
   * @returns {() => void} ends it
   */
  on(listener) {
    this.listeners.push(listener);
    return () => (this.listeners = this.listeners.filter((other) => other !== listener));
  }

  tell(what) {
    for (const listener of this.listeners) listener(what);
  }

  set(time_s) {
    this.isFollowing = false;
    this.show(time_s);
  }

  show(time_s) {
    this.time_s = Math.min(Math.max(time_s, this.from_s), this.to_s);
    this.tell("time");
  }

  setRange(from_s, to_s) {
    const range = [Math.max(from_s, this.from_s), Math.min(to_s, this.to_s)];
    if (range[1] - range[0] < LEAST_RANGE_S) return;
    this.isFollowing = false;
    this.range = range;
    this.tell("range");
  }

  showAll() {
    this.setRange(this.from_s, this.to_s);
  }

  /** More of a run that is going on. */
  grow(from_s, to_s) {
    Object.assign(this, { from_s, to_s });
    if (!this.isFollowing) return;
    this.range = [Math.max(from_s, to_s - LIVE_WINDOW_S), Math.max(to_s, from_s + LEAST_RANGE_S)];
    this.tell("range");
    this.show(to_s);
  }

  follow() {
    this.play(false);
    this.isFollowing = true;
    this.grow(this.from_s, this.to_s);
    this.tell("play");
  }

  play(isPlaying) {
    if (isPlaying && this.time_s >= this.to_s) this.time_s = this.from_s;
    this.isPlaying = isPlaying;
    this.tell("play");
    if (!isPlaying) return;
    let last_ms = performance.now();
    const step = (now_ms) => {
      if (!this.isPlaying) return;
      this.set(this.time_s + ((now_ms - last_ms) / 1000) * this.speed);
      last_ms = now_ms;
      if (this.time_s >= this.to_s) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }
}
