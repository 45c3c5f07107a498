import { element } from "./element.js";

/** The effective scenario, with a filter. */
export function scenarioPage(run) {
  if (!run.scenario_toml) return element("p", "note", "This run has no scenario.toml: what was simulated is not known.");
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
