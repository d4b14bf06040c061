// SPDX-License-Identifier: BSD-3-Clause
// Colour maps, all perceptually uniform, and the range of a field that they span.
import { interpolateCividis, interpolatePlasma, interpolateViridis } from "d3-scale-chromatic";
import type { FieldData } from "./data";

export interface Range {
  from: number;
  to: number;
}

/** By unit: stresses and speeds have maps of their own. */
const MAPS = new Map<string, (t: number) => string>([
  ["kPa", interpolateCividis],
  ["m/s", interpolatePlasma],
]);

/** 256 colours as r, g, b, a from the low to the high end of the field; the dark end is the one nearer to zero. */
export function colour_table(field: FieldData): Uint8Array {
  const dark_at_high = Math.abs(field.low) > Math.abs(field.high);
  const map = MAPS.get(field.unit) ?? interpolateViridis;
  const table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) table.set([...rgb(map(dark_at_high ? 1 - i / 255 : i / 255)), 255], 4 * i);
  return table;
}

/** The range that one field has in all of these films: at each end what the weakest film still shows, but not under a tenth of the strongest. */
export function common_range(fields: FieldData[]): Range {
  const scale = Math.max(...fields.flatMap((field) => [Math.abs(field.low), Math.abs(field.high)]));
  return { from: weakest(fields.map((field) => field.low), scale), to: weakest(fields.map((field) => field.high), scale) };
}

function weakest(ends: number[], scale: number): number {
  const sorted = [...ends].sort((a, b) => Math.abs(a) - Math.abs(b));
  const [nearest, strongest] = [sorted[0], sorted[sorted.length - 1]];
  // An end that is next to nothing for this field, such as a little tension where all else is pressed, asks for no room.
  const of_no_weight = Math.abs(strongest) < scale / 20;
  return of_no_weight || Math.abs(nearest) >= Math.abs(strongest) / 10 ? nearest : strongest / 10;
}

function rgb(colour: string): number[] {
  if (colour[0] === "#") return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  return colour.match(/\d+/g)!.slice(0, 3).map(Number);
}
