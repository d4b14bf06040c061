// SPDX-License-Identifier: BSD-3-Clause
// The soil of the newest frame, around the body, seen from the side, with colour bar and scale.
import { digits } from "../film_numbers";
import { make } from "../film_elements";
import { page_colour } from "../theme";
import type { Soil2D } from "./api";

const tallest = 420;
/** Strain or displacement in m below which a colour would show round-off. */
const least_shown = 1e-4;

export class SoilPicture {
  readonly element = make("figure", "soil_picture");
  frame = -1;
  private canvas = make("canvas", "");
  private caption = make("figcaption", "quiet", "No frame yet.");
  private bar = make("div", "colour_bar");
  private scale = make("div", "scale");
  private soil: Soil2D | null = null;

  constructor() {
    this.element.append(this.canvas, this.scale, this.bar, this.caption);
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
    const inside = soil.x.map((x, k) => x >= left && x <= right && soil.y[k] >= low && soil.y[k] <= high), values = soil.field?.values ?? [];
    const most = Math.max(least_shown, percentile(values.filter((_, k) => inside[k]), 0.98));
    const usual = (right - left) / Math.sqrt(soil.points || 1);
    soil.x.forEach((x, k) => {
      if (!inside[k]) return;
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
    const unit = soil.field?.unit && soil.field.unit !== "1" ? ` ${soil.field.unit}` : "";
    this.bar.hidden = !soil.field;
    if (soil.field) this.bar.replaceChildren(make("span", "", "0"), make("span", "colours"), make("span", "", `${digits(most)}${unit} and more: ${soil.field.label}`));
    this.scale.textContent = `${digits(right - left, 2)} m`;
    this.scale.style.width = canvas.style.width;
    this.caption.textContent = `t = ${digits(soil.time_s, 4)} s, frame ${soil.frame}; ${digits(right - left, 2)} m wide`;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `The soil: ${this.caption.textContent}`);
  }
}

/** A few diameters around the rigid bodies; all of the soil where there are none, or where they are as large as it. */
function range({ x, y, rigids }: Soil2D): [left: number, right: number, low: number, high: number] {
  const box = (points: [number, number][]) => points.reduce(([l, r, b, t], [px, py]) => [Math.min(l, px), Math.max(r, px), Math.min(b, py), Math.max(t, py)], [Infinity, -Infinity, Infinity, -Infinity]);
  const soil = box(x.map((px, k) => [px, y[k]])), bodies = box(rigids.flat()), size = Math.max(bodies[1] - bodies[0], bodies[3] - bodies[2]);
  const [left, right, low, high] = [Math.min(soil[0], bodies[0]), Math.max(soil[1], bodies[1]), Math.min(soil[2], bodies[2]), Math.max(soil[3], bodies[3])];
  if (!(size > 0)) return [left, right, low, Math.max(high, low + 1e-9)];
  return [Math.max(left, bodies[0] - 3 * size), Math.min(right, bodies[1] + 3 * size), Math.max(low, bodies[2] - 2 * size), Math.min(high, bodies[3] + size)];
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
