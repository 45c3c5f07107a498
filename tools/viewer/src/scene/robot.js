import * as THREE from "three";
import URDFLoader from "urdf-loader";

/** A robot of a URDF text, posed by body place, z-y-x angles and joint angles. */
export class Robot {
  /**
   * @param {object} model  of `surefoot model --json`
   * @param {{colour?: number, opacity?: number, isOutline?: boolean}} look  without it the URDF's own colours; an
   *   outline shows through what it coincides with
   */
  constructor(model, look = {}) {
    this.names = model.joint_names;
    this.object = new URDFLoader().parse(model.urdf);
    this.object.rotation.order = "ZYX";
    for (const joint of Object.values(this.object.joints)) joint.ignoreLimits = true; // a fall is drawn as it was
    const meshes = [];
    this.object.traverse((node) => node.isMesh && meshes.push(node));
    for (const mesh of meshes) {
      mesh.castShadow = !look.opacity;
      if (look.isOutline) outline(mesh, look);
      else if (look.opacity) mesh.material = new THREE.MeshLambertMaterial({ color: look.colour, transparent: true, opacity: look.opacity });
    }
    this.soles = model.foot_links.map((name) => this.object.links[name]);
  }

  setPose(pose, joint_rad) {
    this.object.position.set(...pose.position_world_m);
    this.object.rotation.set(pose.roll_rad, pose.pitch_rad, pose.yaw_rad);
    this.names.forEach((name, i) => this.object.joints[name].setJointValue(joint_rad[i]));
    this.object.updateMatrixWorld(true);
  }

  /** A point of a foot frame in the world. @param {0 | 1} side right, left */
  solePoint(side, point_m) {
    return this.soles[side].localToWorld(new THREE.Vector3(...point_m));
  }
}

function outline(mesh, { colour, opacity }) {
  const material = new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity, depthTest: false });
  mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 25), material));
  mesh.material = new THREE.MeshBasicMaterial({ visible: false });
}
