// SPDX-License-Identifier: BSD-3-Clause
// Which frames of two films belong together: by the travel of the drag, the embedment of the driven body, the time, or the part of the run that is over.
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
  return between(embedments(run), at);
}

/** What joins two films, and its words. */
export const JOINS = { travel: "u/D of the drag", embedment: "embedment w/D", time: "time", part: "fraction of the run" } as const;
export type Join = keyof typeof JOINS;

/** The frame after which the drag begins; -1: nothing is dragged. */
function begin_of_drag(run: FilmedRun): number {
  const dragged = new Set(run.drag.rows.map((row) => run.stage[row]));
  const first = run.film.frames.findIndex((frame) => dragged.has(frame.stage));
  return first < 0 ? -1 : Math.max(0, first - 1);
}

/** The way along u that the body has gone in its drags, by frame, over D (in m where there is no D); 0 until then. It never falls, to and fro. */
export function travels(run: FilmedRun): number[] {
  const begin = begin_of_drag(run);
  let way = 0;
  return run.film.frames.map((frame, i) => {
    if (begin >= 0 && i > begin) way += Math.abs((frame.u ?? NaN) - (run.film.frames[i - 1].u ?? NaN)) / (run.diameter ?? 1);
    return way;
  });
}

/** Between two numbers of a list. */
export function between(values: number[], at: number): number {
  const frame = Math.min(Math.floor(at), values.length - 1);
  const next = Math.min(frame + 1, values.length - 1);
  return values[frame] + (at - frame) * (values[next] - values[frame]);
}

/** Where numbers by frame first reach a value, between frames; `from` or `to` outside of what they reach there. */
export function where(values: number[], value: number, from = 0, to = values.length - 1): number {
  if (values[from] >= value) return from;
  let largest = values[from];
  for (let frame = from + 1; frame <= to; frame++) {
    if (values[frame] >= value && values[frame] > largest) return frame - (values[frame] - value) / (values[frame] - values[frame - 1]);
    largest = Math.max(largest, values[frame]);
  }
  return to;
}

/** Where in the film the body first gets as deep as this, between frames; the first or last frame outside of what the film reaches. */
export function when_embedded(run: FilmedRun, embedment: number): number {
  return where(embedments(run), embedment);
}

/** In a drag as far along as the leader; before it as deep in the push. */
function when_travelled(leader: FilmedRun, at: number, follower: FilmedRun): number {
  const begin = begin_of_drag(follower);
  if (at > begin_of_drag(leader)) return where(travels(follower), between(travels(leader), at), begin);
  return where(embedments(follower), embedment_at(leader, at), 0, begin);
}

/** Where `follower` is when `leader` is at a frame. */
export function partner(join: Join, leader: FilmedRun, at: number, follower: FilmedRun): number {
  const times = (run: FilmedRun) => run.film.frames.map((frame) => frame.time);
  const last = (run: FilmedRun) => run.film.frames.length - 1;
  if (join === "travel") return when_travelled(leader, at, follower);
  if (join === "embedment") return when_embedded(follower, embedment_at(leader, at));
  if (join === "time") return where(times(follower), between(times(leader), at));
  return last(leader) === 0 ? last(follower) : (at / last(leader)) * last(follower);
}

/** What can join two films, the most telling first. */
export function joins_of(left: FilmedRun, right: FilmedRun): Join[] {
  const joins: Join[] = [];
  if ([left, right].every((run) => (travels(run).at(-1) ?? 0) > 0)) joins.push("travel");
  if (embedment_joins(left, right)) joins.push("embedment");
  return [...joins, "time", "part"];
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

/** The part of the soil that a film shows, as large in D as in all of these films: then pictures of one width have one scale. Without a D its own. */
export function common_region(run: FilmedRun, runs: FilmedRun[]): FilmedRun["film"]["view"] {
  const { lower, upper } = run.film.view;
  if (runs.some((one) => one.diameter === null)) return run.film.view;
  const unit = (one: FilmedRun) => one.diameter!;
  const largest = (length: (one: FilmedRun) => number) => Math.max(...runs.map((one) => length(one) / unit(one))) * unit(run);
  const half = largest((one) => (one.film.view.upper[0] - one.film.view.lower[0]) / 2), middle = (lower[0] + upper[0]) / 2;
  // The surface is as high in all pictures.
  const level = (one: FilmedRun) => one.film.surface ?? one.film.view.upper[1];
  const above = largest((one) => one.film.view.upper[1] - level(one)), below = largest((one) => level(one) - one.film.view.lower[1]);
  return { lower: [middle - half, level(run) - below], upper: [middle + half, level(run) + above] };
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
