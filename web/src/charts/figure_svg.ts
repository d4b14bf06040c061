// SPDX-License-Identifier: BSD-3-Clause
import { svg_element } from "../element";
import { candidates, LabelPlaces, levels_first } from "./label_places";
import type { Box } from "./label_places";
import { band_opacity } from "./plot";
import type { View } from "./plot";
import { tick_length, tick_offset, tick_sample } from "./remeshings";
import type { Line, Scene, SceneAxis } from "./scene";
import { ticks_of } from "./ticks";
import type { Range } from "./ticks";

/** The plotting area of a figure, px, and its letters. */
interface Size extends Box {
  letters: number;
}
const sizes: Record<"file" | "print", Size> = {
  file: { left: 74, top: 16, width: 520, height: 340, letters: 13 },
  print: { left: 62, top: 12, width: 320, height: 200, letters: 11 },
};
const legend_step = 18;
const ink = "#1a1a1a", faint = "#dddddd", published_ink = "#7a1f5c";
const weights = { raw: 0.7, plain: 1.6, mean: 1.9, band: 0 };

type To = (value: number) => number;

/** A drawing of the scene that stands alone: axes, lines, marks and legend, black on white, as a file of SVG. */
export function figure_svg(scene: Scene, view: View): string {
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(figure_element(scene, view, "file"))}\n`;
}

/** The same as an element, in the size of a file's figure or smaller for print, where `name` tells its parts from those of others. */
export function figure_element(scene: Scene, view: View, size: keyof typeof sizes, name = ""): SVGSVGElement {
  const area = sizes[size];
  const height = area.top + area.height + 62 + legend_step * (scene.traces.length + (scene.remeshings.length > 0 ? 1 : 0));
  const width = area.left + area.width + 22;
  const x = place(view.x, scene.x, area.left, area.width, false);
  const y = place(view.y, scene.y, area.top, area.height, true);
  const clip = svg_element("clipPath", { id: `area${name}` }, svg_element("rect", { x: area.left, y: area.top, width: area.width, height: area.height }));
  const drawn = svg_element("g", { "clip-path": `url(#area${name})`, fill: "none" });
  for (const line of scene.lines) drawn.append(line_path(line, x, y));
  return svg_element(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", width, height, viewBox: `0 0 ${width} ${height}`, "font-family": "Helvetica, Arial, 'DejaVu Sans', sans-serif", "font-size": area.letters, fill: ink },
    svg_element("title", {}, scene.plan.title),
    svg_element("defs", {}, clip),
    svg_element("rect", { width, height, fill: "#ffffff" }),
    axis_group(area, scene.x, view.x, x, true),
    axis_group(area, scene.y, view.y, y, false),
    drawn,
    svg_element("rect", { x: area.left, y: area.top, width: area.width, height: area.height, fill: "none", stroke: ink }),
    remeshings_group(area, scene, scene.plan.upright ? y : x),
    marks_group(area, scene, x, y),
    legend(area, scene),
    key_of_remeshings(area, scene),
  );
}

/** Where a value lies on an axis, px. */
function place([low, high]: Range, axis: SceneAxis, start: number, length: number, vertical: boolean): To {
  const of = (value: number) => (axis.logarithmic ? Math.log10(value) : value);
  const turned = vertical !== axis.downwards;
  return (value) => {
    const part = (of(value) - of(low)) / (of(high) - of(low));
    return rounded(start + length * (turned ? 1 - part : part));
  };
}

function rounded(value: number): number {
  return Math.round(100 * value) / 100;
}

function line_path(line: Line, x: To, y: To): SVGPathElement {
  let path = "", pen_down = false;
  line.x.forEach((at, i) => {
    const value = line.y[i];
    if (at !== null && value !== null) path += `${pen_down ? "L" : "M"}${x(at)} ${y(value)}`;
    pen_down = at !== null && value !== null;
  });
  if (line.weight === "band") return svg_element("path", { class: "band", d: path, fill: line.style.colour.light, "fill-opacity": band_opacity });
  return svg_element("path", {
    d: path, stroke: line.style.colour.light, "stroke-width": weights[line.weight], "stroke-linejoin": "round",
    "stroke-dasharray": line.weight === "raw" ? null : line.style.dash.join(" ") || null, "stroke-opacity": line.weight === "raw" ? 0.5 : null,
  });
}

function axis_group(area: Size, axis: SceneAxis, range: Range, to: To, horizontal: boolean): SVGGElement {
  const group = svg_element("g", { class: "axis" });
  const { at, labels } = ticks_of(range, axis.logarithmic, Math.round(horizontal ? area.width / 80 : area.height / 48));
  const bottom = area.top + area.height, right = area.left + area.width;
  at.forEach((value, i) => {
    const p = to(value);
    const line = (x1: number, y1: number, x2: number, y2: number, stroke: string) => svg_element("line", { x1, y1, x2, y2, stroke });
    group.append(
      horizontal ? line(p, area.top, p, bottom, faint) : line(area.left, p, right, p, faint),
      horizontal ? line(p, bottom, p, bottom - 5, ink) : line(area.left, p, area.left + 5, p, ink),
      horizontal
        ? svg_element("text", { x: p, y: bottom + 17, "text-anchor": "middle" }, labels[i])
        : svg_element("text", { x: area.left - 6, y: p, "text-anchor": "end", dy: "0.35em" }, labels[i]),
    );
  });
  const middle = area.top + area.height / 2;
  group.append(
    horizontal
      ? svg_element("text", { class: "title", x: area.left + area.width / 2, y: bottom + 40, "text-anchor": "middle" }, axis.title)
      : svg_element("text", { class: "title", x: 1.2 * area.letters, y: middle, "text-anchor": "middle", transform: `rotate(-90 ${1.2 * area.letters} ${middle})` }, axis.title),
  );
  return group;
}

function marks_group(area: Size, scene: Scene, to_x: To, to_y: To): SVGGElement {
  const group = svg_element("g", { class: "marks" });
  const marks = scene.marks.map((mark) => ({ mark, x: mark.x === null ? null : to_x(mark.x), y: mark.y === null ? null : to_y(mark.y) }))
    .filter(({ x, y }) => is_within(x, area.left, area.width) && is_within(y, area.top, area.height));
  if (marks.length === 0) return group;
  const places = new LabelPlaces(area, 3);
  for (const line of scene.lines.filter((each) => each.weight !== "band"))
    places.avoid_line(line.x.map((at, i) => (at === null || line.y[i] === null ? null : [to_x(at), to_y(line.y[i]!)])));
  for (const { mark, x, y } of marks) {
    const colour = mark_ink(mark.published);
    if (x !== null && y !== null) {
      group.append(svg_element("path", { d: `M${x} ${y - 5}L${x + 5} ${y}L${x} ${y + 5}L${x - 5} ${y}Z`, fill: "#ffffff", stroke: colour, "stroke-width": 1.3 }));
      places.avoid_box({ left: x - 5, top: y - 5, width: 10, height: 10 });
    } else {
      const ends = { x1: x ?? area.left, x2: x ?? area.left + area.width, y1: y ?? area.top, y2: y ?? area.top + area.height };
      group.append(svg_element("line", { ...ends, stroke: colour, "stroke-dasharray": y !== null ? "4 4" : "2 3" }));
      places.avoid_box({ left: ends.x1, top: ends.y1, width: ends.x2 - ends.x1, height: ends.y2 - ends.y1 });
    }
  }
  for (const { mark, x, y } of levels_first(marks)) {
    // About what the text takes: the reader's fonts are not known.
    const box: Box = places.take(x, y, candidates(x, y, 6.3 * mark.label.length, 13, area, 1));
    group.append(svg_element(
      "text",
      { x: rounded(box.left), y: rounded(box.top + 10), "font-size": 11, fill: mark_ink(mark.published), stroke: "#ffffff", "stroke-width": 3, "paint-order": "stroke" },
      mark.label));
  }
  return group;
}

/** At the edge opposite to the axis of the argument. */
function remeshings_group(area: Size, scene: Scene, to: To): SVGGElement {
  const group = svg_element("g", { class: "remeshings" });
  const right = area.left + area.width;
  for (const tick of scene.remeshings) {
    const at = to(tick.at), from = tick_offset(tick), end = from + tick_length;
    const place = scene.plan.upright ? { x1: right - from, x2: right - end, y1: at, y2: at } : { x1: at, x2: at, y1: area.top + from, y2: area.top + end };
    if (scene.plan.upright ? is_within(at, area.top, area.height) : is_within(at, area.left, area.width))
      group.append(svg_element("line", { ...place, stroke: tick.style.colour.light }));
  }
  return group;
}

/** The row of the legend below those of the runs. */
function key_of_remeshings(area: Size, scene: Scene): SVGGElement {
  const group = svg_element("g", { class: "remeshings_key", color: ink });
  if (scene.remeshings.length === 0) return group;
  const y = area.top + area.height + 62 + legend_step * scene.traces.length;
  group.append(tick_sample(area.left, y - tick_length / 2), svg_element("text", { x: area.left + 44, y, dy: "0.35em" }, "remeshing"));
  return group;
}

function mark_ink(published: boolean): string {
  return published ? published_ink : "#666666";
}

function is_within(at: number | null, from: number, length: number): boolean {
  return at === null || (at >= from && at <= from + length);
}

function legend(area: Size, scene: Scene): SVGGElement {
  const group = svg_element("g", { class: "legend" });
  scene.traces.forEach((trace, i) => {
    const y = area.top + area.height + 62 + legend_step * i;
    const dash = trace.style.dash.join(" ") || null;
    group.append(
      svg_element("line", { x1: area.left, x2: area.left + 36, y1: y, y2: y, stroke: trace.style.colour.light, "stroke-width": 2, "stroke-dasharray": dash }),
      svg_element("text", { x: area.left + 44, y, dy: "0.35em" }, trace.label),
    );
  });
  return group;
}
