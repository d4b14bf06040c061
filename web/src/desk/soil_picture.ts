// SPDX-License-Identifier: BSD-3-Clause
// The soil of the newest frame, seen from the side.
import { digits } from "../film_numbers";
import { make } from "../film_elements";
import { page_colour } from "../theme";
import type { Soil2D } from "./api";

const tallest = 420;

export class SoilPicture {
  readonly element = make("figure", "soil_picture");
  frame = -1;
  private canvas = make("canvas", "");
  private caption = make("figcaption", "quiet", "No frame yet.");
  private soil: Soil2D | null = null;

  constructor() {
    this.element.append(this.canvas, this.caption);
    new ResizeObserver(() => this.draw()).observe(this.element);
    document.addEventListener("theme", () => this.draw());
  }

  show(soil: Soil2D): void {
    this.frame = soil.frame;
    this.soil = soil;
    this.draw();
  }

  private draw(): void {
    const { soil, canvas } = this, width = this.element.clientWidth;
    if (soil === null || width === 0) return;
    const [left, right, low, high] = range(soil), scale = Math.min(width / (right - left), tallest / (high - low)), ratio = devicePixelRatio;
    canvas.width = Math.round(ratio * scale * (right - left));
    canvas.height = Math.round(ratio * scale * (high - low));
    canvas.style.width = `${canvas.width / ratio}px`;
    const ctx = canvas.getContext("2d")!, at = (x: number, y: number): [number, number] => [(x - left) * scale * ratio, (high - y) * scale * ratio];
    const values = soil.field?.values ?? [], most = Math.max(1e-12, percentile(values, 0.98));
    const usual = (right - left) / Math.sqrt(soil.points || 1);
    soil.x.forEach((x, k) => {
      const side = Math.max(1.2, 1.15 * ratio * scale * (soil.size[k] > 0 ? Math.sqrt(soil.size[k] * Math.max(1, soil.points / soil.x.length)) : usual)), [px, py] = at(x, soil.y[k]);
      ctx.fillStyle = shade(values.length > 0 ? Math.min(1, values[k] / most) : 0);
      ctx.fillRect(px - side / 2, py - side / 2, side, side);
    });
    ctx.strokeStyle = page_colour("--text");
    ctx.fillStyle = page_colour("--panel");
    ctx.lineWidth = 1.5 * ratio;
    for (const outline of soil.rigids) {
      ctx.beginPath();
      outline.forEach(([x, y], k) => (k === 0 ? ctx.moveTo(...at(x, y)) : ctx.lineTo(...at(x, y))));
      if (outline.length > 2) ctx.closePath(), ctx.fill();
      ctx.stroke();
    }
    const field = soil.field ? `${soil.field.label}, dark: ${digits(most)}${soil.field.unit && soil.field.unit !== "1" ? ` ${soil.field.unit}` : ""} and more; ` : "";
    this.caption.textContent = `t = ${digits(soil.time_s, 4)} s, frame ${soil.frame}; ${field}${digits(right - left)} m wide`;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `The soil: ${this.caption.textContent}`);
  }
}

function range({ x, y, rigids }: Soil2D): [left: number, right: number, low: number, high: number] {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  const take = (px: number, py: number) => ([left, right, low, high] = [Math.min(left, px), Math.max(right, px), Math.min(low, py), Math.max(high, py)]);
  x.forEach((px, k) => take(px, y[k]));
  rigids.flat().forEach(([px, py]) => take(px, py));
  return [left, right, low, Math.max(high, low + 1e-9)];
}

function percentile(values: number[], part: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.floor(part * (sorted.length - 1))] ?? 0;
}

/** From sand to a dark red. */
function shade(part: number): string {
  const from = [222, 205, 170], to = [120, 20, 40];
  return `rgb(${from.map((value, k) => Math.round(value + part * (to[k] - value))).join(" ")})`;
}
