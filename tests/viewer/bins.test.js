import assert from "node:assert/strict";
import test from "node:test";
import { withEmptyBins } from "../../tools/viewer/src/data/bins.js";

test("what is missing between two bins is filled with empty ones that join them", () => {
  const bins = withEmptyBins([[1, 1.25, 5], [4, 5, 1], [5, 6, 2]]);
  assert.equal(bins.reduce((sum, [, , count]) => sum + count, 0), 8);
  bins.slice(1).forEach(([from_us], i) => assert.ok(Math.abs(from_us - bins[i][1]) < 1e-9));
  assert.equal(bins.filter(([, , count]) => count === 0).length, 7);
});
