// SPDX-License-Identifier: BSD-3-Clause
// The bytes of a film's blocks become arrays by frame. Planes of low and high bytes, and changes from frame to frame, are what compresses well.

/** Codes x, y (in space x, y, z; of a quantity of a line one) of all points, one array per frame; throws where the number of bytes is wrong. */
export function decode_places(bytes: Uint8Array, frames: number, count: number, axes: 1 | 2 | 3 = 2): Uint16Array[] {
  const n = frames * count;
  expect_bytes(bytes, 2 * axes * n);
  const places = Array.from({ length: frames }, () => new Uint16Array(axes * count));
  for (let axis = 0; axis < axes; axis++) {
    const low = 2 * axis * n;
    const high = low + n;
    for (let frame = 0; frame < frames; frame++) {
      const now = places[frame];
      const before = frame > 0 ? places[frame - 1] : null;
      const first = frame * count;
      for (let p = 0; p < count; p++) {
        const code = bytes[low + first + p] | (bytes[high + first + p] << 8);
        // Folded changes: 0, -1, 1, -2, ... are stored as 0, 1, 2, 3, ...
        now[axes * p + axis] = before === null ? code : before[axes * p + axis] + ((code >>> 1) ^ -(code & 1));
      }
    }
  }
  return places;
}

/** Bytes of a field, one array per frame. */
export function decode_values(bytes: Uint8Array, frames: number, count: number): Uint8Array[] {
  expect_bytes(bytes, frames * count);
  const values = Array.from({ length: frames }, (_, frame) => bytes.slice(frame * count, (frame + 1) * count));
  for (let frame = 1; frame < frames; frame++) {
    const now = values[frame];
    const before = values[frame - 1];
    for (let p = 0; p < count; p++) now[p] += before[p];
  }
  return values;
}

/** Sides of the particles as codes. */
export function decode_sizes(bytes: Uint8Array, count: number): Uint16Array {
  expect_bytes(bytes, 2 * count);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return Uint16Array.from({ length: count }, (_, p) => view.getUint16(2 * p, true));
}

/** Corners of triangles, three each; throws where a corner is not one of the points. */
export function decode_triangles(bytes: Uint8Array, count: number): Uint32Array {
  if (bytes.length % 12 !== 0) throw new RangeError(`${bytes.length} bytes are not whole triangles`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const corners = Uint32Array.from({ length: bytes.length / 4 }, (_, i) => view.getUint32(4 * i, true));
  for (const corner of corners) if (corner >= count) throw new RangeError(`a triangle has corner ${corner} of ${count}`);
  return corners;
}

/** Outline x, y of a rigid body in m, one array per frame; stored from the place `from`. */
export function decode_outline(bytes: Uint8Array, frames: number, points: number, from: [number, number]): Float64Array[] {
  expect_bytes(bytes, 8 * frames * points);
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return Array.from({ length: frames }, (_, frame) =>
    Float64Array.from({ length: 2 * points }, (_, i) => from[i & 1] + view.getFloat32(4 * (2 * points * frame + i), true)),
  );
}

function expect_bytes(bytes: Uint8Array, expected: number): void {
  if (bytes.length !== expected) throw new RangeError(`${bytes.length} bytes instead of ${expected}`);
}
