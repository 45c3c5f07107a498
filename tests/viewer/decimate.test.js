import assert from "node:assert/strict";
import test from "node:test";
import { decimate, lowerBound } from "../../tools/viewer/src/data/decimate.js";

const times = Float64Array.from({ length: 10_000 }, (_, i) => i / 1000);

test("a spike of one sample survives any number of parts", () => {
  const values = new Float64Array(times.length);
  values[7123] = 5;
  values[3001] = -4;
  for (const parts of [1, 7, 100, 999]) {
    const [shown_s, shown] = decimate(times, [values], 0, 10, parts);
    assert.equal(Math.max(...shown), 5);
    assert.equal(Math.min(...shown), -4);
    assert.equal(shown_s.length, shown.length);
    assert.ok(shown_s.every((time_s, i) => i === 0 || time_s >= shown_s[i - 1]));
  }
});

test("few points are shown as they are, with one more on either side", () => {
  const [shown_s, shown] = decimate(times, [times], 2, 2.01, 100);
  assert.deepEqual([shown_s[0], shown_s.at(-1)], [1.999, 2.011]);
  assert.deepEqual(shown, shown_s);
});

test("the lower bound is the first place that is not below", () => {
  assert.equal(lowerBound([1, 2, 2, 3], 2), 1);
  assert.equal(lowerBound([1, 2], 9), 2);
  assert.equal(lowerBound([], 1), 0);
});
