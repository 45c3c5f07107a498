import { element } from "../pages/element.js";
import { verdictLine } from "../pages/verdict.js";
import { TimeAxis } from "../time_axis.js";
import { showRuns } from "../views/run_view.js";
import { LiveRun } from "./live_run.js";

const AGAIN_MS = 1000;
const COUNT_MS = 1000;

/** What is published now: a view for each run that begins, fed by a WebSocket of this page's own server. */
export function openWatch(app) {
  const page = new WatchPage(app);
  page.connect();
  setInterval(() => page.count(), COUNT_MS);
  return {
    setTime: (time_s) => page.axis.set(time_s),
    scenePose: () => page.view?.stage.pose() ?? null,
    received: () => page.run?.received ?? 0,
    drawn: () => page.drawn,
    isSettled: () => !page.isDrawing && page.axis?.time_s === page.run?.to_s,
  };
}

class WatchPage {
  constructor(app) {
    Object.assign(this, { app, run: null, axis: null, view: null, isOpen: false, isDrawing: false });
    Object.assign(this, { drawn: 0, counted: { received: 0, drawn: 0 } });
    this.note = element("p", "note waiting", "Waiting for a run: tools/surefoot run --live --pace 1");
    app.replaceChildren(this.note);
  }

  connect() {
    const socket = new WebSocket(`ws://${location.host}/feed`);
    socket.binaryType = "arraybuffer";
    // One message after another: a run's view is there before its first row comes.
    let done = Promise.resolve();
    socket.addEventListener("open", () => (this.isOpen = true));
    socket.addEventListener("message", ({ data }) => {
      done = done.then(() => (typeof data === "string" ? this.hear(JSON.parse(data)) : this.append(data))).catch((error) => this.fail(error));
    });
    socket.addEventListener("close", () => {
      this.isOpen = false;
      this.note.textContent = "Connection lost: is tools/surefoot watch still running?";
      setTimeout(() => this.connect(), AGAIN_MS);
    });
  }

  /** What went wrong is said; the next run has its chance. */
  fail(error) {
    console.error(error);
    this.note.textContent = `This run cannot be shown: ${error.message}`;
    this.app.prepend(this.note);
  }

  async hear(message) {
    if (message.what === "run") await this.begin(message.run);
    if (message.what === "event") this.addEvent(message.event);
    if (message.what === "verdict") this.showVerdict(message.verdict);
  }

  async begin(described) {
    this.view?.stage.close();
    this.axis?.close();
    this.run = new LiveRun(described);
    this.axis = new TimeAxis(0, 0.1, true);
    this.view = await showRuns(this.app, [this.run], this.axis);
    this.counted = { received: 0, drawn: this.drawn };
  }

  /** Rows are kept as they come, and drawn when the browser draws. */
  append(content) {
    this.run?.append(content);
    if (this.isDrawing || !this.run?.received) return;
    this.isDrawing = true;
    requestAnimationFrame(() => {
      this.isDrawing = false;
      if (!this.run.received) return; // the next run has begun meanwhile
      this.drawn++;
      this.axis.grow(this.run.from_s, this.run.to_s);
    });
  }

  addEvent(event) {
    this.run.events.push(event);
    this.view.timeline.tick(event, 0);
    this.view.timeline.place();
    this.view.renew(["faults"]);
  }

  showVerdict(verdict) {
    this.run.verdict = verdict;
    this.view.head.replaceChildren(verdictLine(this.run));
    this.view.renew(["timing"]);
  }

  /** How the feed goes, once a second. */
  count() {
    const now = { received: this.run?.received ?? 0, drawn: this.drawn };
    const place = this.run?.live_state;
    const rates = `${now.received - this.counted.received} states a second received, ${now.drawn - this.counted.drawn} drawn`;
    const comes = now.received > this.counted.received;
    if (place) place.textContent = !this.isOpen ? "connection lost" : comes ? rates : "nothing comes";
    this.counted = now;
  }
}
