// SPDX-License-Identifier: BSD-3-Clause
// The unpacked parts of the film of a whole run in space.
import type { SpaceData, SurfaceData } from "./data";
import { decode_places, decode_sizes, decode_triangles } from "./film_decode";
import { decoded, FilmParts } from "./film_soil";

export type Vector = [number, number, number];

export interface SpaceBox {
  lower: Vector;
  upper: Vector;
}

/** Where the soil is, by frame: x = lower + step * code, three codes for each particle. */
export interface SpaceSoil {
  count: number;
  lower: Vector;
  step: number;
  places: Uint16Array[];
  /** Sides of the cubes that particles stand for, as codes. */
  sizes: Uint16Array;
  /** m, of the soil in frame 0. */
  box: SpaceBox;
}

/** A rigid body: corners x, y, z (m) by frame. */
export interface Surface {
  name: string;
  triangles: Uint32Array;
  corners: Float64Array[];
}

export class SpaceParts extends FilmParts {
  constructor(private space: SpaceData) {
    super(space);
  }

  whole(): Promise<SpaceSoil> {
    return this.once("whole", async () => {
      const { space } = this;
      const [places, sizes] = await Promise.all([
        decoded(space.position, (bytes) => decode_places(bytes, space.frames.length, space.count, 3)),
        decoded(space.size!, (bytes) => decode_sizes(bytes, space.count)),
      ]);
      const lower: Vector = [...space.lower, space.lower_z];
      return { count: space.count, lower, step: space.step, places, sizes, box: box_of(places[0], sizes, Math.cbrt(space.one_of), lower, space.step) };
    });
  }

  surface(data: SurfaceData): Promise<Surface> {
    return this.once(data.position, async () => {
      const [triangles, codes] = await Promise.all([
        decoded(data.triangles, (bytes) => decode_triangles(bytes, data.points)),
        decoded(data.position, (bytes) => decode_places(bytes, this.space.frames.length, data.points, 3)),
      ]);
      const corners = codes.map((frame) => Float64Array.from(frame, (code, i) => data.lower[i % 3] + data.step * code));
      return { name: data.name, triangles, corners };
    });
  }
}

/** `larger`: how many times the particles' own sides the sizes are. */
function box_of(codes: Uint16Array, sizes: Uint16Array, larger: number, from: Vector, step: number): SpaceBox {
  const lower: Vector = [Infinity, Infinity, Infinity], upper: Vector = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < codes.length; i++) {
    const axis = i % 3, half = sizes[(i - axis) / 3] / larger / 2;
    lower[axis] = Math.min(lower[axis], from[axis] + step * (codes[i] - half));
    upper[axis] = Math.max(upper[axis], from[axis] + step * (codes[i] + half));
  }
  return { lower, upper };
}

/** The box of the soil at the start, and of what of bodies is seen where they begin and end: above the soil no higher than the soil is deep. */
export function seen_box(soil: SpaceSoil, surfaces: Surface[]): SpaceBox {
  const lower: Vector = [...soil.box.lower], upper: Vector = [...soil.box.upper];
  const highest = 2 * upper[1] - lower[1];
  for (const { corners } of surfaces)
    for (const frame of [corners[0], corners[corners.length - 1]])
      for (let i = 1; i < frame.length; i += 3) upper[1] = Math.max(upper[1], Math.min(highest, frame[i]));
  return { lower, upper };
}

/** 1 for each particle above which there is none, and for those that lie less than a side below it; columns are half as wide again as the
 * largest particle, so that none is empty where the soil has spread. */
export function on_surface(soil: SpaceSoil, frame: number): Uint8Array {
  const codes = soil.places[frame];
  const width = 1.5 * soil.sizes.reduce((a, b) => Math.max(a, b), 1);
  const column = (p: number) => Math.floor(codes[3 * p] / width) * 65536 + Math.floor(codes[3 * p + 2] / width);
  const highest = new Map<number, number>();
  for (let p = 0; p < soil.count; p++) highest.set(column(p), Math.max(highest.get(column(p)) ?? 0, codes[3 * p + 1]));
  return Uint8Array.from({ length: soil.count }, (_, p) => (codes[3 * p + 1] > highest.get(column(p))! - soil.sizes[p] ? 1 : 0));
}
