// SPDX-License-Identifier: BSD-3-Clause
import type { Trace } from "./plan";
import type { Scene } from "./scene";

/** px of a point of the scene. */
type Place = (x: number, y: number) => [left: number, top: number];

/** For each trace the point nearest to a place: along the argument's axis, or in the plane. */
export function nearest_points(scene: Scene, left: number, top: number, place: Place): (number | null)[] {
  return scene.traces.map((trace) => {
    let best: number | null = null, least = Infinity;
    trace.argument.forEach((_, i) => {
      const point = point_of(scene, trace, i);
      if (point === null) return;
      const [dx, dy] = place(...point).map((at, axis) => at - (axis === 0 ? left : top));
      const distance = scene.plan.in_plane ? Math.hypot(dx, dy) : Math.abs(scene.plan.upright ? dy : dx);
      if (distance < least) (least = distance), (best = i);
    });
    return best;
  });
}

/** The point of a trace nearest to a time (s); null where the trace ended before it or has not begun. */
export function nearest_in_time(trace: Trace, time: number): number | null {
  const times = trace.run.columns.time_s;
  if (times === undefined || trace.rows.length === 0) return null;
  const of = (i: number) => times[trace.rows[i]] ?? Infinity;
  let low = 0, high = trace.rows.length - 1;
  const room = 1e-6 * Math.abs(of(high));
  if (time < of(low) - room || time > of(high) + room) return null;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (of(middle) <= time) low = middle;
    else high = middle;
  }
  return time - of(low) < of(high) - time ? low : high;
}

/** A point of a trace in the units of the axes; null where it has none. */
export function point_of(scene: Scene, trace: Trace, i: number, freed_from_noise = false): [x: number, y: number] | null {
  const argument = trace.argument[i];
  const value = (freed_from_noise ? trace.mean?.[i] : null) ?? trace.value[i];
  if (argument === null || value === null) return null;
  const [along, of] = scene.plan.upright ? [scene.y, scene.x] : [scene.x, scene.y];
  const shown_argument = argument * along.unit.factor(trace.run)!, shown_value = value * of.unit.factor(trace.run)!;
  return scene.plan.upright ? [shown_value, shown_argument] : [shown_argument, shown_value];
}

/** The next point of a trace in the direction of `step` that can be drawn; the last one of them where the trace ends. */
export function stepped(scene: Scene, trace: Trace, from: number, step: number): number {
  let at = from;
  for (let left = Math.abs(step), i = from; left > 0; ) {
    i += Math.sign(step);
    if (i < 0 || i >= trace.argument.length) break;
    if (point_of(scene, trace, i) !== null) (at = i), --left;
  }
  return at;
}
