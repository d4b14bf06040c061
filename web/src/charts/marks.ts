// SPDX-License-Identifier: BSD-3-Clause
import type uPlot from "uplot";
import { page_colour } from "../theme";
import { candidates, LabelPlaces, levels_first } from "./label_places";
import type { Box } from "./label_places";
import type { Mark, Scene } from "./scene";

/** Draws the scene's points and levels over its lines, and where there is room for them their labels. */
export function draw_marks(u: uPlot, scene: Scene): void {
  const { ctx, bbox } = u;
  const unit = devicePixelRatio;
  const placed = scene.marks.map((mark) => ({
    mark,
    x: mark.x === null ? null : u.valToPos(mark.x, "x", true),
    y: mark.y === null ? null : u.valToPos(mark.y, "y", true),
  })).filter(({ x, y }) => is_within(x, bbox.left, bbox.width) && is_within(y, bbox.top, bbox.height));
  if (placed.length === 0) return;
  ctx.save();
  ctx.font = `${11 * unit}px system-ui, "DejaVu Sans", sans-serif`;
  ctx.lineWidth = 1.25 * unit;
  const places = new LabelPlaces(bbox, 3 * unit);
  for (const line of scene.lines.filter((each) => each.weight !== "band"))
    places.avoid_line(line.x.map((x, i) => {
      const y = line.y[i];
      return x === null || y === null ? null : [u.valToPos(x, "x", true), u.valToPos(y, "y", true)];
    }));
  for (const { mark, x, y } of placed) {
    use_ink(ctx, mark);
    places.avoid_box(draw_mark(ctx, bbox, x, y, unit));
  }
  for (const { mark, x, y } of levels_first(placed)) {
    use_ink(ctx, mark);
    const width = ctx.measureText(mark.label).width + 2 * unit;
    write(ctx, mark.label, places.take(x, y, candidates(x, y, width, 13 * unit, bbox, unit)), unit);
  }
  ctx.restore();
}

function use_ink(ctx: CanvasRenderingContext2D, mark: Mark): void {
  ctx.strokeStyle = ctx.fillStyle = page_colour(mark.published ? "--published" : "--quiet");
}

function is_within(at: number | null, from: number, length: number): boolean {
  return at === null || (at >= from && at <= from + length);
}

/** Draws a point, or a level over all of the area; gives the box that it takes. */
function draw_mark(ctx: CanvasRenderingContext2D, area: Box, x: number | null, y: number | null, unit: number): Box {
  ctx.beginPath();
  if (x !== null && y !== null) {
    const r = 5 * unit;
    ctx.setLineDash([]);
    for (const [dx, dy] of [[0, -r], [r, 0], [0, r], [-r, 0]]) ctx.lineTo(x + dx, y + dy);
    ctx.closePath();
    ctx.save();
    ctx.fillStyle = page_colour("--ground");
    ctx.fill();
    ctx.restore();
    ctx.stroke();
    return { left: x - r, top: y - r, width: 2 * r, height: 2 * r };
  }
  ctx.setLineDash(y !== null ? [4 * unit, 4 * unit] : [2 * unit, 3 * unit]);
  ctx.moveTo(x ?? area.left, y ?? area.top);
  ctx.lineTo(x ?? area.left + area.width, y ?? area.top + area.height);
  ctx.stroke();
  return { left: x ?? area.left, top: y ?? area.top, width: x === null ? area.width : 0, height: y === null ? area.height : 0 };
}

/** With a rim in the colour of the ground, to be read over lines. */
function write(ctx: CanvasRenderingContext2D, text: string, box: Box, unit: number): void {
  ctx.save();
  ctx.textAlign = "left";
  ctx.textBaseline = "middle";
  ctx.setLineDash([]);
  ctx.lineJoin = "round";
  ctx.lineWidth = 4 * unit;
  ctx.strokeStyle = page_colour("--ground");
  for (const draw of ["strokeText", "fillText"] as const) ctx[draw](text, box.left + unit, box.top + box.height / 2);
  ctx.restore();
}
