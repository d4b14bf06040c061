// SPDX-License-Identifier: BSD-3-Clause
// Colour maps, all perceptually uniform, and the range of a field that they span.
import { interpolateCividis, interpolatePlasma, interpolateViridis } from "d3-scale-chromatic";
import type { FieldData } from "./data";

export interface Range {
  from: number;
  to: number;
}

const MAPS: Record<FieldData["name"], (t: number) => string> = {
  deviatoric_strain: interpolateViridis,
  incremental_deviatoric_strain: interpolateViridis,
  mean_stress: interpolateCividis,
  speed: interpolatePlasma,
  displacement: interpolateViridis,
};

/** 256 colours as r, g, b, a from the low to the high end of the field; the dark end is the one nearer to zero. */
export function colour_table(field: FieldData): Uint8Array {
  const dark_at_high = Math.abs(field.low) > Math.abs(field.high);
  const table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) table.set([...rgb(MAPS[field.name](dark_at_high ? 1 - i / 255 : i / 255)), 255], 4 * i);
  return table;
}

/** The range that one field has in all of these films: what the weakest still shows, but never under a tenth of the strongest. */
export function common_range(fields: FieldData[]): Range {
  return {
    from: weakest(fields.map((field) => field.low)),
    to: weakest(fields.map((field) => field.high)),
  };
}

function weakest(ends: number[]): number {
  const [smallest, largest] = [Math.min(...ends), Math.max(...ends)];
  if (smallest >= 0) return Math.max(smallest, largest / 10);
  if (largest <= 0) return Math.min(largest, smallest / 10);
  return Math.abs(smallest) < Math.abs(largest) ? largest : smallest;
}

function rgb(colour: string): number[] {
  if (colour[0] === "#") return [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
  return colour.match(/\d+/g)!.slice(0, 3).map(Number);
}
