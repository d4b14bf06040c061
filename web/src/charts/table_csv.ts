// SPDX-License-Identifier: BSD-3-Clause
import { history_row } from "../data";
import { argument_axis, value_axis } from "./scene";
import type { Scene } from "./scene";
import { time_of } from "./readout";

/** All rows of the shown traces, unrounded, in the units of the axes. */
export function table_csv(scene: Scene): string {
  const argument = argument_axis(scene), value = value_axis(scene);
  const has_mean = scene.traces.some((trace) => trace.mean !== null);
  const over_time = scene.plan.argument.kind === "time";
  const lines: (string | number | null)[][] = [
    [...(scene.plan.by_run ? ["run"] : ["run", "of"]), "row", "stage", "time (s)", ...(over_time ? [] : [argument.title]), value.title, ...(has_mean ? [`${value.title}, smoothed`] : [])],
  ];
  for (const trace of scene.traces) {
    const along = argument.unit.factor(trace.run)!, of = value.unit.factor(trace.run)!;
    const times = (number: number | null | undefined, factor: number) => (number === null || number === undefined ? null : number * factor);
    trace.rows.forEach((row, i) => {
      lines.push([
        ...(scene.plan.by_run ? [trace.run.name] : [trace.run.name, trace.label]),
        history_row(trace.run, row),
        trace.run.stage[row],
        time_of(trace, i),
        ...(over_time ? [] : [times(trace.argument[i], along)]),
        times(trace.value[i], of),
        ...(has_mean ? [times(trace.mean?.[i], of)] : []),
      ]);
    });
  }
  return lines.map((line, i) => line.map((each) => field(i === 0 ? plain(String(each)) : each)).join(",") + "\n").join("");
}

// Letters that every program reads, for the heads of columns.
function plain(text: string): string {
  return text.replaceAll("\u03b3\u2032", "gamma'").replaceAll("\u00b2", "^2").replaceAll("\u00b3", "^3").replaceAll("\u0394", "delta ");
}

function field(value: string | number | null): string {
  const text = value === null ? "" : String(value);
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
