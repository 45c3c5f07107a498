import { element, figure } from "./element.js";

const span = (range) => (range ? `${figure(range.min)} to ${figure(range.max)}` : "–");

/** Verdict and key figures of a run, one line. */
export function verdictLine(run) {
  const verdict = run.verdict;
  if (run.is_live && !verdict) return liveLine(run);
  if (!verdict) {
    return element("div", "verdict interrupted", element("b", "", "interrupted"), ` no verdict.json in ${run.name}: shown is what was recorded until then`);
  }
  const peak_nm = Math.max(...Object.values(verdict.peak_torque_nm ?? {}));
  const figures = [
    ["pitch", `${span(verdict.torso_pitch_deg)}°`], ["roll", `${span(verdict.torso_roll_deg)}°`],
    ["way", `${figure(verdict.distance_m)} m`], ["peak torque", `${figure(peak_nm, 0)} N m`],
    ["slip", `${figure(verdict.foot_slip_mm, 1)} mm a step`], ["bus", `${figure(verdict.bus_load_percent, 1)} %`],
    ["frames lost", String(verdict.frames_lost ?? "–")],
  ];
  return element(
    "div", `verdict ${verdict.verdict}`, element("b", "", verdict.verdict), element("span", "name", run.name), element("span", "reason", verdict.reason),
    element("span", "figures", ...figures.map(([name, value]) => element("span", "", element("i", "", name), ` ${value}`))),
  );
}

/** A run that is going on; `live` is filled by what comes. */
function liveLine(run) {
  run.live_state = element("span", "figures", "");
  return element("div", "verdict live", element("b", "", "live"), element("span", "name", run.name), run.live_state);
}
