// SPDX-License-Identifier: BSD-3-Clause
import type { RunData } from "../data";
import type { Numbers, Plan, Trace } from "./plan";
import type { RunStyle } from "./run_style";
import { ticks_of_remeshings } from "./remeshings";
import type { Tick } from "./remeshings";
import type { Range } from "./ticks";
import { axis_title, short_title, unit_of } from "./units";
import type { Unit, UnitSystem } from "./units";

/** What the controls above the charts say. */
export interface Settings {
  units: UnitSystem;
  /** Every row as it was computed, beside what is freed from noise. */
  raw: boolean;
  published: boolean;
  hidden: Set<RunData>;
}

export interface SceneAxis {
  title: string;
  /** The title without words. */
  short: string;
  unit: Unit;
  logarithmic: boolean;
  downwards: boolean;
  /** Holds all that is drawn. */
  full: Range;
}

/** A line to be drawn: numbers in the units of the axes. */
export interface Line {
  /** Of `traces`. */
  trace: number;
  x: Numbers;
  y: Numbers;
  weight: "raw" | "plain" | "mean" | "band";
  style: RunStyle;
}

/** A point; a level where x or y is null. */
export interface Mark {
  x: number | null;
  y: number | null;
  label: string;
  published: boolean;
}

/** A plan in units, without what is switched off: all that is needed to draw it, on the page or in a file. */
export interface Scene {
  plan: Plan;
  x: SceneAxis;
  y: SceneAxis;
  traces: Trace[];
  lines: Line[];
  marks: Mark[];
  remeshings: Tick[];
}

/** The axis on which the plan's argument (or value) stands. */
export function argument_axis(scene: Scene): SceneAxis {
  return scene.plan.upright ? scene.y : scene.x;
}
export function value_axis(scene: Scene): SceneAxis {
  return scene.plan.upright ? scene.x : scene.y;
}

export function scaled(values: Numbers, factor: number): Numbers {
  return values.map((value) => (value === null ? null : value * factor));
}

function largest(lists: Numbers[]): number {
  return lists.reduce((most, list) => list.reduce<number>((found, value) => Math.max(found, Math.abs(value ?? 0)), most), 0);
}

export function make_scene(plan: Plan, settings: Settings, runs: RunData[]): Scene {
  const all = plan.traces;
  const argument = unit_of(settings.units, plan.argument, largest(all.map((trace) => trace.argument)), runs);
  const value = unit_of(settings.units, plan.value, largest(all.map((trace) => trace.value)), runs);
  const traces = all.filter(
    ({ run }) => argument.factor(run) !== null && value.factor(run) !== null && !(plan.by_run && settings.hidden.has(run)),
  );
  const lines = traces.flatMap((trace, index) => trace_lines(trace, index, settings.raw, plan.upright, argument, value));
  // Published numbers are of a test, at the scale of the runs of it.
  const reference = runs.find((run) => run.of_test) ?? runs.find((run) => run.diameter !== null) ?? runs[0];
  const marks = plan.marks
    .filter((mark) => settings.published || !mark.published)
    .filter((mark) => (mark.argument === null || argument.factor(reference) !== null) && (mark.value === null || value.factor(reference) !== null))
    .map((mark) => {
      const along = mark.argument === null ? null : mark.argument * argument.factor(reference)!;
      const of = mark.value === null ? null : mark.value * value.factor(reference)!;
      const made_with = mark.published && value.divisor !== "" && differs(value, runs) ? ` (with D, \u03b3\u2032 of ${reference.name})` : "";
      return { x: plan.upright ? of : along, y: plan.upright ? along : of, label: mark.label + made_with, published: mark.published };
    });
  const axis = (which: "x" | "y"): SceneAxis => {
    const is_argument = (which === "y") === plan.upright;
    const [quantity, unit] = is_argument ? [plan.argument, argument] : [plan.value, value];
    const logarithmic = plan.logarithmic && !is_argument;
    const numbers = [...lines.map((line) => line[which]), marks.map((mark) => mark[which])];
    return {
      title: axis_title(quantity, unit),
      short: short_title(quantity, unit),
      unit,
      logarithmic,
      downwards: is_argument ? plan.upright : plan.value_downwards,
      full: logarithmic ? decades(numbers) : full_range(numbers, plan.zero, is_argument),
    };
  };
  // In a plane the argument is no travel or time.
  const remeshings = plan.by_run && !plan.in_plane ? ticks_of_remeshings(traces, (run) => argument.factor(run)) : [];
  return { plan, x: axis("x"), y: axis("y"), traces, lines, marks, remeshings };
}

function trace_lines(trace: Trace, index: number, raw: boolean, upright: boolean, argument: Unit, value: Unit): Line[] {
  const along = scaled(trace.argument, argument.factor(trace.run)!);
  const line = (values: Numbers, weight: Line["weight"], at = along): Line => {
    const of = scaled(values, value.factor(trace.run)!);
    return { trace: index, x: upright ? of : at, y: upright ? at : of, weight, style: trace.style };
  };
  const band = trace.band === undefined ? [] : [line(trace.band.value, "band", scaled(trace.band.argument, argument.factor(trace.run)!))];
  if (trace.mean === null) return [...band, line(trace.value, "plain")];
  return raw ? [...band, line(trace.value, "raw"), line(trace.mean, "mean")] : [...band, line(trace.mean, "mean")];
}

function differs(unit: Unit, runs: RunData[]): boolean {
  const factors = runs.flatMap((run) => unit.factor(run) ?? []);
  return factors.some((factor) => Math.abs(factor - factors[0]) > 1e-9 * factors[0]);
}

function extremes(lists: Numbers[]): [number, number] {
  let low = Infinity, high = -Infinity;
  for (const list of lists)
    for (const value of list) if (value !== null) (low = Math.min(low, value)), (high = Math.max(high, value));
  return [low, high];
}

/** With a margin at the ends, but where an argument begins, and where the range ends at zero or at what noise makes of it. */
function full_range(lists: Numbers[], zero: boolean, is_argument: boolean): Range {
  let [low, high] = extremes(lists);
  if (low > high) return [0, 1];
  if (zero) [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  if (high === low) return high === 0 ? [0, 1] : [low - 0.1 * Math.abs(low), high + 0.1 * Math.abs(high)];
  const margin = 0.04 * (high - low);
  const end = (value: number, side: number) => ((zero && Math.abs(value) < margin) || (is_argument && side < 0) ? value : value + side * margin);
  return [end(low, -1), end(high, 1)];
}

// As many powers of ten as are shown below the largest number; the rest is seen where one zooms.
const most_decades = 8;

function decades(lists: Numbers[]): Range {
  const [low, high] = extremes(lists);
  if (low > high) return [0.1, 1];
  const top = high * 1.5;
  return [Math.max(low / 1.5, top / 10 ** most_decades), top];
}
