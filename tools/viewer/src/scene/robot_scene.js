import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { floorObject } from "./floor.js";
import { Forces } from "./forces.js";
import { Push } from "./push.js";
import { Robot } from "./robot.js";

const FORCE_COLOURS = [0xd8432f, 0xb05cc4];
const GHOST = { colour: 0x2f7ed8, opacity: 0.75, isOutline: true };
const OTHER_RUN = { colour: 0xb05cc4, opacity: 0.45 };
const GHOST_OF_OTHER = { colour: 0xb05cc4, opacity: 0.35, isOutline: true };

/** Robots on their floor in the world frame, z up. The floor is that of the first model. */
export class RobotScene {
  /**
   * @param {HTMLElement} container
   * @param {object[]} models  one or two, of `surefoot model --json`; the second robot is drawn translucent
   */
  constructor(container, models) {
    THREE.Object3D.DEFAULT_UP.set(0, 0, 1);
    this.container = container;
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(dark ? 0x1b2026 : 0xeef2f5);
    this.renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.shadowMap.enabled = true;
    container.append(this.renderer.domElement);
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.2, 60);
    this.camera.position.set(1.5, -2.2, 1.1);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.target.set(0, 0, 0.52);
    this.controls.addEventListener("change", () => this.render());
    this.light();
    this.gravity = gravityArrow(models[0].floor);
    this.scene.add(floorObject(models[0].floor, dark), this.gravity);
    this.actors = models.map((model, number) => this.actor(model, number));
    this.followed = null;
  }

  light() {
    this.sun = new THREE.DirectionalLight(0xffffff, 2.2);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(1024, 1024);
    Object.assign(this.sun.shadow.camera, { left: -1.5, right: 1.5, top: 1.5, bottom: -1.5, near: 0.5, far: 8 });
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a94a0, 1.6), this.sun, this.sun.target);
  }

  actor(model, number) {
    const actor = {
      model, robot: new Robot(model, number === 0 ? {} : OTHER_RUN), ghost: new Robot(model, number === 0 ? GHOST : GHOST_OF_OTHER),
      forces: new Forces(FORCE_COLOURS[number]), payloads: model.payloads.map((payload) => payloadBox(payload, number === 0 ? 1 : OTHER_RUN.opacity)),
    };
    actor.pushes = (model.pushes ?? []).map((push) => new Push(push));
    actor.payloads.forEach((box) => actor.robot.object.add(box));
    this.scene.add(...actor.pushes.map((push) => push.object), actor.robot.object, actor.ghost.object, actor.forces.object);
    return actor;
  }

  /** @param {"robot" | "ghost" | "forces"} layer */
  showLayer(layer, isShown) {
    for (const actor of this.actors) {
      if (layer === "ghost") actor.ghost.object.visible = isShown;
      if (layer === "forces") actor.forces.object.visible = isShown;
      if (layer === "robot") actor.robot.object.visible = isShown;
    }
    this.render();
  }

  /**
   * @param {number} number  of the run
   * @param {{time_s: number, position_world_m: number[], roll_rad: number, pitch_rad: number, yaw_rad: number,
   *   joint_rad: number[], reference_rad: number[], corner_force_n: number[]}} pose
   */
  setPose(number, pose) {
    const { model, robot, ghost, forces, payloads, pushes } = this.actors[number];
    robot.setPose(pose, pose.joint_rad);
    ghost.setPose(pose, pose.reference_rad);
    forces.set(robot, model.sole_corners_foot_m, pose);
    for (const push of pushes) push.set(robot, pose.time_s);
    model.payloads.forEach(({ at_s, removed_at_s }, i) => {
      payloads[i].visible = pose.time_s >= at_s && (removed_at_s === null || pose.time_s < removed_at_s);
    });
    if (number === 0) this.follow(new THREE.Vector3(...pose.position_world_m));
  }

  follow(body) {
    const step = this.followed ? body.clone().sub(this.followed) : body.clone().setZ(0);
    step.z = 0;
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.sun.position.set(body.x + 1.2, body.y - 1.4, 3.2);
    this.sun.target.position.set(body.x, body.y, 0.4);
    this.camera.lookAt(this.controls.target);
    this.gravity.position.set(body.x, body.y, 0);
    this.followed = body;
  }

  /** Heights of the first robot's eight sole corners, as drawn. */
  cornerHeights_m() {
    const { model, robot } = this.actors[0];
    return [0, 1].flatMap((side) => model.sole_corners_foot_m.map((corner_m) => robot.solePoint(side, corner_m).z));
  }

  /** Where the first robot's foot frames lie in the world, as drawn: right, left. */
  soles_m() {
    return [0, 1].map((side) => this.actors[0].robot.solePoint(side, [0, 0, 0]).toArray());
  }

  render() {
    this.renderer.render(this.scene, this.camera);
  }

  /** Gives the graphics context back: browsers have few. */
  close() {
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  resize() {
    const { clientWidth: width_px, clientHeight: height_px } = this.container;
    if (width_px === 0 || height_px === 0) return;
    this.renderer.setSize(width_px, height_px);
    this.camera.aspect = width_px / height_px;
    this.camera.updateProjectionMatrix();
    this.render();
  }
}

function payloadBox({ position_body_m, edge_m }, opacity) {
  const box = new THREE.Mesh(new THREE.BoxGeometry(edge_m, edge_m, edge_m), new THREE.MeshLambertMaterial({ color: 0x9c5b2e, transparent: opacity < 1, opacity }));
  box.position.set(...position_body_m);
  box.castShadow = true;
  return box;
}

/** On a slope, which the world frame leans with, the way down. */
function gravityArrow(floor) {
  const group = new THREE.Group();
  if (floor.slope_roll_deg === 0 && floor.slope_pitch_deg === 0) return group;
  const down = new THREE.Vector3(...floor.gravity_world_m_s2).normalize();
  group.add(new THREE.ArrowHelper(down, new THREE.Vector3(-0.5, 0, 1), 0.35, 0x667788, 0.08, 0.05));
  return group;
}
