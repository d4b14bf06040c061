// SPDX-License-Identifier: BSD-3-Clause
// Small charts drawn as SVG: axes that stay, and curves that move. Letters have the size of the page's, so they are drawn anew for another width.
import { ticks_of } from "./charts/ticks";
import type { Range } from "./charts/ticks";
import { svg_element } from "./element";

export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** A line through points, in the units of the axes; `look` are classes of lines.css. */
export interface Curve {
  look: string;
  dash?: string;
  x: ArrayLike<number>;
  y: ArrayLike<number>;
}

/** An axis: the numbers that it reaches over, and about how many of them it shows. */
export interface Axis {
  range: Range;
  ticks: number;
  downwards?: boolean;
  title?: string;
  /** Without numbers: another axis below has them. */
  bare?: boolean;
}

const letter = 11;

/** The plotting area of a chart with its grid and numbers, within a drawing. */
export class ChartArea {
  readonly element = svg_element("g");
  /** What lies within the area is cut at its sides. */
  readonly inside: SVGSVGElement;

  constructor(readonly box: Box, private readonly across: Axis, private readonly up: Axis) {
    const { left, top, width, height } = box;
    this.inside = svg_element("svg", { x: left, y: top, width, height, viewBox: `${left} ${top} ${width} ${height}` });
    const grid = svg_element("path", { class: "line_grid", d: "" }), axis = svg_element("path", { class: "line_axis", d: `M${left} ${top}h${width}v${height}h${-width}Z` });
    this.element.append(grid, this.inside, axis);
    let lines = "";
    const columns = ticks_of(across.range, false, across.ticks), rows = ticks_of(up.range, false, up.ticks);
    columns.at.forEach((value, i) => {
      const x = this.x(value);
      lines += `M${x} ${top}v${height}`;
      if (!across.bare) this.element.append(svg_element("text", { x, y: top + height + letter + 3, "text-anchor": "middle" }, columns.labels[i]));
    });
    rows.at.forEach((value, i) => {
      const y = this.y(value);
      lines += `M${left} ${y}h${width}`;
      this.element.append(svg_element("text", { x: left - 5, y: y + 0.35 * letter, "text-anchor": "end" }, rows.labels[i]));
    });
    grid.setAttribute("d", lines);
    if (up.range[0] < 0 && up.range[1] > 0) this.inside.append(svg_element("path", { class: "line_zero", d: `M${left} ${this.y(0)}h${width}` }));
    if (across.title !== undefined)
      this.element.append(svg_element("text", { x: left + width, y: top + height + 2 * letter + 6, "text-anchor": "end", class: "line_title" }, across.title));
    if (up.title !== undefined) this.element.append(svg_element("text", { x: left, y: top - 5, class: "line_title" }, up.title));
  }

  x(value: number): number {
    const [low, high] = this.across.range;
    return rounded(this.box.left + ((value - low) / (high - low)) * this.box.width);
  }

  y(value: number): number {
    const [low, high] = this.up.range, part = (value - low) / (high - low);
    return rounded(this.box.top + (this.up.downwards ? part : 1 - part) * this.box.height);
  }

  path({ look, dash, x, y }: Curve): SVGPathElement {
    return svg_element("path", { class: `line_curve ${look}`, "stroke-dasharray": dash || null, d: this.points(x, y) });
  }

  /** What lies between two curves. */
  strip(look: string, x: ArrayLike<number>, low: ArrayLike<number>, high: ArrayLike<number>): SVGPathElement {
    const back = (values: ArrayLike<number>) => Array.from(values).reverse();
    return svg_element("path", { class: look, d: `${this.points(x, high)}${this.points(back(x), back(low)).replace("M", "L")}Z` });
  }

  private points(x: ArrayLike<number>, y: ArrayLike<number>): string {
    let points = "";
    for (let i = 0; i < x.length; i++) points += `${i === 0 ? "M" : "L"}${this.x(x[i])} ${this.y(y[i])}`;
    return points;
  }
}

function rounded(px: number): number {
  return Math.round(100 * px) / 100;
}

/** A drawing of so many px of the page; on paper it takes the width that it finds. */
export function drawing(width: number, height: number, label: string): SVGSVGElement {
  return svg_element("svg", { class: "line_drawing", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": label });
}

/** A range with some room at its ends, and zero in it. */
export function roomy([low, high]: [number, number], part: number): Range {
  const from = Math.min(low, 0), to = Math.max(high, 0), room = part * (to - from) || 1;
  return [from < 0 ? from - room : 0, to > 0 || from === 0 ? to + room : 0];
}
