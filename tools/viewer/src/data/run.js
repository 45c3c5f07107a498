import { block, decodeColumn } from "./blocks.js";

/** A table of a recorded run: columns over one time, decoded when they are first asked for. */
export class Table {
  constructor(described, time_s) {
    this.name = described.name;
    this.rows = described.rows;
    this.time_s = time_s;
    this.described = new Map(described.columns.map((column) => [column.name, column]));
    this.decoded = new Map();
  }

  has(name) {
    return this.described.has(name);
  }

  /** Makes columns ready for `column`. @param {string[]} names */
  async load(names) {
    await Promise.all(
      names.filter((name) => this.has(name) && !this.decoded.has(name)).map(async (name) => {
        const column = this.described.get(name);
        this.decoded.set(name, decodeColumn(await block(column.block), column, this.rows));
      }),
    );
  }

  /** @returns {Float64Array} values of a loaded column */
  column(name) {
    return this.decoded.get(name);
  }

  label(name) {
    return this.described.get(name).label;
  }

  /** Row that holds at an instant: the last that is not later. */
  rowAt(time_s) {
    let low = 0;
    let high = this.rows - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.time_s[middle] <= time_s) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}

/** A recorded run. Tables: state, truth, and where there are some stabilizer, bus. */
export class Run {
  static async open(described) {
    const run = new Run();
    Object.assign(run, described);
    run.tables = new Map();
    for (const table of described.tables) {
      const time_s = decodeColumn(await block(table.time.block), table.time, table.rows);
      run.tables.set(table.name, new Table(table, time_s));
    }
    const time_s = run.tables.get("state").time_s;
    [run.from_s, run.to_s] = [time_s[0], time_s[time_s.length - 1]];
    return run;
  }

  table(name) {
    return this.tables.get(name) ?? null;
  }
}
