import * as THREE from "three";

const M_PER_N = 0.002;
const AFTERGLOW_S = 0.1; // pushes are short: they stay for a few pictures of a replay in real time

/** A push on the trunk as an arrow that ends where it pushes, while it lasts. */
export class Push {
  /** @param {{at_s: number, duration_s: number, force_world_n: number[], point_body_m: number[]}} push */
  constructor({ at_s, duration_s, force_world_n, point_body_m }) {
    const force = new THREE.Vector3(...force_world_n);
    this.length_m = Math.max(0.05, force.length() * M_PER_N);
    this.direction = force.normalize();
    this.point = new THREE.Vector3(...point_body_m);
    [this.from_s, this.to_s] = [at_s, at_s + duration_s + AFTERGLOW_S];
    this.object = new THREE.ArrowHelper(this.direction, new THREE.Vector3(), this.length_m, 0xe07b39, 0.06, 0.04);
    for (const part of [this.object.line, this.object.cone]) part.material.depthTest = false; // it begins inside the trunk
    this.object.visible = false;
  }

  /** @param {import("./robot.js").Robot} robot already posed */
  set(robot, time_s) {
    this.object.visible = time_s >= this.from_s && time_s < this.to_s;
    if (!this.object.visible) return;
    const pushed = robot.object.localToWorld(this.point.clone());
    this.object.position.copy(pushed.addScaledVector(this.direction, -this.length_m));
  }
}
