// SPDX-License-Identifier: BSD-3-Clause
// The line seen from above, the soil that it has heaped up, and its slices.
import { svg_element } from "./element";
import { display_unit } from "./film_numbers";
import { type Patch, patches_at } from "./line_bed";
import { LineChart } from "./line_chart";
import { exaggeration, exaggeration_words, type LineRun, type LineShapes, shape_at, swept, value_at } from "./line_shapes";
import type { StageEnd } from "./line_stages";

/** px of the page */
const tallest = 250, room_of_a_number = 16;

export class PlanChart extends LineChart {
  private times = 1;
  private marks: SVGAElement[] = [];

  /** Pointing at the mark of a slice tells `picked`; without it there are no marks. */
  constructor(run: LineRun, private readonly shapes: LineShapes, ends: StageEnd[], picked: ((slice: number | null) => void) | null) {
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
    const [low, high] = super.range(), bed = patches_at(this.run, this.shapes, this.run.line.frames.length - 1).flatMap(({ y }) => y.map((each) => each / this.unit.factor));
    return [Math.min(low - this.radius, ...bed), Math.max(high + this.radius, ...bed)];
  }

  /** The bed of the slices, and where these end. */
  protected override extras(at: number | null): SVGElement[] {
    const { frames, slices, half } = this.run.line, to = slices[slices.length - 1], { top, height } = this.area.box;
    const moment = at ?? frames.length - 1;
    return [
      ...(this.shapes.rise.length > 0 ? this.bed(patches_at(this.run, this.shapes, moment)) : this.swept_strip(moment, to)),
      ...(half === "none" ? [to] : [-to, to]).map((place) => svg_element("path", { class: "line_last_slice", "stroke-dasharray": "3 4", d: `M${this.area.x(place)} ${top}v${height}` })),
    ];
  }

  /** A path for each shade. */
  private bed(patches: Patch[]): SVGElement[] {
    const by_shade = new Map<number, string>();
    for (const { shade, x, y } of patches) {
      const [left, right] = x.map((each) => this.area.x(each)), [low, high] = y.map((each) => this.area.y(each / this.unit.factor));
      by_shade.set(shade, `${by_shade.get(shade) ?? ""}M${left} ${high}H${right}V${low}H${left}Z`);
    }
    return [...by_shade].map(([shade, d]) =>
      svg_element("path", { class: shade > 0 ? "line_heaped" : "line_dug", "fill-opacity": String(0.16 * Math.abs(shade)), d }));
  }

  /** The strip that was swept, as far as there are slices of soil. */
  private swept_strip(at: number, to: number): SVGElement[] {
    const { low, high } = swept(this.values[0], at, this.radius);
    const within = [...this.x.keys()].filter((node) => Math.abs(this.x[node]) <= to * (1 + 1e-9));
    const [x, lower, upper] = [this.x, low, high].map((values) => within.map((node) => values[node]));
    return [this.area.strip("line_swept", x, lower, upper), ...[lower, upper].map((y) => this.area.path({ look: "line_berm", x, y }))];
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
