import { kindOf } from "../data/event_codes.js";
import { element } from "./element.js";

const NAME_SHARE = 0.075; // of the width, for a name
const FLIP_SHARE = 0.93; // from here on names stand left of their instant

/** Events of all runs over the shown range; a click goes there. */
export class Timeline {
  constructor(container, runs, axis) {
    this.axis = axis;
    this.lanes = runs.map((run) => element("div", "lane"));
    this.now = element("div", "now");
    this.strip = element("div", "strip", ...this.lanes, this.now);
    container.append(this.strip);
    this.ticks = [];
    runs.forEach((run, number) => run.events.forEach((event) => this.tick(event, number)));
    this.strip.addEventListener("pointerdown", (down) => {
      if (down.target.closest(".tick")) return;
      this.go(down);
      this.strip.setPointerCapture(down.pointerId);
    });
    this.strip.addEventListener("pointermove", (move) => this.strip.hasPointerCapture(move.pointerId) && this.go(move));
    axis.on((what) => (what === "range" ? this.place() : this.placeNow()));
    this.place();
  }

  /** @param {number} number  of the run */
  tick(event, number) {
    const lane = this.lanes[number];
    const tick = element("button", `tick ${kindOf(event)}`, element("span", "", event.name.replaceAll("_", " ")));
    tick.title = `${event.name} at ${event.time_s.toFixed(3)} s, value ${event.value}`;
    tick.addEventListener("click", () => this.axis.set(event.time_s));
    lane.append(tick);
    this.ticks.push({ tick, lane, time_s: event.time_s });
  }

  share(time_s) {
    const [from_s, to_s] = this.axis.range;
    return (time_s - from_s) / (to_s - from_s);
  }

  go(pointer) {
    const box = this.strip.getBoundingClientRect();
    const [from_s, to_s] = this.axis.range;
    this.axis.set(from_s + ((pointer.clientX - box.left) / box.width) * (to_s - from_s));
  }

  // Names that would lie on one another take the next of three heights; a fourth shows by its tip only.
  place() {
    const endsOf = new Map(this.lanes.map((lane) => [lane, [0, 0, 0]]));
    for (const { tick, lane, time_s } of this.ticks) {
      const ends = endsOf.get(lane);
      const share = this.share(time_s);
      tick.hidden = share < 0 || share > 1;
      tick.style.left = `${100 * share}%`;
      const row = ends.findIndex((end) => end <= share);
      tick.classList.toggle("nameless", row < 0);
      tick.classList.toggle("flipped", share > FLIP_SHARE);
      if (!tick.hidden && row >= 0) ends[row] = share + NAME_SHARE;
      tick.style.setProperty("--row", row);
    }
    this.placeNow();
  }

  placeNow() {
    this.now.style.left = `${100 * this.share(this.axis.time_s)}%`;
  }
}
