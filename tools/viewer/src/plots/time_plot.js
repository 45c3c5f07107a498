import uPlot from "uplot";
import { decimate } from "../data/decimate.js";
import { element } from "../pages/element.js";

const HEIGHT_PX = 150;
const SYNC = uPlot.sync("surefoot");

/** Colours of the series; they keep apart for colour-blind eyes and on both backgrounds. */
export const COLOURS = ["#2f7ed8", "#e07b39", "#3aa655", "#b05cc4"];

/** One plot over the page's time: drag to zoom, click to go there, double click to see all. */
export class TimePlot {
  /**
   * @param {{title: string, unit: string, series: object[]}} described
   * @param {import("../data/run.js").Run[]} runs
   * @param {import("../time_axis.js").TimeAxis} axis
   */
  constructor(described, runs, axis) {
    Object.assign(this, { described, axis });
    this.lines = runs.flatMap((run, number) =>
      described.series
        .filter((series) => run.table(series.table)?.has(series.column))
        .map((series) => ({ ...series, number, source: run.table(series.table), colour: COLOURS[described.series.indexOf(series) % 4] })),
    );
    this.element = document.createElement("section");
    this.element.className = "plot";
    this.legend = element("div", "legend");
    this.element.append(element("header", "", element("h3", "", `${described.title} `, element("small", "", described.unit)), this.legend));
  }

  get isEmpty() {
    return this.lines.length === 0;
  }

  async open() {
    await Promise.all(this.lines.map((line) => line.source.load([line.column])));
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue("--ink-soft").trim();
    const grid = { stroke: style.getPropertyValue("--grid").trim(), width: 1 };
    this.plot = new uPlot(
      {
        width: this.width(), height: HEIGHT_PX, legend: { show: false },
        cursor: { sync: { key: SYNC.key }, drag: { x: true, y: false }, points: { show: false } },
        scales: { x: { time: false } },
        axes: [
          { stroke: ink, grid, ticks: grid, values: (_, ticks) => ticks.map((tick) => `${tick} s`) },
          { stroke: ink, grid, ticks: grid, size: 56, space: 22 },
        ],
        series: [{}, ...this.lines.map((line) => this.styled(line))],
        hooks: {
          draw: [(plot) => this.drawInstant(plot)],
          setSelect: [(plot) => this.zoom(plot)],
          ready: [(plot) => this.listen(plot)],
        },
      },
      this.data(), this.element,
    );
    this.stopListening = this.axis.on((what) => what !== "play" && this.show(what));
    // Of the element, not of the window: behind another tab it has no width.
    this.watched = new ResizeObserver(() => this.resize());
    this.watched.observe(this.element);
    // What is scrolled out of sight is drawn when it comes into sight: that is most of the page.
    this.seen = new IntersectionObserver(([entry]) => {
      this.isSeen = entry.isIntersecting;
      if (this.isSeen) this.show("range");
    });
    this.seen.observe(this.element);
    this.axis.closed.addEventListener("abort", () => this.close());
    this.redraw();
    this.showInstant();
  }

  /** @param {"time" | "range"} what  has changed */
  show(what) {
    this.isOutdated ||= what === "range";
    if (this.isSeen === false && !this.element.hidden) return;
    if (this.isOutdated) this.redraw();
    this.showInstant();
  }

  close() {
    this.stopListening?.();
    this.watched?.disconnect();
    this.seen?.disconnect();
    this.plot?.destroy();
  }

  styled(line) {
    return { stroke: line.colour, width: line.number === 0 ? 1.4 : 1, dash: line.number === 0 ? undefined : [5, 4], spanGaps: false };
  }

  width() {
    return Math.max(240, this.element.clientWidth);
  }

  /** Lines of one time share its points; a run of its own has points of its own, joined by uPlot. */
  data() {
    const groups = new Map();
    for (const line of this.lines) groups.set(line.source, [...(groups.get(line.source) ?? []), line]);
    const [from_s, to_s] = this.axis.range;
    const order = [];
    const tables = [...groups].map(([source, lines]) => {
      order.push(...lines);
      const columns = lines.map((line) => source.column(line.column));
      const [times, ...values] = decimate(source.time_s, columns, from_s, to_s, this.width());
      return [times, ...values.map((shown, i) => shown.map((value) => value * (lines[i].factor ?? 1)))];
    });
    const joined = tables.length === 1 ? tables[0] : uPlot.join(tables, tables.map((table) => table.map(() => 2)));
    return [joined[0], ...this.lines.map((line) => joined[1 + order.indexOf(line)])];
  }

  redraw() {
    this.isOutdated = false;
    // A live run may have told nothing of this yet, or never will.
    this.element.hidden = !this.lines.some((line) => line.source.rows > 0);
    if (this.element.hidden) return;
    const [min, max] = this.axis.range;
    this.plot.batch(() => {
      this.plot.setData(this.data(), false);
      this.plot.setScale("x", { min, max });
    });
  }

  resize() {
    if (this.element.clientWidth === 0 || this.plot.width === this.width()) return;
    this.plot.setSize({ width: this.width(), height: HEIGHT_PX });
    this.redraw();
  }

  zoom(plot) {
    if (plot.select.width < 4) return;
    const [from_s, to_s] = [plot.select.left, plot.select.left + plot.select.width].map((px) => plot.posToVal(px, "x"));
    plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    this.axis.setRange(from_s, to_s);
  }

  listen(plot) {
    plot.over.addEventListener("click", () => {
      if (plot.cursor.left >= 0) this.axis.set(plot.posToVal(plot.cursor.left, "x"));
    });
    plot.over.addEventListener("dblclick", () => this.axis.showAll());
  }

  drawInstant(plot) {
    const x = Math.round(plot.valToPos(this.axis.time_s, "x", true));
    const { left, top, width, height } = plot.bbox;
    if (x < left || x > left + width) return;
    plot.ctx.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--now");
    plot.ctx.fillRect(x, top, Math.max(1, devicePixelRatio), height);
  }

  showInstant() {
    if (this.element.hidden) return;
    this.plot.redraw(false, false);
    this.legend.replaceChildren(
      ...this.lines.map((line) => {
        const value = line.source.column(line.column)[line.source.rowAt(this.axis.time_s)] * (line.factor ?? 1);
        const entry = document.createElement("span");
        entry.className = line.number === 0 ? "first" : "second";
        entry.style.setProperty("--line", line.colour);
        entry.textContent = `${line.label} ${Number.isFinite(value) ? value.toFixed(2) : "–"}`;
        return entry;
      }),
    );
  }
}
