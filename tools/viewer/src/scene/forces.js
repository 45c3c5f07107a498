import * as THREE from "three";
import { convexHull } from "./support_polygon.js";

const M_PER_N = 0.001;
const CARRIES_N = 1.0;
const ABOVE_FLOOR_M = 0.004;

/** Forces on the soles' corners as arrows, the polygon that supports, and the ZMP. */
export class Forces {
  constructor(colour) {
    this.object = new THREE.Group();
    const up = new THREE.Vector3(0, 0, 1);
    this.arrows = Array.from({ length: 8 }, () => new THREE.ArrowHelper(up, new THREE.Vector3(), 0.1, colour, 0.03, 0.02));
    this.polygon = new THREE.Mesh(
      new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ color: 0x3aa655, transparent: true, opacity: 0.45, side: THREE.DoubleSide }),
    );
    this.zmp = new THREE.Mesh(new THREE.SphereGeometry(0.014, 16, 12), new THREE.MeshBasicMaterial({ color: colour }));
    this.object.add(...this.arrows, this.polygon, this.zmp);
  }

  /** @param {import("./robot.js").Robot} robot already posed */
  set(robot, corners_m, pose) {
    const carrying = [];
    const centre = new THREE.Vector3();
    let sum_n = 0;
    this.arrows.forEach((arrow, i) => {
      const force_n = pose.corner_force_n[i];
      arrow.visible = force_n > CARRIES_N;
      if (!arrow.visible) return;
      const point = robot.solePoint(Math.floor(i / 4), corners_m[i % 4]);
      arrow.position.copy(point);
      arrow.setLength(Math.max(0.02, force_n * M_PER_N), 0.03, 0.02);
      carrying.push([point.x, point.y, point.z]);
      centre.addScaledVector(point, force_n);
      sum_n += force_n;
    });
    this.showPolygon(convexHull(carrying));
    this.zmp.visible = sum_n > 0; // where the floor's forces have no moment: their weighted middle
    if (this.zmp.visible) this.zmp.position.copy(centre.divideScalar(sum_n));
  }

  showPolygon(hull) {
    this.polygon.visible = hull.length > 2;
    if (!this.polygon.visible) return;
    const points = hull.map(([x, y, z]) => new THREE.Vector3(x, y, z + ABOVE_FLOOR_M));
    this.polygon.geometry.dispose();
    this.polygon.geometry = new THREE.BufferGeometry().setFromPoints(points);
    this.polygon.geometry.setIndex(points.slice(2).flatMap((_, i) => [0, i + 1, i + 2]));
  }
}
