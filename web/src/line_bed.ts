// SPDX-License-Identifier: BSD-3-Clause
// The soil of the slices seen from above: where it is heaped up, and where it was dug away.
import { digits } from "./film_numbers";
import { type LineRun, type LineShapes, shape_at, value_at, type Values } from "./line_shapes";

/** Shades of each colour. */
const shades = 5;
/** Less than this part of the most is left blank. */
const blank = 0.1;

/** A rectangle of one shade, m: heaped where shade > 0, dug away where shade < 0. */
export interface Patch {
  shade: number;
  x: [number, number];
  y: [number, number];
}

/** How far soil has risen and sunk at most, m, of all frames; at least a hair's breadth. */
export function most_of(rise: Values[]): { up: number; down: number } {
  let up = 1e-9, down = 1e-9;
  for (const frame of rise)
    for (const value of frame) {
      up = Math.max(up, value);
      down = Math.max(down, -value);
    }
  return { up, down };
}

/** From -shades to shades. */
export function shade_of(rise: number, { up, down }: { up: number; down: number }): number {
  const part = rise / (rise > 0 ? up : down);
  return Math.abs(part) < blank ? 0 : Math.sign(part) * Math.min(shades, Math.ceil(Math.abs(part) * shades));
}

/** The bed of all slices at a moment of the film; each represents half of the distance to its neighbours. None before the line hangs. */
export function patches_at(run: LineRun, { x: nodes, y: shapes, rise }: Pick<LineShapes, "x" | "y" | "rise">, at: number): Patch[] {
  const { bed, slices, half } = run.line;
  if (bed === null || rise.length === 0 || at < bed.first) return [];
  const now = shape_at(rise, Math.min(at - bed.first, rise.length - 1)), most = most_of(rise);
  const columns = bed.y.length, wide = columns > 1 ? bed.y[1] - bed.y[0] : 1;
  const patches: Patch[] = [];
  slices.forEach((x, slice) => {
    const from = slice === 0 ? (half === "none" ? x : -x) : (slices[slice - 1] + x) / 2, to = slice === slices.length - 1 ? x : (x + slices[slice + 1]) / 2;
    // Columns count from where the pipe was laid, which the first frame has.
    const laid = value_at(nodes, shapes[0], x);
    let shade = 0, begin = 0;
    for (let column = 0; column <= columns; column++) {
      const next = column < columns ? shade_of(now[slice * columns + column], most) : 0;
      if (next === shade) continue;
      if (shade !== 0) patches.push(...both_halves({ shade, x: [from, to], y: [laid + bed.y[begin] - wide / 2, laid + bed.y[column - 1] + wide / 2] }, slice, half));
      shade = next;
      begin = column;
    }
  });
  return patches;
}

/** That of the slice at x = 0, which reaches to both sides, is not doubled where it is its own image. */
function both_halves(patch: Patch, slice: number, half: LineRun["line"]["half"]): Patch[] {
  const { shade, x: [from, to], y: [low, high] } = patch;
  if (half === "none") return [patch];
  const y: [number, number] = half === "symmetric" ? [low, high] : [-high, -low];
  return slice === 0 ? [{ shade, x: [0, to], y: [low, high] }, { shade, x: [-to, 0], y }] : [patch, { shade, x: [-to, -from], y }];
}

/** What the colours mean; null without a bed. */
export function heaped_words(rise: Values[]): string | null {
  if (rise.length === 0) return null;
  const { up, down } = most_of(rise);
  return `Brown: heave since before the pipe was laid, by up to ${digits(up)} m; blue: displaced, by up to ${digits(down)} m; each slice represents half of the distance to its neighbours. `;
}
