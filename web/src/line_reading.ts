// SPDX-License-Identifier: BSD-3-Clause
// What is known of a moment of a line, in numbers and words. The units are those of the table of the line's answers.
import { digits } from "./film_numbers";
import { frame_text } from "./film_transport";
import { column_at, type LineRun, time_at } from "./line_shapes";

/** Names, columns of the history and units; those that are zero all the time are left out. */
const numbers_of_line: [name: string, column: string, unit: string, factor: number][] = [
  ["\u0394T", "line_T_K", "K", 1], ["pressure", "line_p_Pa", "MPa", 1e6], ["P\u2080", "line_P0_N", "kN", 1e3], ["P at x = 0", "line_P_N", "kN", 1e3],
  ["largest y", "line_y_m", "m", 1], ["at x", "line_x_m", "m", 1], ["largest M", "line_M_Nm", "kN m", 1e3],
  ["largest strain", "line_strain_max", "%", 0.01], ["smallest strain", "line_strain_min", "%", 0.01],
];

export function line_readings(run: LineRun, at: number): [name: string, value: string][] {
  const time = time_at(run.line, at);
  const known = numbers_of_line.filter(([, column]) => run.columns[column]?.some((value) => value !== null && value !== 0));
  return [
    ["stage", run.line.frames[Math.ceil(at)].stage], ["time", `${digits(time, 4)} s`],
    ...known.map(([name, column, unit, factor]): [string, string] => [name, number_at(run, column, time, unit, factor)]),
  ];
}

/** "y 1.87 m, M 578 kN m" at a frame. */
export function peaks_of(run: LineRun, frame: number): string {
  const { time } = run.line.frames[frame];
  return `y ${number_at(run, "line_y_m", time, "m", 1)}, M ${number_at(run, "line_M_Nm", time, "kN m", 1e3)}`;
}

/** All in one sentence, for those who hear the page. */
export function line_sentence(run: LineRun, at: number): string {
  const numbers = line_readings(run, at).map(([name, value]) => (name === "stage" ? `stage ${value}` : `${name} = ${value}`));
  return `${run.name}: line, ${frame_text(at, run.line.frames.length - 1)}, ${numbers.join(", ")}`;
}

function number_at(run: LineRun, column: string, time: number, unit: string, factor: number): string {
  const value = column_at(run, column, time);
  return value === null ? "\u2013" : `${digits(value / factor)} ${unit}`;
}
