// SPDX-License-Identifier: BSD-3-Clause
// Where charts mark that a run got a new mesh, by the data alone.
import assert from "node:assert/strict";
import { test } from "node:test";
import { drag_plans, push_plans } from "../src/charts/path_charts";
import { remeshed_at, was_remeshed } from "../src/charts/remeshings";
import { make_scene } from "../src/charts/scene";
import type { Settings } from "../src/charts/scene";
import { contact_plans, free_plan } from "../src/charts/time_charts";
import type { PageData, RunData } from "../src/data";

const settings: Settings = { units: "model", raw: true, published: true, hidden: new Set() };

/** A run that is pushed in rows 0 to 3 and dragged from row 3 on, remeshed in rows 2, 3 and 5; without counts it is by the other method. */
function made(counts: (number | null)[] | null = [0, 0, 1, 2, 2, 4]): RunData {
  const quantity = (label: string, unit: string) => ({ label, words: label, unit });
  const path = (rows: number[]) => ({ rows, u_begin: 0, V_mean: rows.map(() => 50), H_mean: rows.map(() => 20) });
  const columns: RunData["columns"] = {
    time_s: [0, 1, 2, 3, 4, 5], u_m: [0, 0, 0, 0, 0.001, 0.002], w_m: [0, 0.001, 0.002, 0.003, 0.003, 0.003], gap_m: [0, 0, 0, 0, 0, 1e-3],
    V_N_m: [0, 10, 20, 50, 60, 90], H_N_m: [0, 0, 0, 0, 10, 20],
  };
  if (counts !== null) columns.remeshings = counts;
  return {
    name: counts === null ? "mpm" : "fem", title: "", method: counts === null ? "mpm" : "fem", diameter: 0.02, measure: null, prototype: null, of_test: false,
    quantities: {
      time_s: quantity("time", "s"), u_m: quantity("u", "m"), w_m: quantity("w", "m"), gap_m: quantity("gap", "m"), V_N_m: quantity("V", "N/m"), H_N_m: quantity("H", "N/m"),
    },
    columns, stage: ["push", "push", "push", "push", "drag", "drag"], row: null, push: path([0, 1, 2, 3]), drag: path([3, 4, 5]), lift: path([]), bands: [], film: null,
  };
}

function page_of(...runs: RunData[]): PageData {
  return { version: "", runs, published: [] };
}

function ticks(data: PageData, id: string, given = settings): number[] {
  const plan = [...push_plans(data), ...drag_plans(data), ...contact_plans(data.runs)].find((each) => each.id === id)!;
  return make_scene(plan, given, data.runs).remeshings.map((tick) => Number(tick.at.toPrecision(12)));
}

test("ticks_stand_where_the_count_rises", () => {
  const data = page_of(made(null), made());
  assert.deepEqual(ticks(data, "V_w"), [2, 3], "mm, along w");
  assert.deepEqual(ticks(data, "H_u"), [0, 2], "mm, along u");
  assert.deepEqual(ticks(data, "gap"), [2, 3, 5], "s");
});

test("only_runs_with_the_column_have_ticks", () => {
  assert.deepEqual(ticks(page_of(made(null)), "V_w"), []);
  assert.equal(was_remeshed(made(null)), false);
  assert.equal(was_remeshed(made([0, 0, 0, 0, 0, 0])), false);
  assert.equal(was_remeshed(made()), true);
});

test("a_count_that_is_not_known_makes_no_tick", () => {
  const run = made([0, null, 1, 2, null, 4]);
  assert.deepEqual(remeshed_at({ run, rows: [0, 1, 2, 3, 4, 5], argument: [0, 1, 2, 3, 4, 5] }), [3]);
  assert.deepEqual(remeshed_at({ run: made(), rows: [0, 1, 2, 3], argument: [0, 1, null, 3] }), [3]);
});

test("ticks_of_several_runs_stand_in_rows_and_go_with_their_run", () => {
  const data = page_of(made(null), made(), made());
  const plan = push_plans(data)[0];
  const scene = make_scene(plan, settings, data.runs);
  assert.deepEqual(scene.remeshings.map((tick) => tick.place), [0, 0, 1, 1]);
  assert.deepEqual(scene.remeshings[2].style, plan.traces[2].style);
  assert.equal(ticks(data, "V_w", { ...settings, hidden: new Set([data.runs[1]]) }).length, 2);
});

test("charts_whose_argument_is_no_travel_or_time_have_no_ticks", () => {
  const data = page_of(made());
  assert.deepEqual(make_scene(free_plan(data.runs, "V_N_m", "H_N_m"), settings, data.runs).remeshings, []);
  assert.deepEqual(ticks(data, "H_V"), []);
});
