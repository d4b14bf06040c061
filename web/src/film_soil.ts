// SPDX-License-Identifier: BSD-3-Clause
// The unpacked parts of one run's film; each block is read once, when first asked for.
import type { FieldData, FilmData, FlowData, RigidData } from "./data";
import { damaged, read_block } from "./film_blocks";
import { decode_flow } from "./film_flow";
import { decode_outline, decode_places, decode_sizes, decode_triangles, decode_values } from "./film_decode";

/** Where the soil is, by frame: x = lower + step * code. */
export interface Soil {
  kind: FilmData["kind"];
  count: number;
  lower: [number, number];
  step: number;
  places: Uint16Array[];
  /** Sides of particles as codes; null: triangles. */
  sizes: Uint16Array | null;
  largest_size: number;
  triangles: Uint32Array | null;
  /** m, the soil of frame 0. */
  bounds: { lower: [number, number]; upper: [number, number] };
}

/** A field's bytes by frame, and whether some lie at its ends. */
export interface Values {
  frames: Uint8Array[];
  at_low: boolean;
  at_high: boolean;
}

export class FilmParts {
  private read = new Map<string, Promise<unknown>>();

  constructor(readonly film: FilmData) {}

  soil(): Promise<Soil> {
    return this.once("soil", async () => {
      const { film } = this;
      const n = film.frames.length;
      const [places, sizes, triangles] = await Promise.all([
        decoded(film.position, (bytes) => decode_places(bytes, n, film.count)),
        film.size === null ? null : decoded(film.size, (bytes) => decode_sizes(bytes, film.count)),
        film.triangles === null ? null : decoded(film.triangles, (bytes) => decode_triangles(bytes, film.count)),
      ]);
      const largest_size = sizes === null ? 0 : sizes.reduce((a, b) => Math.max(a, b), 0);
      const { kind, count, lower, step } = film;
      return { kind, count, lower, step, places, sizes, largest_size, triangles, bounds: bounds_of(film, places[0]) };
    });
  }

  values(field: FieldData): Promise<Values> {
    return this.once(field.block, async () => {
      const frames = await decoded(field.block, (bytes) => decode_values(bytes, this.film.frames.length, this.film.count));
      return { frames, at_low: frames.some((frame) => frame.includes(0)), at_high: frames.some((frame) => frame.includes(255)) };
    });
  }

  outline(rigid: RigidData): Promise<Float64Array[]> {
    return this.once(rigid.block, () => decoded(rigid.block, (bytes) => decode_outline(bytes, this.film.frames.length, rigid.points, this.film.lower)));
  }

  flow({ block, columns, rows }: FlowData): Promise<Int8Array[]> {
    return this.once(block, () => decoded(block, (bytes) => decode_flow(bytes, this.film.frames.length, columns * rows)));
  }

  protected once<T>(key: string, make: () => Promise<T>): Promise<T> {
    let made = this.read.get(key) as Promise<T> | undefined;
    if (made === undefined) this.read.set(key, (made = make()));
    return made;
  }
}

/** What is decoded of a block. */
export async function decoded<T>(id: string, decode: (bytes: Uint8Array) => T): Promise<T> {
  const bytes = await read_block(id);
  try {
    return decode(bytes);
  } catch (error) {
    throw damaged(id, (error as Error).message);
  }
}

function bounds_of(film: FilmData, codes: Uint16Array): Soil["bounds"] {
  const lower: [number, number] = [Infinity, Infinity];
  const upper: [number, number] = [-Infinity, -Infinity];
  for (let i = 0; i < codes.length; i++) {
    const x = film.lower[i & 1] + film.step * codes[i];
    if (x < lower[i & 1]) lower[i & 1] = x;
    if (x > upper[i & 1]) upper[i & 1] = x;
  }
  return { lower, upper };
}
