import uPlot from "uplot";
import { decimate } from "../data/decimate.js";

const HEIGHT_PX = 150;
const SYNC = uPlot.sync("surefoot");

/** Colours of the series; they keep apart for colour-blind eyes and on both backgrounds. */
export const COLOURS = ["#2f7ed8", "#e07b39", "#3aa655", "#b05cc4"];

/** One plot over the page's time: drag to zoom, click to go there, double click to see all. */
export class TimePlot {
  /**
   * @param {HTMLElement} container
   * @param {{title: string, unit: string, series: object[]}} described
   * @param {import("../data/run.js").Run[]} runs
   * @param {import("../time_axis.js").TimeAxis} axis
   */
  constructor(container, described, runs, axis) {
    Object.assign(this, { described, axis });
    this.lines = runs.flatMap((run, number) =>
      described.series
        .filter((series) => run.table(series.table)?.has(series.column))
        .map((series) => ({ ...series, number, source: run.table(series.table), colour: COLOURS[described.series.indexOf(series) % 4] })),
    );
    this.element = document.createElement("section");
    this.element.className = "plot";
    this.element.innerHTML = `<header><h3>${described.title} <small>${described.unit}</small></h3><div class="legend"></div></header>`;
    this.legend = this.element.querySelector(".legend");
    container.append(this.element);
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
          { stroke: ink, grid, ticks: grid, size: 56 },
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
    this.axis.on((what) => (what === "range" ? this.redraw() : what === "time" && this.showInstant()));
    this.showInstant();
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
    this.plot.setData(this.data(), false);
    const [min, max] = this.axis.range;
    this.plot.setScale("x", { min, max });
  }

  resize() {
    this.plot?.setSize({ width: this.width(), height: HEIGHT_PX });
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
    this.plot.redraw(false, false);
    this.legend.replaceChildren(
      ...this.lines.map((line) => {
        const value = line.source.column(line.column)[line.source.rowAt(this.axis.time_s)] * (line.factor ?? 1);
        const entry = document.createElement("span");
        entry.className = line.number === 0 ? "first" : "second";
        entry.style.setProperty("--line", line.colour);
        entry.textContent = `${line.label} ${Number.isFinite(value) ? value.toFixed(2) : "-"}`;
        return entry;
      }),
    );
  }
}
