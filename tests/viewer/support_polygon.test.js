import assert from "node:assert/strict";
import test from "node:test";
import { convexHull } from "../../tools/viewer/src/scene/support_polygon.js";

test("the hull of two soles leaves out the corners between them", () => {
  const right = [[0, -2, 0], [3, -2, 0], [0, -1, 0], [3, -1, 0]];
  const left = [[1, 1, 0], [4, 1, 0], [1, 2, 0], [4, 2, 0]];
  const hull = convexHull([...right, ...left]).map(([x, y]) => `${x},${y}`);
  assert.deepEqual(hull, ["0,-2", "3,-2", "4,1", "4,2", "1,2", "0,-1"]);
});

test("fewer than three corners, or all on one line, support no area", () => {
  assert.equal(convexHull([]).length, 0);
  assert.equal(convexHull([[1, 1, 0]]).length, 1);
  assert.equal(convexHull([[0, 0, 0], [1, 1, 0], [2, 2, 0]]).length, 2);
});
