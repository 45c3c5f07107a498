import assert from "node:assert/strict";
import test from "node:test";
import { decodeFrame, rawValue } from "../../tools/viewer/src/data/frames.js";

const signal = (start, length, byte_order, is_signed = false) => ({ start, length, byte_order, is_signed });

// Vector's DBC: a little endian signal begins at its lowest bit, a big endian one at its highest.
test("little endian signals cross bytes upwards", () => {
  assert.equal(rawValue([0x34, 0x12], signal(0, 16, "little_endian")), 0x1234n);
  assert.equal(rawValue([0xf0, 0x0a], signal(4, 8, "little_endian")), 0xafn);
});

test("big endian signals cross bytes from the highest bit down", () => {
  assert.equal(rawValue([0x12, 0x34], signal(7, 16, "big_endian")), 0x1234n);
  assert.equal(rawValue([0x0f, 0xa0], signal(3, 8, "big_endian")), 0xfan);
});

test("signed signals are two's complement of their own length", () => {
  assert.equal(rawValue([0xff, 0x0f], signal(0, 12, "little_endian", true)), -1n);
  assert.equal(rawValue([0x00, 0x08], signal(0, 12, "little_endian", true)), -2048n);
});

test("64 bits keep every bit", () => {
  const bytes = [0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07, 0xf8];
  assert.equal(rawValue(bytes, signal(0, 64, "little_endian")), 0xf807060504030201n);
});

test("a frame that was cut short shows no signals", () => {
  const message = { length: 8, signals: [{ ...signal(0, 8, "little_endian"), name: "x", scale: 1, offset: 0, unit: "" }] };
  assert.deepEqual(decodeFrame(new Uint8Array(4), message), []);
  assert.equal(decodeFrame(new Uint8Array([7, 0, 0, 0, 0, 0, 0, 0]), message)[0].value, 7);
});
