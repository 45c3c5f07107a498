import assert from "node:assert/strict";
import test from "node:test";
import { cells, places } from "../../tools/viewer/src/map/cells.js";

test("few values have a place each, in the order of numbers", () => {
  const { labels, placeOf } = places([0.4, 0.09, 0.11, 0.09]);
  assert.deepEqual(labels, ["0.09", "0.11", "0.4"]);
  assert.deepEqual([0.09, 0.11, 0.4].map(placeOf), [0, 1, 2]);
});

test("texts and none keep the order in which they come", () => {
  assert.deepEqual(places(["off", "capture", null]).labels, ["off", "capture", "–"]);
});

test("many numbers share ranges, each in exactly one, the ends included", () => {
  const values = Array.from({ length: 500 }, (_, i) => Math.sin(i));
  const { labels, placeOf } = places(values);
  const found = values.map(placeOf);
  assert.equal(labels.length, 24);
  assert.deepEqual([Math.min(...found), Math.max(...found)], [0, 23]);
  values.forEach((value, i) => assert.ok(Math.abs(Number(labels[found[i]]) - value) < 2 / 24 / 2 + 0.01));
});

test("every row is in one cell", () => {
  const rows = Array.from({ length: 60 }, (_, row) => ({ row, x: row % 3, y: row % 4 }));
  const found = cells(rows, "x", "y");
  const seen = found.lines.flatMap((_, line) => found.columns.flatMap((_, column) => found.at(line, column)));
  assert.deepEqual(seen.map(({ row }) => row).sort((a, b) => a - b), rows.map(({ row }) => row));
  assert.ok(found.at(1, 2).every(({ x, y }) => x === 2 && y === 1));
  assert.equal(cells(rows, "x", null).at(0, 0).length, 20);
});
