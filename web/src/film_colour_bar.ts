// SPDX-License-Identifier: BSD-3-Clause
// The bar that tells what the colours mean.
import type { Ink } from "./film_axes";
import type { Range } from "./film_colours";
import { tick_text, ticks, type Unit } from "./film_numbers";

export interface ColourBar {
  colours: Uint8Array;
  range: Range;
  unit: Unit;
  /** Whether soil beyond an end has the end's colour: the end is then pointed. */
  clipped_low: boolean;
  clipped_high: boolean;
}

/** px */
export const BAR_HEIGHT = 34;
const THICK = 13;
const POINT = 11;
const LEAST_SIDE = 16;
const FONT = '11.5px system-ui, "DejaVu Sans", sans-serif';

/** Draws the bar with its numbers (in the unit) into a strip of this width at x, y. */
export function draw_colour_bar(context: CanvasRenderingContext2D, bar: ColourBar, x: number, y: number, width: number, ink: Ink): void {
  const { factor } = bar.unit;
  const { values, decimals } = ticks(bar.range.from / factor, bar.range.to / factor, width / 90);
  context.font = FONT;
  // An end's number stands half beyond it.
  const widest = Math.max(0, ...values.map((value) => context.measureText(tick_text(value, decimals)).width));
  const side = Math.max(LEAST_SIDE, Math.ceil(widest / 2) + 1);
  const left = x + side;
  const right = x + width - side;
  const colour = (i: number) => `rgb(${bar.colours[4 * i]},${bar.colours[4 * i + 1]},${bar.colours[4 * i + 2]})`;
  for (let px = 0; px < right - left; px++) {
    context.fillStyle = colour(Math.round((255 * (px + 0.5)) / (right - left)));
    context.fillRect(left + px, y + 1, Math.min(1.5, right - left - px), THICK);
  }
  const end = (at: number, out: number, index: number) => {
    context.beginPath();
    context.moveTo(at, y + 1);
    context.lineTo(at + out * POINT, y + 1 + THICK / 2);
    context.lineTo(at, y + 1 + THICK);
    context.fillStyle = colour(index);
    context.fill();
  };
  if (bar.clipped_low) end(left, -1, 0);
  if (bar.clipped_high) end(right, 1, 255);

  context.beginPath();
  context.moveTo(left, y + 1);
  context.lineTo(right, y + 1);
  if (bar.clipped_high) context.lineTo(right + POINT, y + 1 + THICK / 2);
  context.lineTo(right, y + 1 + THICK);
  context.lineTo(left, y + 1 + THICK);
  if (bar.clipped_low) context.lineTo(left - POINT, y + 1 + THICK / 2);
  context.closePath();
  context.lineWidth = 1;
  context.strokeStyle = ink.quiet;
  context.stroke();

  context.fillStyle = ink.text;
  context.textAlign = "center";
  context.textBaseline = "top";
  context.beginPath();
  for (const value of values) {
    const at = left + ((value * factor - bar.range.from) / (bar.range.to - bar.range.from)) * (right - left);
    context.moveTo(at, y + 1 + THICK);
    context.lineTo(at, y + 5 + THICK);
    context.fillText(tick_text(value, decimals), at, y + 7 + THICK);
  }
  context.stroke();
}
