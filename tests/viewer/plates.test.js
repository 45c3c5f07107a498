import assert from "node:assert/strict";
import test from "node:test";
import { piecesOnTiles } from "../../tools/viewer/src/scene/plates.js";

const tiles = { edge_m: 0.1, x0_m: -0.2, y0_m: -0.2, nx: 4, ny: 4, height_m: Array.from({ length: 16 }, (_, i) => i / 1000) };
const plate = { kind: "plate", centre_m: [0.01, -0.03], size_m: [0.12, 0.12], height_m: 0.004 };

test("a plate has a piece on each tile below it, and keeps its area", () => {
  const pieces = piecesOnTiles(plate, tiles);
  assert.equal(pieces.length, 4);
  const area = pieces.reduce((sum, { size_m }) => sum + size_m[0] * size_m[1], 0);
  assert.ok(Math.abs(area - 0.12 * 0.12) < 1e-12);
  for (const { centre_m, base_m } of pieces) {
    const [x, y] = centre_m.map((at, axis) => Math.floor((at - [tiles.x0_m, tiles.y0_m][axis]) / tiles.edge_m));
    assert.equal(base_m, tiles.height_m[4 * x + y]);
  }
});

test("on a smooth floor, and of other kinds, it is one piece on the floor", () => {
  assert.deepEqual(piecesOnTiles(plate, null), [{ ...plate, base_m: 0 }]);
  assert.equal(piecesOnTiles({ ...plate, kind: "ramp" }, tiles).length, 1);
});
