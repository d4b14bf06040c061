// SPDX-License-Identifier: BSD-3-Clause
// Which frames of two films belong together: by the part of the run that is over, or by the embedment of the driven body.
import type { RunData } from "./data";

/** A run that has a film. */
export type FilmedRun = RunData & { film: NonNullable<RunData["film"]> };

/** w / D by frame (w in m where there is no D); NaN without a driven body. */
export function embedments(run: FilmedRun): number[] {
  return run.film.frames.map((frame) => (frame.w === null ? NaN : frame.w / (run.diameter ?? 1)));
}

/** The frame of the drag (of all of the run where nothing is dragged) whose embedment is nearest to w / D; null without a driven body. */
export function frame_of_drag(run: FilmedRun, embedment: number): number | null {
  const dragged = new Set(run.drag.rows.map((row) => run.stage[row]));
  const w = embedments(run);
  const all = w.flatMap((value, frame) => (Number.isFinite(value) ? [frame] : []));
  const drag = all.filter((frame) => dragged.has(run.film.frames[frame].stage));
  const among = drag.length > 0 ? drag : all;
  if (among.length === 0 || !Number.isFinite(embedment)) return null;
  return among.reduce((best, frame) => (Math.abs(w[frame] - embedment) < Math.abs(w[best] - embedment) ? frame : best));
}

/** Embedment between two frames. */
export function embedment_at(run: FilmedRun, at: number): number {
  const w = embedments(run);
  const frame = Math.min(Math.floor(at), w.length - 1);
  const next = Math.min(frame + 1, w.length - 1);
  return w[frame] + (at - frame) * (w[next] - w[frame]);
}

/** Where in the film the body first gets as deep as this, between frames; the first or last frame outside of what the film reaches. */
export function when_embedded(run: FilmedRun, embedment: number): number {
  const w = embedments(run);
  if (w[0] >= embedment) return 0;
  let deepest = w[0];
  for (let frame = 1; frame < w.length; frame++) {
    if (w[frame] >= embedment && w[frame] > deepest) return frame - (w[frame] - embedment) / (w[frame] - w[frame - 1]);
    deepest = Math.max(deepest, w[frame]);
  }
  return w.length - 1;
}

/** Whether embedment tells the frames of both films: the body sinks by 0.02 D or more in each, and mostly over the same range. */
export function embedment_joins(left: FilmedRun, right: FilmedRun): boolean {
  const ranges = [left, right].map((run) => {
    const w = embedments(run);
    return { from: w[0], to: Math.max(...w) };
  });
  if (!ranges.every(({ from, to }) => to - from >= 0.02)) return false;
  const shared = Math.min(...ranges.map((r) => r.to)) - Math.max(...ranges.map((r) => r.from));
  return shared >= 0.5 * Math.min(...ranges.map((r) => r.to - r.from));
}

/** The two runs that the page begins with: the first MPM run, and the FEM run that reaches the deepest or else the next run. */
export function first_pair(runs: FilmedRun[]): number[] {
  const left = Math.max(0, runs.findIndex((run) => run.method === "mpm"));
  const depth = (i: number) => Math.max(...embedments(runs[i]).map((w) => (Number.isFinite(w) ? w : -Infinity)));
  const others = runs.map((_, i) => i).filter((i) => i !== left);
  const fem = others.filter((i) => runs[i].method === "fem");
  const right = fem.length > 0 ? fem.reduce((best, i) => (depth(i) > depth(best) ? i : best)) : others[0];
  return right === undefined ? [left] : [left, right];
}
