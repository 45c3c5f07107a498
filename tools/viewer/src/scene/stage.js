import { element } from "../pages/element.js";
import { loadPoses, poseAt } from "./poses.js";
import { RobotScene } from "./robot_scene.js";

const LAYERS = { robot: "robot", ghost: "references", forces: "forces" };
const LEGEND =
  "Blue lines: joint references. Red: forces of the floor, 1 m for 1000 N, and the ZMP; green: support; orange: a push. " +
  "Drag turns, wheel zooms.";
const ROUNDED = " Values are rounded to 1/65534 of their column's range.";

const NOTHING = { pose: () => null, cornerHeights: () => [], soles: () => [], close: () => {} };

/**
 * The replay of the runs whose robot is known.
 * @returns what is drawn now: the pose, how high the soles' corners lie, where the soles are; and `close`
 */
export async function showStage(stage, runs, axis) {
  const shown = runs.filter((run) => run.model);
  if (shown.length === 0) {
    stage.append(element("p", "note", "No replay: this run's scenario.toml is missing or of another version, so its robot is not known."));
    return NOTHING;
  }
  const canvas = element("div", "canvas");
  const layers = element("div", "layers");
  stage.append(canvas, layers, element("p", "note", LEGEND + (axis.isLive ? "" : ROUNDED)));
  const scene = sceneOf(canvas, shown.map((run) => run.model));
  if (!scene) {
    stage.replaceChildren(element("p", "note", "No replay: this browser gives no WebGL."));
    return NOTHING;
  }
  layers.append(...Object.entries(LAYERS).map(([layer, name]) => layerSwitch(scene, layer, name)));
  await Promise.all(shown.map(loadPoses));
  let poses = [];
  const show = () => {
    poses = shown.map((run) => poseAt(run, axis.time_s));
    poses.forEach((pose, number) => pose && scene.setPose(number, pose));
    scene.render();
  };
  axis.on((what) => what === "time" && show());
  const sized = new ResizeObserver(() => scene.resize());
  sized.observe(canvas);
  show();
  scene.resize();
  return { pose: () => poses[0], cornerHeights: () => scene.cornerHeights_m(), soles: () => scene.soles_m(), close: () => closeAll(sized, scene) };
}

function closeAll(sized, scene) {
  sized.disconnect();
  scene.close();
}

function sceneOf(canvas, models) {
  try {
    return new RobotScene(canvas, models);
  } catch (error) {
    console.warn(error);
    return null;
  }
}

function layerSwitch(scene, layer, name) {
  const box = element("input");
  box.type = "checkbox";
  box.checked = true;
  box.addEventListener("change", () => scene.showLayer(layer, box.checked));
  return element("label", "", box, ` ${name}`);
}
