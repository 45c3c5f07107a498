/**
 * The least and the largest value of each of some equal parts of a range, in the order in which they occur: what a plot
 * of so many pixels shows of a million points, spikes of one tick included.
 *
 * @param {Float64Array} time_s  ascending
 * @param {Float64Array[]} series
 * @param {number} from_s
 * @param {number} to_s
 * @param {number} parts  about one for each pixel
 * @returns {[number[], ...number[][]]} times and values; all points where there are few
 */
export function decimate(time_s, series, from_s, to_s, parts) {
  const first = Math.max(0, lowerBound(time_s, from_s) - 1);
  const last = Math.min(time_s.length, lowerBound(time_s, to_s) + 2);
  if (last - first <= 2 * parts) {
    return [Array.from(time_s.subarray(first, last)), ...series.map((values) => Array.from(values.subarray(first, last)))];
  }
  const times = [];
  const shown = series.map(() => []);
  for (let part = 0; part < parts; part++) {
    const begin = first + Math.floor(((last - first) * part) / parts);
    const end = first + Math.floor(((last - first) * (part + 1)) / parts);
    times.push(time_s[begin], time_s[end - 1]);
    series.forEach((values, i) => shown[i].push(...extremes(values, begin, end)));
  }
  return [times, ...shown];
}

function extremes(values, begin, end) {
  let least = begin;
  let largest = begin;
  for (let i = begin; i < end; i++) {
    if (values[i] < values[least] || Number.isNaN(values[least])) least = i;
    if (values[i] > values[largest] || Number.isNaN(values[largest])) largest = i;
  }
  return least < largest ? [values[least], values[largest]] : [values[largest], values[least]];
}

/** Index of the first value that is not below the wanted one. */
export function lowerBound(sorted, wanted) {
  let low = 0;
  let high = sorted.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sorted[middle] < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}
