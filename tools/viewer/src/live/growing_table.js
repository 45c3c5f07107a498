const MOST_ROWS = 16384; // two minutes at 60 a second are left when half of them is forgotten
const CLOCK_BACK_S = 1; // more than messages ever overtake one another

/** A table that grows by a row at a time and forgets its oldest half when it is full. The interface of data/run.js. */
export class GrowingTable {
  /** @param {{name: string, columns: {name: string, label: string}[]}} described */
  constructor(described) {
    this.name = described.name;
    this.described = new Map(described.columns.map((column, i) => [column.name, { ...column, i }]));
    this.rows = 0;
    this.appended = 0;
    this.times = new Float64Array(MOST_ROWS);
    this.values = described.columns.map(() => new Float64Array(MOST_ROWS));
  }

  get time_s() {
    return this.times.subarray(0, this.rows);
  }

  has(name) {
    return this.described.has(name);
  }

  async load() {}

  column(name) {
    return this.values[this.described.get(name).i].subarray(0, this.rows);
  }

  label(name) {
    return this.described.get(name).label;
  }

  /**
   * Rows that are no later than the last are left out; a clock that is set back (firmware that powers up anew) begins anew.
   * @param {Float64Array} row  time, then a value a column
   */
  append(row) {
    if (this.rows > 0 && row[0] < this.times[this.rows - 1] - CLOCK_BACK_S) this.rows = 0;
    if (this.rows > 0 && row[0] <= this.times[this.rows - 1]) return;
    if (this.rows === MOST_ROWS) this.forget(MOST_ROWS / 2);
    this.times[this.rows] = row[0];
    for (let i = 0; i < this.values.length; i++) this.values[i][this.rows] = row[i + 1];
    this.rows++;
    this.appended++;
  }

  forget(count) {
    for (const values of [this.times, ...this.values]) values.copyWithin(0, count, this.rows);
    this.rows -= count;
  }

  /** Row that holds at an instant: the last that is not later. */
  rowAt(time_s) {
    return lastNotLater(this.times, this.rows, time_s);
  }
}

function lastNotLater(times, rows, time_s) {
  let low = 0;
  let high = Math.max(0, rows - 1);
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time_s) low = middle;
    else high = middle - 1;
  }
  return low;
}
