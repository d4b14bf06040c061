// SPDX-License-Identifier: BSD-3-Clause
// What is known of a moment of a film, in numbers and words.
import type { FieldData, FrameData } from "./data";
import type { FilmedRun } from "./film_together";
import { digits, display_unit } from "./film_numbers";
import { frame_text } from "./film_transport";

/** A moment between two frames. */
export interface Moment {
  frame: number;
  part: number;
}

export function moment_at(run: FilmedRun, at: number): Moment {
  const frame = Math.min(Math.floor(at), run.film.frames.length - 1);
  return { frame, part: at - frame };
}

/** Names and values to show below the picture; a quantity that the run does not have is left out. */
export function readings(run: FilmedRun, at: number): [name: string, value: string][] {
  const shown: [string, string][] = [["stage", stage_at(run, at)], ["time", `${digits(quantity(run, at, "time")!, 4)} s`]];
  const length = (name: "u" | "w") => {
    const value = quantity(run, at, name);
    if (value === null) return;
    const of = name === "u" && run.drag.u !== undefined ? ` (${run.drag.u.words})` : "";
    if (run.diameter === null) shown.push([`${name}${of}`, `${digits(value * 1000)} mm`]);
    else shown.push([`${name}/D${of}`, (value / run.diameter).toFixed(3).replace("-", "−")]);
  };
  const force = (name: "H" | "V") => {
    const value = quantity(run, at, name);
    if (value === null) return;
    const unit = display_unit(run.film.forces, Math.max(...run.film.frames.map((frame) => Math.abs(frame[name] ?? 0))));
    shown.push([name, `${digits(value / unit.factor)} ${unit.name}`]);
  };
  length("u");
  length("w");
  force("H");
  force("V");
  return shown;
}

/** All in one sentence, for those who hear the page and for the caption of a saved picture. */
export function sentence(run: FilmedRun, field: FieldData | null, at: number): string {
  const numbers = readings(run, at).map(([name, value]) => (name === "stage" ? `stage ${value}` : `${name} = ${value}`));
  return `${run.name}: ${field === null ? "soil" : field.label}, ${frame_text(at, run.film.frames.length - 1)}, ${numbers.join(", ")}`;
}

function stage_at(run: FilmedRun, at: number): string {
  return run.film.frames[Math.ceil(at)]?.stage ?? "";
}

function quantity(run: FilmedRun, at: number, name: Exclude<keyof FrameData, "stage">): number | null {
  const { frame, part } = moment_at(run, at);
  const now = run.film.frames[frame][name];
  const next = run.film.frames[Math.min(frame + 1, run.film.frames.length - 1)][name];
  return now === null || next === null ? null : now + part * (next - now);
}
