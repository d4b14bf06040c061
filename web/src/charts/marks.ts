// SPDX-License-Identifier: BSD-3-Clause
import type uPlot from "uplot";
import { page_colour } from "../theme";
import type { Mark, Scene } from "./scene";

/** Draws the scene's points and levels over its lines, with labels inside the plotting area; those of levels along y one below the other, for they may be near each other. */
export function draw_marks(u: uPlot, scene: Scene): void {
  const { ctx, bbox } = u;
  const px = devicePixelRatio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.font = `${11 * px}px system-ui, "DejaVu Sans", sans-serif`;
  ctx.lineWidth = 1.25 * px;
  scene.marks.forEach((mark, index) => {
    ctx.strokeStyle = ctx.fillStyle = page_colour(mark.of_paper ? "--paper" : "--quiet");
    draw_mark(u, mark, index, px);
  });
  ctx.restore();
}

function draw_mark(u: uPlot, mark: Mark, index: number, px: number): void {
  const { ctx, bbox } = u;
  const x = mark.x === null ? null : u.valToPos(mark.x, "x", true);
  const y = mark.y === null ? null : u.valToPos(mark.y, "y", true);
  ctx.beginPath();
  if (x !== null && y !== null) {
    const r = 5 * px;
    ctx.setLineDash([]);
    for (const [dx, dy] of [[0, -r], [r, 0], [0, r], [-r, 0]]) ctx.lineTo(x + dx, y + dy);
    ctx.closePath();
    ctx.save();
    ctx.fillStyle = page_colour("--ground");
    ctx.fill();
    ctx.restore();
    ctx.stroke();
    const right = x + 9 * px + ctx.measureText(mark.label).width < bbox.left + bbox.width;
    write(ctx, mark.label, x + (right ? 9 : -9) * px, y, right ? "left" : "right", "middle", px);
  } else if (y !== null) {
    ctx.setLineDash([4 * px, 4 * px]);
    ctx.moveTo(bbox.left, y);
    ctx.lineTo(bbox.left + bbox.width, y);
    ctx.stroke();
    const above = y - bbox.top > 18 * px;
    write(ctx, mark.label, bbox.left + bbox.width - 4 * px, y + (above ? -3 : 4) * px, "right", above ? "bottom" : "top", px);
  } else if (x !== null) {
    ctx.setLineDash([2 * px, 3 * px]);
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    const right = x + 4 * px + ctx.measureText(mark.label).width < bbox.left + bbox.width;
    write(ctx, mark.label, x + (right ? 4 : -4) * px, bbox.top + (4 + 14 * (index % 4)) * px, right ? "left" : "right", "top", px);
  }
}

/** With a rim in the colour of the ground, to be read over lines. */
function write(
  ctx: CanvasRenderingContext2D, text: string, x: number, y: number, align: CanvasTextAlign, baseline: CanvasTextBaseline, px: number,
): void {
  ctx.save();
  ctx.textAlign = align;
  ctx.textBaseline = baseline;
  ctx.setLineDash([]);
  ctx.lineJoin = "round";
  ctx.lineWidth = 4 * px;
  ctx.strokeStyle = page_colour("--ground");
  ctx.strokeText(text, x, y);
  ctx.fillText(text, x, y);
  ctx.restore();
}
