// SPDX-License-Identifier: BSD-3-Clause
// Bending moment, strain and compression along the line. The units are those of the table of the line's answers.
import { LineChart, type Look } from "./line_chart";
import { column_at, type LineRun, type LineShapes, time_at } from "./line_shapes";
import type { StageEnd } from "./line_stages";

const moment: Look = { name: "M", words: (unit) => `Bending moment M (${unit})`, curves: ["M"], unit: () => ({ name: "kN m", factor: 1e3 }), peaks: true };
const strain: Look = {
  name: "strain", words: (unit) => `Longitudinal strain (${unit}), the largest and the smallest of each section`, curves: ["strain_max", "strain_min"],
  unit: () => ({ name: "%", factor: 0.01 }), titled: true, peaks: true,
};
const compression: Look = {
  name: "P", words: (unit) => `Effective compression P (${unit}) of the whole line. Dashed: P\u2080, that of a fully constrained length`, curves: ["P"],
  unit: () => ({ name: "kN", factor: 1e3 }), whole: true, titled: true,
};

export function charts_below_plan(run: LineRun, shapes: LineShapes, ends: StageEnd[]): LineChart[] {
  return [new LineChart(moment, run, shapes, ends), new LineChart(strain, run, shapes, ends), new CompressionChart(compression, run, shapes, ends)];
}

class CompressionChart extends LineChart {
  protected override range(): [low: number, high: number] {
    const [low, high] = super.range(), constrained = (this.run.columns.line_P0_N ?? []).map((value) => (value ?? 0) / this.unit.factor);
    return [Math.min(low, ...constrained), Math.max(high, ...constrained)];
  }

  /** The compression of a length that cannot get longer, at the moment or at the ends of stages. */
  protected override extras(at: number | null): SVGElement[] {
    const moments = at === null ? this.ends.map((end) => end.frame) : [at], ends = [this.x[0], this.x[this.x.length - 1]];
    const levels = new Set(moments.flatMap((each) => column_at(this.run, "line_P0_N", time_at(this.run.line, each)) ?? []));
    return [...levels].map((level) => this.area.path({ look: "line_constrained", dash: "6 4", x: ends, y: ends.map(() => level / this.unit.factor) }));
  }
}
