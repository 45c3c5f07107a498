import { Run } from "../data/run.js";
import { TimeAxis } from "../time_axis.js";
import { showRuns } from "./run_view.js";

/** Recorded runs, one or two, of the page's own blocks. */
export async function openReport(app, index) {
  const runs = await Promise.all(index.runs.map((described) => Run.open(described)));
  const axis = new TimeAxis(Math.min(...runs.map((run) => run.from_s)), Math.max(...runs.map((run) => run.to_s)));
  const view = await showRuns(app, runs, axis);
  axis.set(Math.max(axis.from_s, 0));
  return {
    setTime: (time_s) => axis.set(time_s),
    scenePose: () => view.stage.pose(),
    cornerHeights: () => view.stage.cornerHeights(),
    soles: () => view.stage.soles(),
  };
}
