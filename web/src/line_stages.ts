// SPDX-License-Identifier: BSD-3-Clause
// The stages that load a line: which are hot and which cold, and how their ends look.
import { svg_element } from "./element";
import { make } from "./film_elements";
import { peaks_of } from "./line_reading";
import { column_at, type LineRun } from "./line_shapes";

/** hot: compressed by more than half of the most of all stages; plain: no stage compresses the line. */
export type Warmth = "hot" | "cold" | "plain";

export interface StageEnd {
  name: string;
  frame: number;
  warmth: Warmth;
  /** Dashes tell apart the stages of one warmth: the first, the second, ... */
  dash: string;
}

const dashes = ["", "9 4", "2.5 3", "11 3 2.5 3", "5 2.5", "11 3 2.5 3 2.5 3"];

export function stage_ends(run: LineRun): StageEnd[] {
  const { ends, frames } = run.line;
  const compression = ends.map(({ frame }) => column_at(run, "line_P0_N", frames[frame].time) ?? 0);
  const most = Math.max(0, ...compression);
  const seen: Record<Warmth, number> = { hot: 0, cold: 0, plain: 0 };
  return ends.map(({ name, frame }, i) => {
    const warmth = most === 0 ? "plain" : compression[i] > most / 2 ? "hot" : "cold";
    return { name, frame, warmth, dash: dashes[seen[warmth]++ % dashes.length] };
  });
}

/** How warm a stage is, by its name; one that does not load the line is plain. */
export function warmth_of(ends: StageEnd[], stage: string): Warmth {
  return ends.find((end) => end.name === stage)?.warmth ?? "plain";
}

/** For a legend: a piece of its line, its name and what the line has come to. */
export function words_of_end(run: LineRun, end: StageEnd): HTMLElement {
  const piece = svg_element("path", { class: `line_curve line_end ${end.warmth}`, "stroke-dasharray": end.dash || null, d: "M0 5H30" });
  const sample = svg_element("svg", { width: 30, height: 10, "aria-hidden": "true", class: "line_drawing" }, piece);
  return make("span", "line_words_of_end", sample, ` ${end.name} `, make("span", "quiet", peaks_of(run, end.frame)));
}
