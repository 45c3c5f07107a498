import { element, figure, table } from "./element.js";

/** Computing time of the ticks, as far as the run kept it. */
export function timingPage(run) {
  const verdict = run.verdict ?? {};
  const tick = verdict.tick_us ?? {};
  const rows = [
    ["tick, median", `${figure(tick.p50)} µs`], ["tick, 99.9 %", `${figure(tick.p999)} µs`], ["tick, longest", `${figure(tick.max)} µs`],
    ["real-time factor", figure(verdict.real_time_factor, 1)], ["allocations in the loop", String(verdict.allocations_in_loop ?? "–")],
  ];
  return element("div", "", table(["", ""], rows, "pairs"), element("p", "note", "Wall-clock figures of the machine that ran it; all else on this page is the same on every machine."));
}

/** Faults that were injected and that latched. */
export function faultsPage(run) {
  const events = run.events.filter((event) => event.name.includes("fault"));
  if (events.length === 0) return element("p", "note", "No fault was injected, none latched.");
  const rows = events.map((event) => [event.time_s.toFixed(3), event.name.replaceAll("_", " "), run.fault_help[event.value]?.name ?? String(event.value)]);
  const help = Object.entries(run.fault_help).map(([number, { name, text }]) =>
    element("section", "", element("h3", "", `${number} ${name}`), ...text.split("\n").map((line) => element("p", "", line.replaceAll("**", "").replaceAll("`", "")))),
  );
  return element("div", "", table(["time s", "event", "which"], rows), ...help);
}

/** The effective scenario, with a filter. */
export function scenarioPage(run) {
  const filter = element("input", "filter");
  filter.placeholder = "filter keys, e.g. payload";
  const text = element("pre", "");
  const show = () => {
    const lines = run.scenario_toml.split("\n");
    text.textContent = lines.filter((line) => !filter.value || line.includes(filter.value) || /^\[/.test(line)).join("\n");
  };
  filter.addEventListener("input", show);
  show();
  return element("div", "", filter, text);
}
