import { EVENT, isFault } from "../data/event_codes.js";
import { element, table } from "./element.js";

/** Faults that were injected and that latched, each with what it was. */
export function faultsPage(run) {
  const events = run.events.filter(isFault);
  if (events.length === 0) return element("p", "note", "No fault was injected, none latched.");
  const rows = events.map((event) => [event.time_s.toFixed(3), what(event), which(event, run)]);
  const latched = new Set(events.filter((event) => event.code === EVENT.FAULT_LATCHED).map((event) => String(event.value)));
  const help = Object.entries(run.fault_help).filter(([number]) => latched.has(number)).map(([number, { name, text }]) =>
    element("section", "", element("h3", "", `${number} ${name}`), ...text.split("\n").map((line) => element("p", "", line.replaceAll("**", "").replaceAll("`", "")))),
  );
  return element("div", "", table(["time s", "event", "which"], rows), ...help);
}

function what({ code }) {
  return { [EVENT.FAULT_INJECTED]: "injected", [EVENT.FAULT_ENDED]: "ended" }[code] ?? "latched";
}

/** A latched fault by number and name, an injected one as the scenario describes it. */
function which({ code, name, value }, run) {
  if (code === EVENT.FAULT_LATCHED) return `${value} ${name}`;
  const described = run.faults?.[value] ?? {};
  const text = ["kind", "target", "signal", "element", "probability", "value"].filter((key) => key in described).map((key) => `${key} ${described[key]}`);
  return [`fault.${value}`, ...text].join(", ");
}
