import * as THREE from "three";
import URDFLoader from "urdf-loader";

/** A robot of a URDF text, posed by body place, z-y-x angles and joint angles. */
export class Robot {
  /**
   * @param {object} model  of `surefoot model --json`
   * @param {{colour?: number, opacity?: number}} look  of a ghost; without it the URDF's own colours
   */
  constructor(model, look = {}) {
    this.names = model.joint_names;
    this.object = new URDFLoader().parse(model.urdf);
    this.object.rotation.order = "ZYX";
    this.object.traverse((node) => {
      if (!node.isMesh) return;
      node.castShadow = !look.opacity;
      if (look.opacity) {
        node.material = new THREE.MeshBasicMaterial({
          color: look.colour, transparent: true, opacity: look.opacity, depthWrite: false,
          polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2, // behind what it coincides with
        });
      }
    });
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
