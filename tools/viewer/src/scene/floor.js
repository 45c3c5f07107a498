import * as THREE from "three";
import { piecesOnTiles } from "./plates.js";

const SLAB_M = 0.02;
const GRID_M = 0.5;
const GRID_HALF = 40;

/** The floor as boxes: tiles in one draw call, plates, patches; a plane with a grid of 0.5 m where it is smooth. */
export function floorObject(floor, dark) {
  const group = new THREE.Group();
  const colour = dark ? 0x39424c : 0xd7dde3;
  if (floor.tiles) group.add(tiles(floor.tiles, colour));
  else group.add(plane(colour));
  group.add(grid(dark ? 0x55606c : 0xb3bcc5, floor.tiles ? -0.002 : 0.002));
  for (const plate of floor.plates.flatMap((plate) => piecesOnTiles(plate, floor.tiles))) group.add(patch(plate));
  return group;
}

/** Lines every half metre. In short pieces: some renderers drop a line that goes on behind the camera. */
function grid(colour, z_m) {
  const points = [];
  for (let i = -GRID_HALF; i <= GRID_HALF; i++) {
    for (let k = -GRID_HALF; k < GRID_HALF; k++) {
      const [line, from, to] = [i, k, k + 1].map((steps) => steps * GRID_M);
      points.push(line, from, z_m, line, to, z_m, from, line, z_m, to, line, z_m);
    }
  }
  const geometry = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(points, 3));
  return new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: colour }));
}

function plane(colour) {
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(40, 40), new THREE.MeshLambertMaterial({ color: colour }));
  mesh.position.z = -0.001;
  mesh.receiveShadow = true;
  return mesh;
}

/** Height shows as brightness too, for millimetres are hard to see. */
function tiles({ edge_m, x0_m, y0_m, nx, ny, height_m }, colour) {
  const mesh = new THREE.InstancedMesh(
    new THREE.BoxGeometry(edge_m * 0.97, edge_m * 0.97, 1), new THREE.MeshLambertMaterial(), nx * ny,
  );
  const highest_m = height_m.reduce((a, b) => Math.max(a, b), 1e-9);
  const base = new THREE.Color(colour);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < nx * ny; i++) {
    const top_m = height_m[i];
    matrix.makeScale(1, 1, top_m + SLAB_M);
    matrix.setPosition(x0_m + edge_m * (Math.floor(i / ny) + 0.5), y0_m + edge_m * ((i % ny) + 0.5), (top_m - SLAB_M) / 2);
    mesh.setMatrixAt(i, matrix);
    mesh.setColorAt(i, base.clone().multiplyScalar(0.72 + 0.34 * (top_m / highest_m)));
  }
  mesh.receiveShadow = true;
  return mesh;
}

function patch({ kind, centre_m, size_m, height_m, base_m }) {
  const thick_m = Math.max(height_m, 0.001);
  const material = new THREE.MeshLambertMaterial({ color: kind === "friction" ? 0x6aa5c9 : 0x8f9a58 });
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(size_m[0], size_m[1], thick_m), material);
  mesh.position.set(centre_m[0], centre_m[1], base_m + thick_m / 2);
  if (kind === "ramp") {
    mesh.rotation.y = -Math.atan2(height_m, size_m[0]);
    mesh.position.z = 0;
  }
  mesh.receiveShadow = true;
  return mesh;
}
