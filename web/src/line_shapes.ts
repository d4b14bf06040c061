// SPDX-License-Identifier: BSD-3-Clause
// The shapes of a line by frame, both of its halves, and what is made of them.
import type { LineData, LineQuantity, RunData } from "./data";
import { damaged, read_block } from "./film_blocks";
import { decode_places } from "./film_decode";
import { between } from "./film_together";

/** A run whose line the page can show. */
export type LineRun = RunData & { line: LineData };

/** Whether the run has a line that the page can show. */
export function is_line_run(run: RunData): run is LineRun {
  return run.line !== undefined && run.line !== null && run.line.frames.length > 0;
}

export const QUANTITIES = ["y", "P", "M", "strain_max", "strain_min"] as const;
export type QuantityOfLine = (typeof QUANTITIES)[number];
/** Numbers by node. */
export type Values = Float64Array;

/** By frame, from the far end of the other half, where there is one, over x = 0 to the far end; and how far soil has risen by frame from bed.first on, slice and column. */
export type LineShapes = Record<QuantityOfLine, Values[]> & { x: Values; rise: Values[] };

export async function read_line(line: LineData): Promise<LineShapes> {
  const whole = (half: Values, sign: 1 | -1) => (line.half === "none" ? half : mirrored(half, sign));
  const read = async (name: QuantityOfLine): Promise<[QuantityOfLine, Values[]]> => {
    const half = await read_quantity(line[name], line.frames.length, line.x.length);
    return [name, half.map((values) => whole(values, sign_of(name, line.half === "symmetric")))];
  };
  const { bed } = line, rise = bed === null ? [] : await read_quantity(bed, bed.frames, line.slices.length * bed.y.length);
  return { ...Object.fromEntries(await Promise.all(QUANTITIES.map(read))), x: whole(Float64Array.from(line.x), -1), rise } as LineShapes;
}

async function read_quantity({ low, step, block }: LineQuantity, frames: number, count: number): Promise<Values[]> {
  const bytes = await read_block(block);
  try {
    return decode_places(bytes, frames, count, 1).map((codes) => Float64Array.from(codes, (code) => low + step * code));
  } catch (error) {
    throw damaged(block, (error as Error).message);
  }
}

/** What a quantity of the other half is multiplied by: half a turn in plan turns y and the moment round. */
function sign_of(name: QuantityOfLine, symmetric: boolean): 1 | -1 {
  return !symmetric && (name === "y" || name === "M") ? -1 : 1;
}

/** The other half before this one, whose first number they share. */
export function mirrored(half: Values, sign: 1 | -1): Values {
  return Float64Array.from([...Array.from(half.subarray(1), (value) => sign * value).reverse(), ...half]);
}

/** Between two frames. */
export function shape_at(frames: Values[], at: number): Values {
  const frame = Math.min(Math.floor(at), frames.length - 1), part = at - frame;
  if (part === 0) return frames[frame];
  const next = frames[frame + 1];
  return frames[frame].map((value, node) => value + part * (next[node] - value));
}

/** The lowest and the highest y of the pipe so far, by node. */
export function swept(y: Values[], at: number, radius: number): { low: Values; high: Values } {
  const now = shape_at(y, at), low = Float64Array.from(now), high = Float64Array.from(now);
  for (let frame = 0; frame <= at; frame++)
    y[frame].forEach((value, node) => {
      low[node] = Math.min(low[node], value);
      high[node] = Math.max(high[node], value);
    });
  return { low: low.map((value) => value - radius), high: high.map((value) => value + radius) };
}

/** A number of a line at a place between its nodes. */
export function value_at(x: Values, values: Values, place: number): number {
  const after = x.findIndex((each) => each >= place);
  if (after <= 0) return values[after < 0 ? values.length - 1 : 0];
  return values[after - 1] + ((place - x[after - 1]) / (x[after] - x[after - 1])) * (values[after] - values[after - 1]);
}

/** The lowest and highest number of frames, at nodes within |x| <= far. */
export function extremes(x: Values, frames: Values[], far: number): [low: number, high: number] {
  let low = Infinity, high = -Infinity;
  for (const values of frames)
    values.forEach((value, node) => {
      if (Math.abs(x[node]) > far * (1 + 1e-9)) return;
      low = Math.min(low, value);
      high = Math.max(high, value);
    });
  return [low, high];
}

/** s, at a moment of the film. */
export function time_at(line: LineData, at: number): number {
  return between(line.frames.map((frame) => frame.time), at);
}

/** A column of the history at a time, on the straight line between its rows; null where it has no number. */
export function column_at(run: RunData, column: string, time: number): number | null {
  const times = run.columns.time_s, values = run.columns[column];
  if (values === undefined || times.length === 0) return null;
  const after = times.findIndex((each) => each !== null && each >= time - 1e-9 * Math.abs(time));
  if (after <= 0) return values[after < 0 ? values.length - 1 : 0];
  const from = values[after - 1], to = values[after], begin = times[after - 1]!, end = times[after]!;
  if (from === null || to === null) return to;
  return from + Math.min(1, (time - begin) / (end - begin)) * (to - from);
}

/** The largest of 1, 2, 5 times a power of ten by which y can be drawn larger than x, so that `range` takes at most `height` px at so many px per metre of x. */
export function exaggeration(range: number, px_per_metre: number, height: number): number {
  const most = height / (range * px_per_metre), power = 10 ** Math.floor(Math.log10(most));
  return Number((power * [5, 2, 1].find((step) => step * power <= most * (1 + 1e-9))!).toPrecision(1));
}

export function exaggeration_words(times: number): string {
  if (times === 1) return "to scale";
  return times > 1 ? `y is drawn ${times} times larger than x` : `y is drawn ${Math.round(1 / times)} times smaller than x`;
}
