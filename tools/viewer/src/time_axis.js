/** The one instant and the one range that everything on the page shows. */
export class TimeAxis {
  constructor(from_s, to_s) {
    Object.assign(this, { from_s, to_s, time_s: from_s, range: [from_s, to_s], speed: 1, isPlaying: false });
    this.listeners = [];
  }

  /** @param {(what: "time" | "range" | "play") => void} listener */
  on(listener) {
    this.listeners.push(listener);
  }

  tell(what) {
    for (const listener of this.listeners) listener(what);
  }

  set(time_s) {
    this.time_s = Math.min(Math.max(time_s, this.from_s), this.to_s);
    this.tell("time");
  }

  setRange(from_s, to_s) {
    const range = [Math.max(from_s, this.from_s), Math.min(to_s, this.to_s)];
    if (range[1] - range[0] < 0.005) return;
    this.range = range;
    this.tell("range");
  }

  showAll() {
    this.setRange(this.from_s, this.to_s);
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
