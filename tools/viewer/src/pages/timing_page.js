import { withEmptyBins } from "../data/bins.js";
import { element, figure, table } from "./element.js";

const HEIGHT_PX = 140;

/** Computing time of the ticks: figures, and how they are distributed. */
export function timingPage(run) {
  const verdict = run.verdict ?? {};
  const tick = verdict.tick_us ?? {};
  const rows = [
    ["tick, mean", `${figure(tick.mean)} µs`], ["tick, median", `${figure(tick.p50)} µs`], ["tick, 99.9 %", `${figure(tick.p999)} µs`], ["tick, longest", `${figure(tick.max)} µs`],
    ["real-time factor", figure(verdict.real_time_factor, 1)], ["allocations in the loop", String(verdict.allocations_in_loop ?? "–")],
  ];
  return element(
    "div", "", table(["", ""], rows, "pairs"), ...(tick.histogram?.length ? [histogram(tick.histogram)] : []),
    element("p", "note", "Wall-clock figures of the machine that ran it; all else on this page is the same on every machine."),
  );
}

/**
 * Columns over computing time, four to a doubling; their height is the logarithm of the count, for one slow tick in a
 * million is what one looks for.
 * @param {[number, number, number][]} bins  from_us, to_us, count, ascending; empty ones left out
 */
function histogram(bins) {
  const most = Math.log1p(bins.reduce((a, [, , count]) => Math.max(a, count), 0));
  const total = bins.reduce((sum, [, , count]) => sum + count, 0);
  const columns = withEmptyBins(bins).map(([from_us, to_us, count]) => {
    const column = element("div", "column", element("div", "filled"));
    column.firstChild.style.height = `${(HEIGHT_PX * Math.log1p(count)) / most}px`;
    column.title = `${figure(from_us, 2)} to ${figure(to_us, 2)} µs: ${count} of ${total} ticks`;
    return column;
  });
  const first = bins[0];
  const last = bins.at(-1);
  const chart = element("div", "columns", ...columns);
  chart.style.height = `${HEIGHT_PX}px`;
  return element(
    "section", "histogram", element("h3", "", "Computing time of a tick ", element("small", "", `${total} ticks, counts on a logarithmic scale`)), chart,
    element("div", "ends", element("span", "", `${figure(first[0], 2)} µs`), element("span", "", `${figure(last[1], 2)} µs`)),
  );
}
