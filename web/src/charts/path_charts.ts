// SPDX-License-Identifier: BSD-3-Clause
// What is seen over the path of the driven body: forces and embedment in the push and in the drag.
import type { BandData, PageData, PathData, RunData } from "../data";
import { at_rows, combined, published_marks, plan, run_traces } from "./plan";
import type { Curve, Numbers, Plan } from "./plan";
import { column_of_label, quantity_of_axis, quantity_of_column, ratio } from "./quantity";
import type { Quantity } from "./quantity";
import { run_style } from "./run_style";

/** u of the drags of all runs: of the point that the runs name where they name the same. */
function travel_of(data: PageData): Quantity {
  const words = new Set(data.runs.filter((run) => run.drag.rows.length > 0).map((run) => run.drag.u?.words));
  const [only] = words;
  return { words: words.size === 1 && only !== undefined ? only : "horizontal travel", symbol: "u", kind: "length", unit: "m" };
}

type CurveOf = (run: RunData) => Curve | null;

/** The columns that the runs have of a force: per metre in plane strain, whole around an axis and in space. Each has charts of its own; the first keeps its id. */
function force_columns(data: PageData, label: string): { name: string; suffix: string; title: string }[] {
  const names = data.runs.map((run) => column_of_label(run, label)).filter((name) => name !== undefined);
  const distinct = [...new Set(names)];
  if (distinct.length === 0) distinct.push(`${label}_N_m`);
  return distinct.map((name, i) => ({
    name, suffix: i === 0 ? "" : `_${i + 1}`, title: distinct.length === 1 ? "" : `, ${name.endsWith("_m") ? "per metre" : "whole bodies"}`,
  }));
}

/** The charts of the push. */
export function push_plans(data: PageData): Plan[] {
  return force_columns(data, "V").flatMap(({ name: V, suffix, title }) => {
    const embedment = quantity_of_column(data.runs, "w_m"), vertical = quantity_of_column(data.runs, V);
    const traces = (curve: CurveOf) => run_traces(data.runs, curve);
    const over_depth = (run: RunData, value: Numbers | null, value_column: string, mean: Numbers | null) =>
      curve_of(run, run.push, at_rows(run, "w_m", run.push.rows), "w_m", value, value_column, mean);
    return [
      plan({
        id: `V_w${suffix}`, title: `Push: V(w)${title}`, argument: embedment, value: vertical, upright: true, zero: true,
        traces: traces((run) => with_band(over_depth(run, at_rows(run, V, run.push.rows), V, run.push.V_mean), run, "V_w")),
        marks: published_marks(data, "V_w"),
      }),
      plan({
        id: `V_noise${suffix}`, title: `Noise of V in the push${title}`, argument: embedment,
        value: { ...vertical, words: "vertical reaction minus its mean", symbol: "\u0394V" },
        traces: traces((run) => over_depth(run, noise(at_rows(run, V, run.push.rows), run.push.V_mean), `${V} - V_mean`, null)),
      }),
    ];
  });
}

/** The charts of the drag. */
export function drag_plans(data: PageData): Plan[] {
  const embedment = quantity_of_column(data.runs, "w_m");
  const traces = (curve: CurveOf) => run_traces(data.runs, curve);
  const over_travel = (run: RunData, value: Numbers | null, value_column: string, mean: Numbers | null) =>
    curve_of(run, run.drag, travelled(run), run.drag.u?.words ?? "u_m - u_begin", value, value_column, mean);
  const column = (run: RunData, name: string) => at_rows(run, name, run.drag.rows);
  const of_label = (run: RunData, label: string) => column_of_label(run, label) ?? "";
  const common = { argument: travel_of(data), zero: true };
  const forces = force_columns(data, "H");
  const horizontal = (H: string) => quantity_of_column(data.runs, H);
  return [
    ...forces.map(({ name: H, suffix, title }) => plan({
      ...common, id: `H_u${suffix}`, title: `Drag: H(u)${title}`, value: horizontal(H),
      traces: traces((run) => with_band(over_travel(run, column(run, H), H, run.drag.H_mean), run, "H_u")),
      marks: published_marks(data, "H_u"),
    })),
    plan({
      ...common, id: "w_u", title: "Drag: w(u)", value: embedment, value_downwards: true,
      traces: traces((run) => with_band(over_travel(run, column(run, "w_m"), "w_m", null), run, "w_u")),
      marks: published_marks(data, "w_u"),
    }),
    plan({
      ...common, id: "H_over_V", title: "Drag: H/V", value: ratio("ratio of forces", "H/V"),
      traces: traces((run) => {
        const H = of_label(run, "H"), V = of_label(run, "V");
        return over_travel(run, quotient(column(run, H), column(run, V)), `${H}/${V}`, quotient(run.drag.H_mean, run.drag.V_mean));
      }),
    }),
    ...forces.map(({ name: H, suffix, title }) => plan({
      id: `H_V${suffix}`, title: `Drag: path of H against V${title}`, argument: quantity_of_column(data.runs, H.replace("H", "V")), value: horizontal(H),
      zero: true, in_plane: true,
      traces: traces((run) => {
        if (of_label(run, "H") !== H) return null;
        const by_row = !is_known(run.drag.V_mean), along = H.replace("H", "V");  // rows where a mean says nothing
        const [across, up] = by_row ? [column(run, along), column(run, H)] : [run.drag.V_mean, run.drag.H_mean];
        return varies(across) ? curve_of(run, run.drag, across, by_row ? along : "V_mean", up, by_row ? H : "H_mean", null) : null;
      }),
    })),
    ...forces.map(({ name: H, suffix, title }) => plan({
      ...common, id: `H_noise${suffix}`, title: `Noise of H in the drag${title}`, zero: false,
      value: { ...horizontal(H), words: "horizontal resistance minus its mean", symbol: "\u0394H" },
      traces: traces((run) => over_travel(run, noise(column(run, H), run.drag.H_mean), `${H} - H_mean`, null)),
    })),
  ];
}

/** The charts that structures have by themselves, of each run its own; curves of one name look the same in all of them. */
export function own_plans(data: PageData): Plan[] {
  const names = (run: RunData) => [...new Set((run.charts ?? []).flatMap((chart) => chart.curves.map((curve) => curve.name)))];
  return data.runs.flatMap((run, index) => (run.charts ?? []).map((chart) => plan({
    id: index === 0 ? chart.chart : `${chart.chart}_${index + 1}`, title: data.runs.length === 1 ? chart.title : `${run.name}: ${chart.title}`,
    argument: quantity_of_axis(chart.x), value: quantity_of_axis(chart.y), by_run: false, in_plane: true, zero: true,
    traces: chart.curves.map(({ name, rows, x, y, smoothed = null }) => ({
      rows, argument: x, value: y, mean: is_known(smoothed) ? smoothed : null, argument_column: chart.x.symbol, value_column: chart.y.symbol,
      label: name, style: run_style(names(run).indexOf(name)), run,
    })),
  })));
}

/** Whether a chart of a run shows the shape of the ground, not what a structure is asked for. */
export function is_of_ground(plan: Plan): boolean {
  return /^ground(_\d+)?$/.test(plan.id);
}

/** The chart of a body that is lifted, as an uplift resistance is read: R = -V. */
export function lift_plans(data: PageData): Plan[] {
  const upwards: Quantity = { words: "travel upwards", symbol: "s", kind: "length", unit: "m" };
  return force_columns(data, "V").map(({ name: V, suffix, title }) => plan({
    id: `R_lift${suffix}`, title: `Lift: R(s)${title}`, argument: upwards, zero: true,
    value: { ...quantity_of_column(data.runs, V), words: "uplift resistance", symbol: "R" },
    traces: run_traces(data.runs, (run) => {
      const w = at_rows(run, "w_m", run.lift.rows), negative = (values: Numbers | null) => values?.map((each) => (each === null ? null : -each)) ?? null;
      const travelled_up = w === null || w.length === 0 ? null : w.map((each) => (each === null ? null : (w[0] ?? 0) - each));
      return curve_of(run, run.lift, travelled_up, "w_begin - w_m", negative(at_rows(run, V, run.lift.rows)), `-${V}`, negative(run.lift.V_mean));
    }),
  }));
}

function curve_of(
  run: RunData, path: PathData, argument: Numbers | null, argument_column: string, value: Numbers | null, value_column: string, mean: Numbers | null,
): Curve | null {
  if (run.diameter === null || argument === null || value === null) return null;
  return { rows: path.rows, argument, value, mean: is_known(mean) ? mean : null, argument_column, value_column };
}

function is_known(values: Numbers | null): boolean {
  return values?.some((each) => each !== null) ?? false;
}

/** The curve with the run's bands of a chart: each along its low side and back along the high one. */
function with_band(curve: Curve | null, run: RunData, chart: BandData["chart"]): Curve | null {
  const bands = run.bands.filter((band) => band.chart === chart);
  if (curve === null || bands.length === 0) return curve;
  const argument: Numbers = [], value: Numbers = [];
  for (const band of bands) {
    const known = band.x.flatMap((x, i) => (x === null || band.low[i] === null || band.high[i] === null ? [] : [{ x, low: band.low[i], high: band.high[i] }]));
    const back = [...known].reverse();
    argument.push(...known.map((each) => each.x), ...back.map((each) => each.x), null);
    value.push(...known.map((each) => each.low), ...back.map((each) => each.high), null);
  }
  return { ...curve, band: { argument, value } };
}

/** Where V is held the path of forces is an upright line, which says nothing. */
function varies(V: Numbers | null): boolean {
  const known = (V ?? []).filter((each) => each !== null);
  return known.length > 0 && Math.min(...known) < 0.75 * Math.max(...known);
}

function travelled(run: RunData): Numbers | null {
  if (run.drag.u !== undefined) return run.drag.u.values;
  const u = at_rows(run, "u_m", run.drag.rows);
  return u === null ? null : u.map((each) => (each === null ? null : each - run.drag.u_begin));
}

function noise(values: Numbers | null, mean: Numbers): Numbers | null {
  return values === null ? null : combined(values, mean, (value, smooth) => value - smooth);
}

/** a / b, where b is more than a hundredth of its largest: what is left of a force says nothing. */
function quotient(a: Numbers | null, b: Numbers | null): Numbers | null {
  if (a === null || b === null) return null;
  const least = 0.01 * Math.max(...b.map((each) => Math.abs(each ?? 0)));
  return combined(a, b, (above, below) => (Math.abs(below) > least ? above / below : NaN));
}
