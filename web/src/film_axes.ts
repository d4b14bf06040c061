// SPDX-License-Identifier: BSD-3-Clause
// What lies around and over the soil: axes in mm (m, where the soil is large), the original surface, rigid bodies.
import type { Window } from "./film_camera";
import { type Arrows, draw_arrows, draw_scale } from "./film_flow";
import { axis_base, axis_title, tick_text, ticks } from "./film_numbers";

/** px of the page around the plot. */
export const MARGIN = { left: 58, right: 20, top: 26, bottom: 36 };

export interface Ink {
  text: string;
  quiet: string;
  line: string;
  ground: string;
}

/** For paper: what a saved picture is drawn with. */
export const PAPER: Ink = { text: "#15191e", quiet: "#4a535c", line: "#aab2ba", ground: "#ffffff" };

/** The page's colours as they are now, light or dark. */
export function ink_of(element: Element): Ink {
  const style = getComputedStyle(element);
  const named = (name: string, otherwise: string) => style.getPropertyValue(name).trim() || otherwise;
  return { text: named("--text", PAPER.text), quiet: named("--quiet", PAPER.quiet), line: named("--line", PAPER.line), ground: named("--ground", PAPER.ground) };
}

export const RIGID_FILL = "#9aa3ad";
const RIGID_EDGE = "#2f363d";
const SURFACE = "#e8590c";
// m from the origin, beyond which places are told in m.
const LARGE = 10;
const FONT = '11.5px system-ui, "DejaVu Sans", sans-serif';

export interface Scene {
  width: number;
  height: number;
  window: Window;
  /** m */
  surface: number | null;
  /** Corners x, y in m; instead of the surface where that is not level. */
  ground?: [number, number][];
  /** Corners x, y in m. */
  outlines: Float64Array[];
  /** The flow of the water; null: not shown. */
  arrows: Arrows | null;
}

/** Draws over a picture of `width` by `height` px of the page, whose plot (inside of MARGIN) shows the window. */
export function draw_axes(context: CanvasRenderingContext2D, scene: Scene, ink: Ink): void {
  const { window } = scene;
  const plot = { x: MARGIN.left, y: MARGIN.top, width: scene.width - MARGIN.left - MARGIN.right, height: scene.height - MARGIN.top - MARGIN.bottom };
  const scale = plot.width / window.width;
  const at_x = (x: number) => plot.x + plot.width / 2 + (x - window.x) * scale;
  const at_y = (y: number) => plot.y + plot.height / 2 - (y - window.y) * scale;

  context.save();
  context.beginPath();
  context.rect(plot.x, plot.y, plot.width, plot.height);
  context.clip();
  if (scene.arrows !== null) draw_arrows(context, scene.arrows, scale, at_x, at_y);
  for (const outline of scene.outlines) draw_body(context, outline, at_x, at_y);
  const level = scene.surface;
  if (scene.ground !== undefined) draw_surface(context, scene.ground.map(([x, y]) => [at_x(x), at_y(y)]));
  else if (level !== null) draw_surface(context, [plot.x, plot.x + plot.width].map((x) => [x, at_y(level)]));
  context.restore();

  context.font = FONT;
  context.lineWidth = 1;
  context.strokeStyle = ink.quiet;
  context.fillStyle = ink.text;
  context.strokeRect(plot.x - 0.5, plot.y - 0.5, plot.width + 1, plot.height + 1);
  context.beginPath();
  const base_x = axis_base(window.x - window.width / 2, window.x + window.width / 2), base_y = axis_base(window.y - window.height / 2, window.y + window.height / 2);
  const [middle_x, middle_y] = [window.x - base_x, window.y - base_y];
  const ends = [middle_x - window.width / 2, middle_x + window.width / 2, middle_y - window.height / 2, middle_y + window.height / 2];
  const unit = Math.max(...ends.map(Math.abs)) < LARGE ? { name: "mm", factor: 1e-3 } : { name: "m", factor: 1 };
  const [from_x, to_x, from_y, to_y] = ends.map((end) => end / unit.factor);
  const across = ticks(from_x, to_x, plot.width / 70);
  const bottom = plot.y + plot.height;
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const value of across.values) {
    const x = Math.round(at_x(base_x + value * unit.factor)) + 0.5;
    context.moveTo(x, bottom);
    context.lineTo(x, bottom + 4);
    context.fillText(tick_text(value, across.decimals), x, bottom + 6);
  }
  context.fillText(axis_title("x", base_x, unit.name), plot.x + plot.width / 2, bottom + 20);
  const upwards = ticks(from_y, to_y, plot.height / 50);
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of upwards.values) {
    const y = Math.round(at_y(base_y + value * unit.factor)) + 0.5;
    context.moveTo(plot.x, y);
    context.lineTo(plot.x - 4, y);
    context.fillText(tick_text(value, upwards.decimals), plot.x - 6, y);
  }
  context.stroke();
  // Above the numbers, however long they are.
  context.textAlign = "left";
  context.textBaseline = "top";
  context.fillText(axis_title("y", base_y, unit.name), 2, 2);
  if (scene.arrows !== null) draw_scale(context, scene.arrows, scale, plot.x + plot.width, plot.y / 2, ink.text);
}

function draw_body(context: CanvasRenderingContext2D, outline: Float64Array, at_x: (x: number) => number, at_y: (y: number) => number): void {
  context.beginPath();
  for (let i = 0; i < outline.length; i += 2) context.lineTo(at_x(outline[i]), at_y(outline[i + 1]));
  context.closePath();
  context.fillStyle = RIGID_FILL;
  context.fill();
  context.lineWidth = 1.5;
  context.strokeStyle = RIGID_EDGE;
  context.stroke();
}

/** A dashed line that shows on dark soil and on the ground of the page alike. */
function draw_surface(context: CanvasRenderingContext2D, corners: number[][]): void {
  context.save();
  context.lineWidth = 1.5;
  context.strokeStyle = SURFACE;
  context.setLineDash([7, 5]);
  context.beginPath();
  for (const [x, y] of corners) context.lineTo(x, y);
  context.stroke();
  context.restore();
}
