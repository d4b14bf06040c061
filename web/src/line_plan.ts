// SPDX-License-Identifier: BSD-3-Clause
// The line seen from above, the strip that it has swept, and its slices.
import { svg_element } from "./element";
import { display_unit } from "./film_numbers";
import { LineChart } from "./line_chart";
import { exaggeration, exaggeration_words, type LineRun, type LineShapes, shape_at, swept, value_at } from "./line_shapes";
import type { StageEnd } from "./line_stages";

/** px of the page */
const tallest = 250, room_of_a_number = 16;

export class PlanChart extends LineChart {
  private times = 1;
  private marks: SVGAElement[] = [];

  /** Pointing at the mark of a slice tells `picked`; without it there are no marks. */
  constructor(run: LineRun, shapes: LineShapes, ends: StageEnd[], picked: ((slice: number | null) => void) | null) {
    super({ name: "y", words: (unit) => `Lateral displacement y (${unit})`, curves: ["y"], unit: (largest) => display_unit("m", largest) }, run, shapes, ends);
    if (picked !== null) this.marks = run.line.slices.map((x, k) => mark_of(run, x, k, picked));
  }

  override lay_out(width: number): void {
    super.lay_out(width);
    const [first, second] = this.run.line.slices.map((x) => this.area.x(x)), every = Math.ceil(room_of_a_number / (second - first || room_of_a_number));
    this.marks.forEach((mark, k) => mark.querySelector("text")!.setAttribute("display", k % every === 0 ? "inline" : "none"));
  }

  override show(at: number | null): void {
    super.show(at);
    const y = at === null ? null : shape_at(this.values[0], at);
    this.marks.forEach((mark, k) => {
      mark.setAttribute("display", y === null ? "none" : "inline");
      const x = this.run.line.slices[k];
      if (y !== null) mark.setAttribute("transform", `translate(${this.area.x(x)} ${this.area.y(value_at(this.x, y, x))})`);
    });
  }

  highlight(slice: number | null): void {
    this.marks.forEach((mark, k) => mark.classList.toggle("picked", k === slice));
  }

  protected override height(length: number, px_per_metre: number): number {
    this.times = exaggeration(length, px_per_metre, tallest);
    return this.times * px_per_metre * length;
  }

  protected override words(words: string): string {
    return `${words}; ${exaggeration_words(this.times)}`;
  }

  protected override range(): [low: number, high: number] {
    const [low, high] = super.range();
    return [low - this.radius, high + this.radius];
  }

  /** The strip that was swept, as far as there are slices of soil, and where these end. */
  protected override extras(at: number | null): SVGElement[] {
    const { frames, slices } = this.run.line, to = slices[slices.length - 1], { top, height } = this.area.box;
    const { low, high } = swept(this.values[0], at ?? frames.length - 1, this.radius);
    const within = [...this.x.keys()].filter((node) => Math.abs(this.x[node]) <= to * (1 + 1e-9));
    const [x, lower, upper] = [this.x, low, high].map((values) => within.map((node) => values[node]));
    return [
      this.area.strip("line_swept", x, lower, upper),
      ...[lower, upper].map((y) => this.area.path({ look: "line_berm", x, y })),
      ...[-to, to].map((place) => svg_element("path", { class: "line_last_slice", "stroke-dasharray": "3 4", d: `M${this.area.x(place)} ${top}v${height}` })),
    ];
  }

  protected override above(): SVGElement[] {
    return this.marks;
  }

  /** In the unit of the axis. */
  private get radius(): number {
    return this.run.line.diameter / 2 / this.unit.factor;
  }
}

function mark_of(run: LineRun, x: number, k: number, picked: (slice: number | null) => void): SVGAElement {
  const mark = svg_element(
    "a", { href: `#${card_id(run, k)}`, class: "line_mark", "aria-label": `Slice ${k}, x = ${x} m: to its card` },
    svg_element("title", {}, `slice ${k}, x = ${x} m`), svg_element("circle", { r: 9, class: "line_target" }), svg_element("circle", { r: 3.5 }),
    svg_element("text", { y: -9, "text-anchor": "middle" }, String(k)));
  for (const event of ["pointerenter", "focus"]) mark.addEventListener(event, () => picked(k));
  for (const event of ["pointerleave", "blur"]) mark.addEventListener(event, () => picked(null));
  return mark;
}

/** The id of the card of a slice. */
export function card_id(run: LineRun, slice: number): string {
  return `slice-${run.line.y.block}-${slice}`;
}
