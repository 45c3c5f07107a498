import assert from "node:assert/strict";
import test from "node:test";
import { GrowingTable } from "../../tools/viewer/src/live/growing_table.js";
import { LiveRun } from "../../tools/viewer/src/live/live_run.js";
import { TimeAxis } from "../../tools/viewer/src/time_axis.js";

const described = { name: "state", columns: [{ name: "a", label: "a" }, { name: "b", label: "b" }] };

test("a table keeps the newest rows, and at least half of what it can hold", () => {
  const table = new GrowingTable(described);
  for (let i = 0; i < 100_000; i++) {
    table.append(Float64Array.of(i / 60, i, -i));
    assert.equal(table.time_s.at(-1), i / 60);
  }
  assert.ok(table.rows >= 120 * 60 && table.rows <= 20_000, "two minutes, and no more than twice that");
  assert.equal(table.appended, 100_000);
  const row = table.rowAt(99_000 / 60);
  assert.deepEqual([table.column("a")[row], table.column("b")[row]], [99_000, -99_000]);
  assert.ok(table.time_s.every((time_s, i) => i === 0 || time_s > table.time_s[i - 1]));
});

test("rows that come late or twice are left out", () => {
  const table = new GrowingTable(described);
  for (const time_s of [1, 2, 2, 1.5, 3]) table.append(Float64Array.of(time_s, time_s, 0));
  assert.deepEqual([...table.time_s], [1, 2, 3]);
});

test("a clock that is set back begins the table anew", () => {
  const table = new GrowingTable(described);
  for (const time_s of [5, 6, -12, -11.9]) table.append(Float64Array.of(time_s, time_s, 0));
  assert.deepEqual([...table.time_s], [-12, -11.9]);
});

test("a row finds its table by its place; one of no table is left out", () => {
  const run = new LiveRun({ tables: [described, { ...described, name: "truth" }] });
  run.append(Float64Array.of(1, 0.5, 7, 8).buffer);
  run.append(Float64Array.of(9, 0.6, 7, 8).buffer);
  assert.equal(run.table("state").rows, 0);
  assert.equal(run.table("truth").column("b")[0], 8);
  assert.deepEqual([run.from_s, run.to_s, run.received], [0.5, 0.5, 1]);
});

test("the axis follows until somebody looks elsewhere", () => {
  const axis = new TimeAxis(0, 0.1, true);
  axis.grow(-12, 3);
  assert.deepEqual([axis.time_s, ...axis.range], [3, -9, 3]);
  axis.set(1);
  axis.grow(-12, 4);
  assert.deepEqual([axis.time_s, ...axis.range], [1, -9, 3]);
  axis.follow();
  assert.deepEqual([axis.time_s, ...axis.range], [4, -8, 4]);
});

test("nobody listens to an axis that was closed", () => {
  const axis = new TimeAxis(0, 1);
  let heard = 0;
  const stop = axis.on(() => heard++);
  axis.on(() => heard++);
  axis.set(0.5);
  stop();
  axis.set(0.6);
  axis.close();
  axis.set(0.7);
  assert.equal(heard, 3);
  assert.ok(axis.closed.aborted);
});
