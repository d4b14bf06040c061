// SPDX-License-Identifier: BSD-3-Clause
// A small film is encoded by the words of src/data.ts, and must come back exactly.
import assert from "node:assert/strict";
import { test } from "node:test";
import { decode_outline, decode_places, decode_sizes, decode_triangles, decode_values } from "../src/film_decode";

const frames = 3;
const count = 4;

/** Changes modulo 2^16 as the contract folds them: 0, -1, 1, -2, ... are 0, 1, 2, 3, ... */
function folded(change: number): number {
  const around = ((((change + 32768) % 65536) + 65536) % 65536) - 32768;
  return around >= 0 ? 2 * around : -2 * around - 1;
}

test("positions_come_back_exactly", () => {
  // Frame, point, axis: ends of the range, steps up and down, and one over the end of 16 bits.
  const codes = [
    [[0, 65535], [1000, 2000], [255, 256], [40000, 7]],
    [[1, 65534], [999, 2001], [511, 0], [40000, 7]],
    [[65535, 0], [0, 65535], [32767, 32768], [7232, 32775]],
  ];
  const planes: number[][] = [[], [], [], []];
  for (let frame = 0; frame < frames; frame++) {
    for (let p = 0; p < count; p++) {
      for (const axis of [0, 1]) {
        const now = codes[frame][p][axis];
        const stored = frame === 0 ? now : folded(now - codes[frame - 1][p][axis]);
        planes[2 * axis].push(stored & 255);
        planes[2 * axis + 1].push(stored >> 8);
      }
    }
  }
  const places = decode_places(Uint8Array.from(planes.flat()), frames, count);
  assert.deepEqual(places.map((frame) => [...frame]), codes.map((frame) => frame.flat()));
});

test("values_come_back_exactly", () => {
  const values = [[0, 255, 128, 3], [255, 0, 128, 2], [254, 1, 0, 200]];
  const bytes = values.flatMap((frame, f) => frame.map((value, p) => (f === 0 ? value : (value - values[f - 1][p] + 256) % 256)));
  assert.deepEqual(decode_values(Uint8Array.from(bytes), frames, count).map((frame) => [...frame]), values);
});

test("sizes_and_triangles_are_little_endian", () => {
  assert.deepEqual([...decode_sizes(Uint8Array.of(1, 0, 0, 1, 255, 255, 2, 3), count)], [1, 256, 65535, 770]);
  assert.deepEqual([...decode_triangles(Uint8Array.of(0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0), 70000)], [0, 256, 65537]);
});

test("outlines_come_back_exactly", () => {
  const corners = [0.5, -0.25, 1e-3, -2e5, 0, 3];
  const bytes = new Uint8Array(corners.length * 4);
  corners.forEach((value, i) => new DataView(bytes.buffer).setFloat32(4 * i, value, true));
  assert.deepEqual(decode_outline(bytes, 3, 1, [0, 0]).map((frame) => [...frame]), [[0.5, -0.25], [Math.fround(1e-3), -2e5], [0, 3]]);
  assert.deepEqual([...decode_outline(bytes, 3, 1, [500000.25, 6500000.5])[0]], [500000.75, 6500000.25]);
});

test("a_block_of_the_wrong_length_is_refused", () => {
  assert.throws(() => decode_places(new Uint8Array(4 * frames * count - 1), frames, count), /47 bytes instead of 48/);
  assert.throws(() => decode_values(new Uint8Array(1), frames, count), RangeError);
  assert.throws(() => decode_sizes(new Uint8Array(9), count), RangeError);
  assert.throws(() => decode_triangles(Uint8Array.of(0, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 0), count), /corner 4 of 4/);
});
