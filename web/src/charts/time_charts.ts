// SPDX-License-Identifier: BSD-3-Clause
// What is seen over time: energies, what tells whether a run is quasi-static, the quality of the contact; and any column over any other.
import type { RunData } from "../data";
import { combined, plan, run_traces } from "./plan";
import type { Curve, Numbers, Plan, PlanMark } from "./plan";
import { quantity_of_column, ratio } from "./quantity";
import { run_style } from "./run_style";

const time = quantity_of_column("time_s");
const energies = ["external_J_m", "internal_J_m", "friction_J_m", "damping_J_m", "kinetic_J_m", "energy_error_J_m"];
// Finite elements move without inertia; history.csv has zeros there.
const not_of_fem = ["kinetic_J_m", "damping_J_m", "gap_m", "second_impulse_N_m"];

function column(run: RunData, name: string): Numbers | null {
  return run.method === "fem" && not_of_fem.includes(name) ? null : run.columns[name] ?? null;
}

function over(run: RunData, argument: string, value: Numbers | null, value_column: string): Curve | null {
  const along = run.columns[argument];
  if (along === undefined || value === null) return null;
  return { rows: along.map((_, row) => row), argument: along, value, mean: null, argument_column: argument, value_column };
}

/** Runs whose energies can be shown. */
export function runs_with_energies(runs: RunData[]): RunData[] {
  return runs.filter((run) => energies.some((name) => column(run, name)?.some((value) => value !== null && value !== 0)));
}

/** All energies of one run. */
export function energy_plan(run: RunData): Plan {
  return plan({
    id: "energies", title: `Energies and work of ${run.name}`, argument: time, value: { words: "energy", symbol: "", kind: "energy", unit: "J/m" }, by_run: false,
    traces: energies.flatMap((name, index) => {
      const curve = over(run, "time_s", column(run, name), name);
      return curve === null ? [] : [{ ...curve, label: quantity_of_column(name).words, style: run_style(index), run }];
    }),
    marks: stage_marks(run),
  });
}

function stage_marks(run: RunData): PlanMark[] {
  return run.stage.flatMap((stage, row) =>
    row > 0 && stage === run.stage[row - 1] ? [] : [{ argument: run.columns.time_s[Math.max(0, row - 1)], value: null, label: stage, of_paper: false }]);
}

/** Whether runs are slow enough, and how near to equilibrium the soil is. */
export function quiet_plans(runs: RunData[]): Plan[] {
  const positive = (values: Numbers | null) => values?.map((value) => (value !== null && value > 0 ? value : null)) ?? null;
  return [
    plan({
      id: "kinetic_over_internal", title: "Kinetic over internal energy", argument: time, value: ratio("kinetic/internal energy", ""), logarithmic: true,
      traces: run_traces(runs, (run) => {
        const kinetic = column(run, "kinetic_J_m"), internal = column(run, "internal_J_m");
        return over(run, "time_s", kinetic && internal && positive(combined(kinetic, internal, (k, i) => k / i)), "kinetic_J_m/internal_J_m");
      }),
    }),
    plan({
      id: "out_of_balance", title: "Force out of balance over weight", argument: time, value: ratio("out of balance/weight", ""), logarithmic: true,
      traces: run_traces(runs, (run) => over(run, "time_s", positive(column(run, "out_of_balance")), "out_of_balance")),
    }),
  ];
}

/** How well the soil lies against the pipe. */
export function contact_plans(runs: RunData[]): Plan[] {
  const titles = { gap_m: "Gap between pipe and soil", overlap_m: "Overlap of soil and pipe", second_impulse_N_m: "Second contact correction" };
  return Object.entries(titles).map(([name, title]) =>
    plan({
      id: name.replace(/_(N_)?m$/, ""), title, argument: time, value: quantity_of_column(name), zero: true,
      traces: run_traces(runs, (run) => (run.diameter === null ? null : over(run, "time_s", column(run, name), name))),
    }));
}

/** Columns that any of the runs has numbers in. */
export function column_names(runs: RunData[]): string[] {
  return [...new Set(runs.flatMap((run) => Object.keys(run.columns)))];
}

/** Any column over any other. */
export function free_plan(runs: RunData[], argument: string, value: string): Plan {
  return plan({
    id: "any", title: `${value} over ${argument}`, argument: quantity_of_column(argument), value: quantity_of_column(value), in_plane: argument !== "time_s",
    traces: run_traces(runs, (run) => over(run, argument, run.columns[value] ?? null, value)),
  });
}
