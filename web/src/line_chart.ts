// SPDX-License-Identifier: BSD-3-Clause
// A quantity of the line over x: at a moment, with the ends of the stages that are over behind it; or at the ends of all stages.
import { svg_element } from "./element";
import { make } from "./film_elements";
import { digits, type Unit } from "./film_numbers";
import { ChartArea, drawing, roomy } from "./line_drawing";
import { extremes, type LineRun, type LineShapes, type QuantityOfLine, shape_at, type Values } from "./line_shapes";
import { type StageEnd, warmth_of } from "./line_stages";

/** px of the page */
const margin = { left: 52, right: 12, top: 8, bottom: 18 }, height_of_title = 14;
const usual_height = 92;
/** Parts of an axis that stay free at its ends. */
const room = 0.06, room_for_peaks = 0.26;

/** What a chart shows. */
export interface Look {
  name: string;
  /** What it is called, with its unit. */
  words: (unit: string) => string;
  curves: QuantityOfLine[];
  unit: (largest: number) => Unit;
  /** Whether it shows the line to its far ends; else where the line moves sideways. */
  whole?: boolean;
  /** Whether x stands below it. */
  titled?: boolean;
  /** Whether the number that is farthest from zero stands beside its place. */
  peaks?: boolean;
}

export class LineChart {
  readonly element: HTMLElement;
  protected area!: ChartArea;
  protected readonly x: Values;
  /** By curve and frame, in the unit of the axis. */
  protected readonly values: Values[][];
  protected readonly unit: Unit;
  private title = make("p", "line_words");
  private holder = make("div", "line_holder");
  private below = svg_element("g");
  private trail = svg_element("g");
  private now = svg_element("g");
  private trail_of = "";

  constructor(private readonly look: Look, protected readonly run: LineRun, shapes: LineShapes, protected readonly ends: StageEnd[]) {
    this.x = shapes.x;
    const frames = look.curves.map((quantity) => shapes[quantity]);
    this.unit = look.unit(Math.max(...frames.flatMap((values) => extremes(this.x, values, this.far).map(Math.abs))));
    this.values = frames.map((list) => list.map((values) => values.map((value) => value / this.unit.factor)));
    this.element = make("div", `line_chart line_chart_${look.name}`, this.title, this.holder);
  }

  /** Draws the axes, which hold all frames, for a width. */
  lay_out(width: number): void {
    const { look, far, near } = this, plot = width - margin.left - margin.right;
    const range = roomy(this.range(), look.peaks ? room_for_peaks : room);
    const height = this.height((range[1] - range[0]) * this.unit.factor, plot / (far - near));
    const box = { left: margin.left, top: margin.top, width: plot, height };
    this.area = new ChartArea(box, { range: [near, far], ticks: plot / 90, title: look.titled ? "x (m)" : undefined }, { range, ticks: height / 34 });
    this.area.inside.append(this.below, this.trail, this.now);
    this.trail_of = "";
    this.title.textContent = this.words(look.words(this.unit.name));
    const svg = drawing(width, margin.top + height + margin.bottom + (look.titled ? height_of_title : 0), this.title.textContent);
    svg.append(this.area.element, ...this.above());
    this.holder.replaceChildren(svg);
  }

  /** A moment; null: the ends of all stages. */
  show(at: number | null): void {
    const over = this.ends.filter(({ frame }) => at === null || frame < at), trail_of = `${at === null} ${over.length}`;
    if (this.trail_of !== trail_of) {
      this.trail.replaceChildren(...over.flatMap((end) => this.curves(end.frame, `line_end ${end.warmth}`, end.dash)));
      this.trail.setAttribute("class", at === null ? "" : "line_trail");
      this.trail_of = trail_of;
    }
    this.below.replaceChildren(...this.extras(at));
    this.now.replaceChildren(...(at === null ? [] : this.at_moment(at)));
  }

  /** px; `length`: what the axis upwards reaches over, in SI. */
  protected height(_length: number, _px_per_metre: number): number {
    return usual_height;
  }

  protected words(words: string): string {
    return words;
  }

  /** What the numbers of all frames reach over, in the unit of the axis. */
  protected range(): [low: number, high: number] {
    const all = this.values.map((frames) => extremes(this.x, frames, this.far));
    return [Math.min(...all.map(([low]) => low)), Math.max(...all.map(([, high]) => high))];
  }

  /** What lies below the curves. */
  protected extras(_at: number | null): SVGElement[] {
    return [];
  }

  /** What lies above all. */
  protected above(): SVGElement[] {
    return [];
  }

  private get far(): number {
    return this.look.whole ? this.x[this.x.length - 1] : this.run.line.region;
  }

  /** Where the drawing begins: at x = 0 where the line does. */
  private get near(): number {
    return this.run.line.half === "none" ? 0 : -this.far;
  }

  private curves(at: number, look: string, dash = ""): SVGPathElement[] {
    return this.values.map((frames) => this.area.path({ look, dash, x: this.x, y: shape_at(frames, at) }));
  }

  private at_moment(at: number): SVGElement[] {
    const curves = this.curves(at, `line_now ${warmth_of(this.ends, this.run.line.frames[Math.ceil(at)].stage)}`);
    return this.look.peaks ? [...curves, ...this.values.flatMap((frames) => this.peak(shape_at(frames, at)))] : curves;
  }

  /** The number that is farthest from zero, from the middle of the line on: that of the other half is the same. */
  private peak(y: Values): SVGElement[] {
    const middle = this.run.line.half === "none" ? 0 : (y.length - 1) / 2, half = y.subarray(middle);
    const node = half.reduce((best, value, i) => (Math.abs(value) > Math.abs(half[best]) ? i : best), 0);
    if (half[node] === 0) return [];
    const cx = this.area.x(this.x[middle + node]), cy = this.area.y(half[node]);
    const label = svg_element("text", { x: cx, y: half[node] > 0 ? cy - 6 : cy + 14, "text-anchor": "middle", class: "line_peak" }, digits(half[node]));
    return [svg_element("circle", { cx, cy, r: 3, class: "line_dot" }), label];
  }
}
