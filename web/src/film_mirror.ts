// SPDX-License-Identifier: BSD-3-Clause
// A run around an axis with both of its halves: what lies at the radius x is shown at x and -x.
import type { FilmData, RigidData } from "./data";
import { FilmParts, type Soil, type Values } from "./film_soil";

const MOST = 65535;

/** The half's film as one of both halves. */
export function mirrored_film(half: FilmData): FilmData {
  const radius = half.lower[0] + MOST * half.step;
  return {
    ...half,
    count: 2 * half.count,
    lower: [-radius, half.lower[1]],
    step: (2 * radius) / MOST,
    view: { lower: [-half.view.upper[0], half.view.lower[1]], upper: half.view.upper },
    flow: half.flow && { ...half.flow, mirrored: true },
    rigids: [...half.rigids, ...half.rigids.map((rigid) => ({ ...rigid, mirrored: true }))],
  };
}

/** Places of the half, then those of the other in the same order. */
export function mirrored_soil(half: Soil, film: FilmData): Soil {
  const coarser = half.step / film.step, centre = -film.lower[0] / film.step, first = half.lower[0] / film.step;
  const places = half.places.map((codes) => {
    const both = new Uint16Array(2 * codes.length);
    for (let at = 0; at < codes.length; at += 2) {
      const radius = first + coarser * codes[at];
      both[at] = Math.round(centre + radius);
      both[codes.length + at] = Math.round(Math.max(0, centre - radius));
      both[at + 1] = both[codes.length + at + 1] = Math.round(coarser * codes[at + 1]);
    }
    return both;
  });
  const sizes = half.sizes === null ? null : Uint16Array.from([...half.sizes, ...half.sizes], (side) => Math.max(1, Math.round(coarser * side)));
  const triangles = half.triangles === null ? null : Uint32Array.from([...half.triangles, ...half.triangles.map((corner) => corner + half.count)]);
  const { lower, upper } = half.bounds;
  return {
    ...half, places, sizes, triangles, count: 2 * half.count, lower: film.lower, step: film.step, largest_size: Math.max(1, coarser * half.largest_size),
    bounds: { lower: [-upper[0], lower[1]], upper },
  };
}

export class MirroredParts extends FilmParts {
  constructor(half: FilmData, private both = mirrored_film(half)) {
    super(half);
  }

  override soil(): Promise<Soil> {
    return this.once("both", async () => mirrored_soil(await super.soil(), this.both));
  }

  override values(field: FilmData["fields"][number]): Promise<Values> {
    return this.once(`${field.block} both`, async () => {
      const half = await super.values(field);
      return { ...half, frames: half.frames.map((frame) => Uint8Array.from([...frame, ...frame])) };
    });
  }

  override outline(rigid: RigidData): Promise<Float64Array[]> {
    if (!rigid.mirrored) return super.outline(rigid);
    return this.once(`${rigid.block} mirrored`, async () => (await super.outline(rigid)).map((corners) => corners.map((x, i) => (i % 2 === 0 ? -x : x))));
  }
}
