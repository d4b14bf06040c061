// SPDX-License-Identifier: BSD-3-Clause
// Where published numbers and axes are, by the data alone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drag_plans, is_of_ground, own_plans, push_plans } from "../src/charts/path_charts";
import { published_marks } from "../src/charts/plan";
import { make_scene } from "../src/charts/scene";
import type { PageData, RunData } from "../src/data";

/** A run that is dragged from u = 2 mm to `to` (m), with H from `H[0]` to `H[1]`. */
function run_to(to: number, H: [number, number] = [-3, 100], V: [number, number] = [50, 50]): RunData {
  const quantity = (label: string, unit: string) => ({ label, words: label, unit });
  const path = (rows: number[]) => ({ rows, u_begin: 0.002, V_mean: rows.map((row) => V[row]), H_mean: rows.map((row) => H[row]) });
  return {
    name: "made", title: "", method: "mpm", diameter: 0.02, measure: null, prototype: null, of_test: true,
    quantities: { time_s: quantity("time", "s"), u_m: quantity("u", "m"), w_m: quantity("w", "m"), V_N_m: quantity("V", "N/m"), H_N_m: quantity("H", "N/m") },
    columns: { time_s: [0, 1], u_m: [0.002, to], w_m: [0.01, 0.02], V_N_m: V, H_N_m: H },
    stage: ["drag", "drag"], row: null, push: path([]), drag: path([0, 1]), lift: path([]), bands: [], film: null,
  };
}

function page_of(...runs: RunData[]): PageData {
  const point = (chart: "V_w" | "H_u" | "w_u", x: number | null, y: number) => ({ chart, x, y, label: "" });
  return { version: "", runs, published: [point("V_w", 0.002, 4000), point("H_u", null, 1000), point("H_u", 0.006, 500), point("w_u", 0.006, 0.005)] };
}

test("published_numbers_of_a_drag_lie_on_the_side_to_which_the_run_goes", () => {
  const places = (to: number, chart: "V_w" | "H_u" | "w_u") => published_marks(page_of(run_to(to)), chart).map((mark) => [mark.argument, mark.value]);
  assert.deepEqual(places(0.022, "H_u"), [[null, 1000], [0.006, 500]]);
  assert.deepEqual(places(-0.018, "H_u"), [[null, -1000], [-0.006, -500]]);
  assert.deepEqual(places(-0.018, "w_u"), [[-0.006, 0.005]], "w is a depth on either side");
  assert.deepEqual(places(-0.018, "V_w"), [[0.002, 4000]]);
});

test("axes_begin_where_the_data_begins", () => {
  const data = page_of(run_to(0.022));
  const plan = drag_plans(data).find((each) => each.id === "H_u")!;
  const scene = make_scene({ ...plan, marks: [] }, { units: "model", raw: true, published: true, hidden: new Set() }, data.runs);
  assert.equal(scene.x.full[0], 0);
  assert.equal(scene.y.full[0], -3, "noise about zero takes no margin");
  assert.ok(scene.y.full[1] > 100);
});

test("only_runs_whose_V_changes_have_a_path_of_H_against_V", () => {
  const falls = run_to(0.022, [0, 100], [100, 20]);
  const plan = drag_plans(page_of(run_to(0.022), falls)).find((each) => each.id === "H_V")!;
  assert.deepEqual(plan.traces.map((trace) => trace.run), [falls]);
});

/** The same run with ends: its forces are whole. */
function in_space(run: RunData): RunData {
  const { V_N_m, H_N_m, ...columns } = run.columns;
  const { V_N_m: V, H_N_m: H, ...quantities } = run.quantities;
  return { ...run, columns: { ...columns, V_N: V_N_m, H_N: H_N_m }, quantities: { ...quantities, V_N: { ...V, unit: "N" }, H_N: { ...H, unit: "N" } } };
}

test("runs_in_space_have_the_charts_of_a_drag_in_newtons", () => {
  const run = in_space(run_to(0.022, [0, 100], [100, 20])), plans = drag_plans(page_of(run));
  for (const id of ["H_u", "H_over_V", "H_V", "H_noise"]) assert.deepEqual(plans.find((each) => each.id === id)!.traces.map((trace) => trace.run), [run], id);
  assert.equal(plans.find((each) => each.id === "H_u")!.value.unit, "N");
  assert.equal(plans.find((each) => each.id === "H_V")!.argument.unit, "N");
});

test("forces_per_metre_and_whole_forces_have_charts_of_their_own", () => {
  const plane = run_to(0.022, [0, 100], [100, 20]), space = in_space(plane), data = page_of(space, plane);
  const of = (id: string) => [...drag_plans(data), ...push_plans(data)].find((each) => each.id === id)!;
  for (const [id, run, unit] of [["H_u", space, "N"], ["H_u_2", plane, "N/m"], ["H_V", space, "N"], ["H_V_2", plane, "N/m"]] as const) {
    assert.deepEqual(of(id).traces.map((trace) => trace.run), [run], id);
    assert.equal(of(id).value.unit, unit);
  }
  assert.deepEqual(of("H_over_V").traces.map((trace) => trace.run), [space, plane]);
  assert.equal(of("V_w").value.unit, "N");
  assert.equal(of("V_w_2").value.unit, "N/m");
});

test("u_of_a_body_that_turns_is_that_of_the_point_that_its_axis_names", () => {
  const run = run_to(0.022);
  run.drag.u = { words: "displacement at the bed", values: [0, 0.05] };
  const plan = drag_plans(page_of(run)).find((each) => each.id === "H_u")!;
  assert.equal(plan.argument.words, "displacement at the bed");
  assert.deepEqual(plan.traces[0].argument, [0, 0.05]);
  assert.equal(drag_plans(page_of(run, run_to(0.022)))[0].argument.words, "horizontal travel", "runs that name different points");
});

test("charts_of_a_structure_have_a_trace_for_each_curve", () => {
  const run = run_to(0.022), axis = (meaning: string, symbol: string, unit: string) => ({ meaning, symbol, unit });
  const curve = (name: string, to: number, smoothed: (number | null)[]) => ({ name, rows: [0, 1], x: [0, to], y: [0, 3 * to], smoothed });
  run.charts = [{ chart: "p_y", title: "p-y", x: axis("displacement", "y", "m"), y: axis("resistance", "p", "N/m"), curves: [curve("1 m", 2, [0, 6]), curve("3 m", 1, [null, null])] }];
  run.charts.push({ ...run.charts[0], chart: "deep", curves: [run.charts[0].curves[1]] });
  const [plan, deep] = own_plans(page_of(run));
  assert.deepEqual(deep.traces[0].style, plan.traces[1].style, "one name, one look");
  assert.deepEqual(plan.traces.map((trace) => [trace.label, trace.value, trace.mean]), [["1 m", [0, 6], [0, 6]], ["3 m", [0, 3], null]]);
  assert.equal(plan.value.kind, "force");
  assert.equal(plan.by_run, false);
});

test("the_ground_is_told_from_charts_of_a_structure", () => {
  const run = run_to(0.022), axis = { meaning: "", symbol: "x", unit: "m" };
  const curves = [{ name: "start", rows: [0, 0], x: [0, 1], y: [0, 0] }, { name: "drag", rows: [1, 1], x: [0, 1], y: [0, 0.1] }];
  run.charts = ["p_y", "ground"].map((chart) => ({ chart, title: chart, x: axis, y: axis, curves }));
  const plans = own_plans(page_of(run_to(0.022), run));
  assert.deepEqual(plans.map((plan) => [plan.id, is_of_ground(plan)]), [["p_y_2", false], ["ground_2", true]]);
  assert.deepEqual(plans[1].traces.map((trace) => [trace.label, trace.mean]), [["start", null], ["drag", null]]);
});

test("without_means_the_path_of_forces_is_that_of_the_rows", () => {
  const storm = run_to(0.022, [0, 100], [100, 20]);
  storm.drag.V_mean = storm.drag.H_mean = [null, null];
  const plans = drag_plans(page_of(storm));
  assert.deepEqual(plans.find((each) => each.id === "H_V")!.traces[0].value, [0, 100]);
  assert.equal(plans.find((each) => each.id === "H_u")!.traces[0].mean, null);
});
