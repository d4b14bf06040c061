// SPDX-License-Identifier: BSD-3-Clause
// Where a finite element run of large deformations got a new mesh: ticks at the edge of the charts, a row for each run.
import type uPlot from "uplot";
import type { RunData } from "../data";
import { svg_element } from "../element";
import { is_dark } from "../theme";
import type { Numbers, Trace } from "./plan";
import type { RunStyle } from "./run_style";
import type { Scene } from "./scene";

/** The column of history.csv that counts them. */
const counted = "remeshings";

/** A remeshing along the argument of a chart, in the unit of its axis. */
export interface Tick {
  at: number;
  /** Of the run among those with ticks: 0 is the outermost. */
  place: number;
  style: RunStyle;
}

export const tick_length = 7;
const gap = 2;

/** px from the edge to where the ticks of a run begin. */
export function tick_offset(tick: Tick): number {
  return tick.place * (tick_length + gap);
}

/** Whether the mesh of a run was made anew at all. */
export function was_remeshed(run: RunData): boolean {
  return (run.columns[counted] ?? []).some((count) => count !== null && count > 0);
}

/** The arguments of a trace in whose rows the count has risen since the row before. */
export function remeshed_at(trace: Pick<Trace, "run" | "rows" | "argument">): number[] {
  const counts: Numbers | undefined = trace.run.columns[counted];
  if (counts === undefined) return [];
  return trace.rows.flatMap((row, i) => {
    const before = row > 0 ? counts[row - 1] : null, count = counts[row], at = trace.argument[i];
    return before !== null && count !== null && count > before && at !== null ? [at] : [];
  });
}

/** The ticks of traces, whose arguments are multiplied by what `factor` gives for their run. */
export function ticks_of_remeshings(traces: Trace[], factor: (run: RunData) => number | null): Tick[] {
  return traces.filter((trace) => was_remeshed(trace.run)).flatMap((trace, place) =>
    remeshed_at(trace).map((at) => ({ at: at * (factor(trace.run) ?? 1), place, style: trace.style })));
}

/** Draws the ticks of a scene inside its area, at the edge opposite to the axis of the argument. */
export function draw_remeshings(u: uPlot, scene: Scene): void {
  const { ctx, bbox } = u;
  const unit = devicePixelRatio;
  const upright = scene.plan.upright;
  ctx.save();
  ctx.setLineDash([]);
  ctx.lineWidth = 1.25 * unit;
  for (const tick of scene.remeshings) {
    const at = u.valToPos(tick.at, upright ? "y" : "x", true), from = tick_offset(tick) * unit, to = from + tick_length * unit;
    const low = upright ? bbox.top : bbox.left;
    if (!(at >= low && at <= low + (upright ? bbox.height : bbox.width))) continue;
    ctx.strokeStyle = is_dark() ? tick.style.colour.dark : tick.style.colour.light;
    ctx.beginPath();
    if (upright) {
      ctx.moveTo(bbox.left + bbox.width - from, at);
      ctx.lineTo(bbox.left + bbox.width - to, at);
    } else {
      ctx.moveTo(at, bbox.top + from);
      ctx.lineTo(at, bbox.top + to);
    }
    ctx.stroke();
  }
  ctx.restore();
}

/** Some ticks, for legends: lines from (x, y) on. */
export function tick_sample(x = 0, y = 0): SVGGElement {
  const lines = [2, 11, 20, 29].map((at) => svg_element("line", { x1: x + at, x2: x + at, y1: y, y2: y + tick_length }));
  return svg_element("g", { stroke: "currentColor", "stroke-width": 1.5 }, ...lines);
}
