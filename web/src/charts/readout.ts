// SPDX-License-Identifier: BSD-3-Clause
import { history_row } from "../data";
import { element } from "../element";
import type { Trace } from "./plan";
import { line_sample } from "./run_style";
import { argument_axis, value_axis } from "./scene";
import type { Scene } from "./scene";
import { five_digits } from "./ticks";

/** One row for each trace: the numbers at its point `picked`. Cells carry the number in SI units, its column, and its row of history.csv. */
export function readout(scene: Scene, picked: (number | null)[]): HTMLTableElement {
  const argument = argument_axis(scene), value = value_axis(scene);
  const has_mean = scene.traces.some((trace) => trace.mean !== null);
  const over_time = scene.plan.argument.kind === "time";
  const heads = ["time (s)", ...(over_time ? [] : [argument.short]), value.short, ...(has_mean ? [`${value.short}, mean`] : [])];
  const head = element("tr", {}, element("th", { scope: "col" }, scene.plan.by_run ? "run" : ""), element("th", { scope: "col", class: "number chart_row" }, "row"));
  for (const text of heads) head.append(element("th", { scope: "col", class: "number" }, text));
  const body = element("tbody");
  scene.traces.forEach((trace, index) => {
    const name = element("th", { scope: "row" }, line_sample(trace.style), " ", element("span", {}, trace.label));
    const at = picked[index];
    const row = element("tr", {}, name);
    body.append(row);
    if (at === null || at === undefined) {
      for (const text of ["row", ...heads]) row.append(element("td", { class: text === "row" ? "number chart_row" : "number" }, "\u2013"));
      return;
    }
    const row_of_file = history_row(trace.run, trace.rows[at]);
    const cell = (column: string, si: number | null, factor: number) =>
      row.append(element(
        "td",
        { class: "number", "data-run": trace.run.name, "data-row": row_of_file, "data-column": column, "data-value": si },
        si === null ? "\u2013" : five_digits(si * factor),
      ));
    row.append(element("td", { class: "number quiet chart_row" }, String(row_of_file)));
    cell("time_s", time_of(trace, at), 1);
    if (!over_time) cell(trace.argument_column, trace.argument[at], argument.unit.factor(trace.run)!);
    cell(trace.value_column, trace.value[at], value.unit.factor(trace.run)!);
    if (has_mean) cell(`${trace.value_column} mean`, trace.mean?.[at] ?? null, value.unit.factor(trace.run)!);
  });
  return element("table", { class: "chart_readout" }, element("thead", {}, head), body);
}

export function time_of(trace: Trace, at: number): number | null {
  return trace.run.columns.time_s?.[trace.rows[at]] ?? null;
}
