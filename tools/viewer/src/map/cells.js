/** Rows of a sweep, put into the cells of a grid over two of its keys. */

const MOST_PLACES = 24;

/**
 * Where a key's values stand on an axis: each value its own place, or, where numbers are too many, ranges of equal width.
 * @param {(number | string | null)[]} values  of all rows
 * @returns {{labels: string[], placeOf: (value: number | string | null) => number}}
 */
export function places(values) {
  const different = [...new Set(values)];
  const areNumbers = different.every((value) => typeof value === "number");
  if (areNumbers) different.sort((a, b) => a - b);
  if (!areNumbers || different.length <= MOST_PLACES) {
    const placeOf = new Map(different.map((value, place) => [value, place]));
    return { labels: different.map(text), placeOf: (value) => placeOf.get(value) };
  }
  const [low, high] = [different[0], different.at(-1)];
  const edge = (place) => low + ((high - low) * place) / MOST_PLACES;
  return {
    labels: Array.from({ length: MOST_PLACES }, (_, place) => text(Number(((edge(place) + edge(place + 1)) / 2).toPrecision(3)))),
    placeOf: (value) => Math.min(MOST_PLACES - 1, Math.floor(((value - low) / (high - low)) * MOST_PLACES)),
  };
}

/** A value for people: whole numbers as they are, others with six digits. */
export function text(value) {
  if (value === null || Number.isNaN(value)) return "–";
  if (Number.isInteger(value)) return String(value);
  return typeof value === "number" ? String(Number(value.toPrecision(6))) : value;
}

/**
 * @param {object[]} rows
 * @param {string | null} x  key along the columns; null: one column
 * @param {string | null} y  key along the lines
 * @returns {{columns: string[], lines: string[], at: (line: number, column: number) => object[]}}
 */
export function cells(rows, x, y) {
  const [columns, lines] = [x, y].map((key) => (key ? places(rows.map((row) => row[key])) : { labels: [""], placeOf: () => 0 }));
  const found = new Map();
  for (const row of rows) {
    const place = lines.placeOf(row[y]) * columns.labels.length + columns.placeOf(row[x]);
    found.set(place, [...(found.get(place) ?? []), row]);
  }
  return { columns: columns.labels, lines: lines.labels, at: (line, column) => found.get(line * columns.labels.length + column) ?? [] };
}
