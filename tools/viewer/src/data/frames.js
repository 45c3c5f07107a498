import { block } from "./blocks.js";

/** CAN frames of a run: a second at a time, decoded by the DBC's messages. */
export class Frames {
  constructor(described) {
    this.chunks = described.chunks;
    this.messages = new Map(described.messages.map((message) => [message.id, message]));
    this.opened = new Map();
  }

  /** @returns {Promise<{time_s: number, id: number, data: Uint8Array}[]>} frames of a range, in the order of time */
  async between(from_s, to_s) {
    const chunks = this.chunks.filter((chunk) => chunk.from_s < to_s && chunk.to_s > from_s);
    const frames = (await Promise.all(chunks.map((chunk) => this.open(chunk)))).flat();
    return frames.filter((frame) => frame.time_s >= from_s && frame.time_s < to_s).sort((a, b) => a.time_s - b.time_s);
  }

  async open(chunk) {
    if (!this.opened.has(chunk.block)) {
      if (this.opened.size > 4) this.opened.clear();
      this.opened.set(chunk.block, readChunk(await block(chunk.block), Math.round(chunk.from_s * 1e6)));
    }
    return this.opened.get(chunk.block);
  }
}

/** Number of frames, then of all frames time step, identifier and length, then all payloads (tools/report/pack_run.py). */
export function readChunk(bytes, from_us = 0) {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const count = view.getUint32(0, true);
  const [times, ids, lengths] = [4, 4 + 4 * count, 4 + 6 * count];
  let at = 4 + 7 * count;
  let time_us = from_us;
  const frames = [];
  for (let i = 0; i < count; i++) {
    time_us += view.getInt32(times + 4 * i, true);
    const length = bytes[lengths + i];
    frames.push({ time_s: time_us / 1e6, id: view.getUint16(ids + 2 * i, true), data: bytes.subarray(at, at + length) });
    at += length;
  }
  return frames;
}

/**
 * Raw value of a signal. Start bits count as in DBC files: of the lowest bit for little endian, of the highest for big.
 * @returns {bigint}
 */
export function rawValue(data, signal) {
  let value = 0n;
  let bit = signal.start;
  for (let i = 0; i < signal.length; i++) {
    const isSet = BigInt((data[bit >> 3] >> (bit & 7)) & 1);
    if (signal.byte_order === "little_endian") {
      value |= isSet << BigInt(i);
      bit += 1;
    } else {
      value = (value << 1n) | isSet;
      bit += (bit & 7) === 0 ? 15 : -1;
    }
  }
  return signal.is_signed ? BigInt.asIntN(signal.length, value) : value;
}

/** @returns {{name: string, value: number, text: string, unit: string}[]} signals of a frame; none of a cut one */
export function decodeFrame(data, message) {
  if (data.length < message.length) return [];
  return message.signals.map((signal) => {
    const raw = rawValue(data, signal);
    const value = Number(raw) * signal.scale + signal.offset;
    const digits = Math.max(0, Math.min(9, Math.ceil(-Math.log10(signal.scale))));
    const text = signal.choices?.[raw.toString()] ?? value.toFixed(digits);
    return { name: signal.name, value, text, unit: signal.unit };
  });
}
