import { GrowingTable } from "./growing_table.js";

const HEAD = 2; // numbers before the values of a row: place of the table, time

/** A run that is going on. The interface of data/run.js; tables grow by what `surefoot watch` sends. */
export class LiveRun {
  /** @param {object} described  of the message "run" (tools/watch/live_run.py) */
  constructor(described) {
    Object.assign(this, described, { is_live: true });
    this.order = described.tables.map((table) => new GrowingTable(table));
    this.tables = new Map(this.order.map((table) => [table.name, table]));
  }

  table(name) {
    return this.tables.get(name) ?? null;
  }

  /** Rows so far of the table that has most. */
  get received() {
    return Math.max(...this.order.map((table) => table.appended));
  }

  get from_s() {
    return Math.min(...this.times((table) => table.times[0]));
  }

  get to_s() {
    return Math.max(...this.times((table) => table.times[table.rows - 1]));
  }

  times(which) {
    return this.order.filter((table) => table.rows > 0).map(which);
  }

  /** @param {ArrayBuffer} content  place of the table, time in s, values, as float64 in the browser's order */
  append(content) {
    const numbers = new Float64Array(content);
    this.order[numbers[0]]?.append(numbers.subarray(HEAD - 1));
  }
}
