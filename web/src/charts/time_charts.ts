// SPDX-License-Identifier: BSD-3-Clause
// What is seen over time: energies, what tells whether a run is quasi-static, the quality of the contact; and any column over any other.
import type { RunData } from "../data";
import { combined, plan, run_traces } from "./plan";
import type { Curve, Numbers, Plan, PlanMark } from "./plan";
import { column_of_label, quantity_of_column, ratio } from "./quantity";
import { run_style } from "./run_style";

const energies = ["external", "internal", "friction", "damping", "kinetic", "energy error"];

function column(run: RunData, label: string): Numbers | null {
  return run.columns[column_of_label(run, label) ?? ""] ?? null;
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
    id: "energies", title: `Energies and work of ${run.name}`, argument: quantity_of_column([run], "time_s"), value: { ...quantity_of_column([run], column_of_label(run, "internal") ?? ""), words: "energy" }, by_run: false,
    traces: energies.flatMap((label, index) => {
      const name = column_of_label(run, label) ?? "";
      const curve = over(run, "time_s", column(run, label), name);
      return curve === null ? [] : [{ ...curve, label: quantity_of_column([run], name).words, style: run_style(index), run }];
    }),
    marks: stage_marks(run),
  });
}

function stage_marks(run: RunData): PlanMark[] {
  return run.stage.flatMap((stage, row) =>
    row > 0 && stage === run.stage[row - 1] ? [] : [{ argument: run.columns.time_s[Math.max(0, row - 1)], value: null, label: stage, published: false }]);
}

/** Whether runs are slow enough, and how near to equilibrium the soil is. */
export function quiet_plans(runs: RunData[]): Plan[] {
  const time = quantity_of_column(runs, "time_s");
  const positive = (values: Numbers | null) => values?.map((value) => (value !== null && value > 0 ? value : null)) ?? null;
  return [
    plan({
      id: "kinetic_over_internal", title: "Kinetic / internal energy", argument: time, value: ratio("kinetic/internal energy", ""), logarithmic: true,
      traces: run_traces(runs, (run) => {
        const kinetic = column(run, "kinetic"), internal = column(run, "internal");
        const columns = `${column_of_label(run, "kinetic")}/${column_of_label(run, "internal")}`;
        return over(run, "time_s", kinetic && internal && positive(combined(kinetic, internal, (k, i) => k / i)), columns);
      }),
    }),
    plan({
      id: "out_of_balance", title: "Out-of-balance force / weight", argument: time, value: ratio("out of balance/weight", ""), logarithmic: true,
      traces: run_traces(runs, (run) => over(run, "time_s", positive(column(run, "out of balance")), "out_of_balance")),
    }),
  ];
}

/** Pressure of the water in the pores: the largest of the run, that at each point that is watched, the degree of consolidation since each stage began, and what presses the body. */
export function water_plans(runs: RunData[]): Plan[] {
  const time = quantity_of_column(runs, "time_s");
  const marks = runs.length === 1 ? stage_marks(runs[0]) : [];
  const is_in_a_pipe = (name: string) => runs.some((run) => run.line !== undefined && name === "line_p_Pa");
  const watched = column_names(runs).filter((name) => / p$/.test(label_of(runs, name)) && !is_in_a_pipe(name));
  const pressures = watched.map((name): [string, string] => [name, `Excess pore pressure at ${label_of(runs, name).replace(/ p$/, "")}`]);
  const normal = column_names(runs).filter((name) => label_of(runs, name) === "N eff").map((name): [string, string] => [name, "Effective normal force on the body"]);
  return [...pressures, ...normal, ["p_max_Pa", "Largest excess pore pressure"], ["U", "Degree of consolidation U, of each stage"]].map(([name, title]) =>
    plan({
      id: `water_${name}`, title, argument: time, zero: true, marks,
      value: watched.includes(name) ? { ...quantity_of_column(runs, name), words: "excess pore pressure", symbol: "p" } : quantity_of_column(runs, name),
      traces: run_traces(runs, (run) => over(run, "time_s", run.columns[name] ?? null, name)),
    }));
}

function label_of(runs: RunData[], column: string): string {
  return runs.find((run) => column in run.quantities)?.quantities[column].label ?? "";
}

/** How well the soil lies against the rigid body. */
export function contact_plans(runs: RunData[]): Plan[] {
  const titles = { gap: "Gap between body and soil", overlap: "Overlap of soil and body", "second impulse": "Second contact correction" };
  return Object.entries(titles).map(([label, title]) => {
    const name = runs.map((run) => column_of_label(run, label)).find((each) => each !== undefined) ?? "";
    return plan({
      id: label.replace(" ", "_"), title, argument: quantity_of_column(runs, "time_s"), value: quantity_of_column(runs, name), zero: true,
      traces: run_traces(runs, (run) => (run.diameter === null ? null : over(run, "time_s", column(run, label), name))),
    });
  });
}

/** Columns that any of the runs has numbers in. */
export function column_names(runs: RunData[]): string[] {
  return [...new Set(runs.flatMap((run) => Object.keys(run.columns)))];
}

/** Any column over any other. */
export function free_plan(runs: RunData[], argument: string, value: string): Plan {
  return plan({
    id: "any", title: `${value} against ${argument}`, argument: quantity_of_column(runs, argument), value: quantity_of_column(runs, value), in_plane: argument !== "time_s",
    traces: run_traces(runs, (run) => over(run, argument, run.columns[value] ?? null, value)),
  });
}
