import { element } from "../pages/element.js";
import { JOINTS, plotList } from "./plot_list.js";
import { TimePlot } from "./time_plot.js";

/** All plots that the runs have columns for, with a choice of the joint. */
export async function showPlots(container, runs, axis) {
  const choice = element("select", "", ...JOINTS.map((joint) => new Option(joint.replace("_", " "), joint, joint === "knee_pitch", joint === "knee_pitch")));
  const list = element("div", "");
  container.append(element("label", "joint", "joint ", choice), list);
  let plots = [];
  const fill = async () => {
    for (const plot of plots) plot.close();
    plots = plotList(choice.value).map((described) => new TimePlot(described, runs, axis)).filter((plot) => !plot.isEmpty);
    list.replaceChildren(...plots.map((plot) => plot.element));
    await Promise.all(plots.map((plot) => plot.open()));
  };
  choice.addEventListener("change", fill);
  await fill();
}
