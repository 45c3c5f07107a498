import { busPage } from "../pages/bus_page.js";
import { element } from "../pages/element.js";
import { faultsPage } from "../pages/faults_page.js";
import { scenarioPage } from "../pages/scenario_page.js";
import { timingPage } from "../pages/timing_page.js";
import { Timeline } from "../pages/timeline.js";
import { transport } from "../pages/transport.js";
import { verdictLine } from "../pages/verdict.js";
import { showPlots } from "../plots/plots_page.js";
import { showStage } from "../scene/stage.js";

const PAGES = { plots: null, bus: busPage, timing: timingPage, faults: faultsPage, scenario: scenarioPage };

/**
 * Verdict, time line, replay and pages of one or two runs over one axis.
 * @returns {Promise<{stage: object, timeline: Timeline, head: HTMLElement, renew: (names: string[]) => void}>}
 */
export async function showRuns(app, runs, axis) {
  const stage = element("div", "stage");
  const side = element("div", "side");
  const head = element("div", "head", ...runs.map(verdictLine));
  const strip = element("div", "timeline");
  app.replaceChildren(
    element("header", "top", element("h1", "", "Surefoot"), head),
    element("div", "controls", transport(axis), strip), element("main", "", stage, side),
  );
  const timeline = new Timeline(strip, runs, axis);
  const [renew, shown] = await Promise.all([showPages(side, runs, axis), showStage(stage, runs, axis)]);
  return { stage: shown, timeline, head, renew };
}

/** @returns {Promise<(names: string[]) => void>} makes pages of these names anew, for a run that has gone on */
async function showPages(side, runs, axis) {
  const tabs = element("nav", "tabs");
  const body = element("div", "page");
  side.append(tabs, body);
  const plots = element("div", "plots");
  const made = (make) => element("div", "", ...runs.map((run) => element("section", "run", runs.length > 1 ? element("h2", "", run.name) : "", make(run, axis))));
  const pages = new Map(Object.entries(PAGES).map(([name, make]) => [name, make ? made(make) : plots]));
  let chosen = "plots";
  const show = () => {
    body.replaceChildren(pages.get(chosen));
    for (const tab of tabs.children) tab.classList.toggle("chosen", tab.textContent === chosen);
    for (const frames of body.querySelectorAll(".frames")) frames.show();
  };
  for (const name of pages.keys()) {
    const tab = element("button", "", name);
    tab.addEventListener("click", () => {
      chosen = name;
      show();
    });
    tabs.append(tab);
  }
  show();
  await showPlots(plots, runs, axis);
  return (names) => {
    for (const name of names) pages.set(name, made(PAGES[name]));
    if (names.includes(chosen)) show();
  };
}
