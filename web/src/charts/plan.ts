// SPDX-License-Identifier: BSD-3-Clause
import type { PageData, PublishedPoint, RunData } from "../data";
import type { Quantity } from "./quantity";
import { run_style } from "./run_style";
import type { RunStyle } from "./run_style";

export type Numbers = (number | null)[];

/** Numbers of a run over one another, in SI units, one for each of `rows`. */
export interface Curve {
  /** Rows of the run's columns. */
  rows: number[];
  argument: Numbers;
  value: Numbers;
  /** The values freed from noise. */
  mean: Numbers | null;
  /** Columns of history.csv, or how they are made of them. */
  argument_column: string;
  value_column: string;
  /** The outlines of bands in which the curve is sure to lie, a gap between two of them. */
  band?: { argument: Numbers; value: Numbers };
}

/** A curve with its name and look. */
export interface Trace extends Curve {
  label: string;
  style: RunStyle;
  run: RunData;
}

/** A point (or, where one of both is null, a level) with a label, in SI units of the model. */
export interface PlanMark {
  argument: number | null;
  value: number | null;
  label: string;
  published: boolean;
}

/** What a chart shows, whatever the units and whatever is switched off. */
export interface Plan {
  id: string;
  title: string;
  argument: Quantity;
  value: Quantity;
  /** The argument runs down the y axis, as depth does in the ground; else along x. */
  upright: boolean;
  value_downwards: boolean;
  logarithmic: boolean;
  /** The range holds zero. */
  zero: boolean;
  /** The row at the cursor is the nearest in the plane; else the nearest along the argument. */
  in_plane: boolean;
  /** Traces are runs, which the legend turns on and off. */
  by_run: boolean;
  traces: Trace[];
  marks: PlanMark[];
}

/** A plan with what most charts have. */
export function plan(given: Pick<Plan, "id" | "title" | "argument" | "value" | "traces"> & Partial<Plan>): Plan {
  return { upright: false, value_downwards: false, logarithmic: false, zero: false, in_plane: false, by_run: true, marks: [], ...given };
}

/** Traces of all runs that have such a curve. */
export function run_traces(runs: RunData[], curve: (run: RunData) => Curve | null): Trace[] {
  return runs.flatMap((run, index) => {
    const found = curve(run);
    if (found === null || !found.value.some((value, i) => value !== null && found.argument[i] !== null)) return [];
    return [{ ...found, label: run.name, style: run_style(index), run }];
  });
}

/** Published numbers of a chart; those of a drag are for one along x, and mirrored where the runs go the other way. */
export function published_marks(data: PageData, chart: PublishedPoint["chart"]): PlanMark[] {
  const run = data.runs.find((each) => each.of_test && each.drag.rows.length > 0) ?? data.runs.find((each) => each.drag.rows.length > 0);
  const along = chart === "V_w" || run === undefined ? 1 : direction(run);
  return data.published.filter((point) => point.chart === chart).map((point) => ({
    argument: point.x === null ? null : along * point.x, value: chart === "H_u" ? along * point.y : point.y, label: point.label, published: true,
  }));
}

/** 1 where the first drag of a run goes along x, -1 where it goes against x. */
function direction(run: RunData): number {
  const u = at_rows(run, "u_m", run.drag.rows) ?? [];
  const first = u.find((each) => each !== null && Math.abs(each - run.drag.u_begin) > 1e-3 * (run.diameter ?? 1));
  return first !== undefined && first !== null && first < run.drag.u_begin ? -1 : 1;
}

/** A column at some rows; null where the run has no such column. */
export function at_rows(run: RunData, column: string, rows: number[]): Numbers | null {
  const values = run.columns[column];
  return values === undefined ? null : rows.map((row) => values[row]);
}

/** a(i) of one number and another, null where one is missing or what it makes is not finite. */
export function combined(a: Numbers, b: Numbers, make: (a: number, b: number) => number): Numbers {
  return a.map((each, i) => {
    const other = b[i];
    if (each === null || other === null) return null;
    const made = make(each, other);
    return Number.isFinite(made) ? made : null;
  });
}
