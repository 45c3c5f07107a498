/** Compressed arrays of the page. The other half is tools/report/blocks.py. */

const NOT_A_NUMBER = -32768;
const inflated = new Map();

/** @returns {Promise<Uint8Array>} content of a block; inflated once. */
export function block(id) {
  if (!inflated.has(id)) {
    const element = document.getElementById(`surefoot-block-${id}`);
    if (!element) return Promise.reject(new Error(`block ${id} is missing: the file was cut short`));
    inflated.set(id, inflate(fromBase64(element.textContent)));
  }
  return inflated.get(id);
}

function fromBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** @param {Uint8Array} bytes gzip  @returns {Promise<Uint8Array>} */
export async function inflate(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/**
 * Sums up differences that are stored in planes of bytes, lowest first.
 * @param {Uint8Array} bytes  content of the block
 * @param {{type: string, scale: number, offset: number, from_byte: number}} column
 * @param {number} rows
 * @returns {Float64Array} code * scale + offset; NaN where there was no number
 */
export function decodeColumn(bytes, column, rows) {
  const planes = column.type === "i16" ? 2 : 4;
  const values = new Float64Array(rows);
  let code = 0;
  for (let row = 0; row < rows; row++) {
    let step = 0;
    for (let plane = 0; plane < planes; plane++) step |= bytes[column.from_byte + plane * rows + row] << (8 * plane);
    code = planes === 2 ? ((code + step) << 16) >> 16 : (code + step) | 0;
    const isNumber = planes !== 2 || code !== NOT_A_NUMBER;
    values[row] = isNumber ? code * column.scale + column.offset : NaN;
  }
  return values;
}
