import "uplot/dist/uPlot.min.css";
import "./viewer.css";
import { Run } from "./data/run.js";
import { busPage } from "./pages/bus_page.js";
import { element } from "./pages/element.js";
import { faultsPage, scenarioPage, timingPage } from "./pages/text_pages.js";
import { Timeline } from "./pages/timeline.js";
import { transport } from "./pages/transport.js";
import { verdictLine } from "./pages/verdict.js";
import { JOINTS, plotList } from "./plots/plot_list.js";
import { TimePlot } from "./plots/time_plot.js";
import { loadPoses, poseAt } from "./scene/poses.js";
import { RobotScene } from "./scene/robot_scene.js";
import { TimeAxis } from "./time_axis.js";

const PAGES = { plots: null, bus: busPage, timing: timingPage, faults: faultsPage, scenario: scenarioPage };

async function open() {
  const index = JSON.parse(document.getElementById("surefoot-index").textContent);
  const runs = await Promise.all(index.runs.map((described) => Run.open(described)));
  const axis = new TimeAxis(Math.min(...runs.map((run) => run.from_s)), Math.max(...runs.map((run) => run.to_s)));
  const app = document.getElementById("surefoot-app");
  const stage = element("div", "stage");
  const side = element("div", "side");
  const head = element("div", "head", ...runs.map(verdictLine));
  const strip = element("div", "timeline");
  app.append(element("header", "top", element("h1", "", "Surefoot"), head), element("div", "controls", transport(axis), strip), element("main", "", stage, side));
  new Timeline(strip, runs, axis);
  const [, drawn] = await Promise.all([showPages(side, runs, axis), showScene(stage, runs, axis)]);
  axis.set(Math.max(axis.from_s, 0));
  return { axis, drawn };
}

async function showPages(side, runs, axis) {
  const tabs = element("nav", "tabs");
  const body = element("div", "page");
  side.append(tabs, body);
  const plots = element("div", "plots");
  const pages = Object.entries(PAGES).map(([name, make]) => {
    const page = make ? element("div", "", ...runs.map((run) => element("section", "run", runs.length > 1 ? element("h2", "", run.name) : "", make(run, axis)))) : plots;
    const tab = element("button", "", name);
    tab.addEventListener("click", () => {
      body.replaceChildren(page);
      for (const other of tabs.children) other.classList.toggle("chosen", other === tab);
      for (const frames of page.querySelectorAll(".frames")) frames.show();
    });
    tabs.append(tab);
    return tab;
  });
  pages[0].click();
  await showPlots(plots, runs, axis);
}

async function showPlots(container, runs, axis) {
  const choice = element("select", "", ...JOINTS.map((joint) => new Option(joint.replace("_", " "), joint, joint === "knee_pitch", joint === "knee_pitch")));
  const list = element("div", "");
  container.append(element("label", "joint", "joint ", choice), list);
  let plots = [];
  const fill = async () => {
    list.replaceChildren();
    plots = plotList(choice.value).map((described) => new TimePlot(list, described, runs, axis));
    for (const plot of plots.filter((plot) => plot.isEmpty)) plot.element.remove();
    plots = plots.filter((plot) => !plot.isEmpty);
    await Promise.all(plots.map((plot) => plot.open()));
  };
  choice.addEventListener("change", fill);
  addEventListener("resize", () => plots.forEach((plot) => plot.resize()));
  await fill();
}

/** @returns what is drawn now: the pose, and how high the soles' corners lie */
async function showScene(stage, runs, axis) {
  const shown = runs.filter((run) => run.model);
  if (shown.length === 0) {
    stage.append(element("p", "note", "No replay: this scenario's robot could not be described."));
    return { pose: () => null, cornerHeights: () => [] };
  }
  const canvas = element("div", "canvas");
  stage.append(canvas);
  const scene = new RobotScene(canvas, shown.map((run) => run.model));
  await Promise.all(shown.map(loadPoses));
  const layers = element("div", "layers", ...["robot", "ghost", "forces"].map((layer) => layerSwitch(scene, layer)));
  stage.append(layers, element("p", "note", "Blue ghost: joint references. Red: forces of the floor, 1 m for 1000 N, and the ZMP; green: support. Drag turns, wheel zooms. Values are rounded to 1/65534 of their column's range."));
  let poses = [];
  const show = () => {
    poses = shown.map((run) => poseAt(run, axis.time_s));
    poses.forEach((pose, number) => scene.setPose(number, pose));
    scene.render();
  };
  axis.on((what) => what === "time" && show());
  addEventListener("resize", () => scene.resize());
  show();
  scene.resize();
  return { pose: () => poses[0], cornerHeights: () => scene.cornerHeights_m() };
}

function layerSwitch(scene, layer) {
  const box = element("input");
  box.type = "checkbox";
  box.checked = true;
  box.addEventListener("change", () => scene.showLayer(layer, box.checked));
  return element("label", "", box, ` ${layer === "ghost" ? "references" : layer}`);
}

const opened = open();
window.surefoot = {
  ready: opened.then(() => true),
  setTime: async (time_s) => (await opened).axis.set(time_s),
  scenePose: async () => (await opened).drawn.pose(),
  cornerHeights: async () => (await opened).drawn.cornerHeights(),
};
opened.catch((error) => {
  document.getElementById("surefoot-app").append(element("p", "note", `This report cannot be shown: ${error.message}`));
  throw error;
});
