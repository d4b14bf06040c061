// SPDX-License-Identifier: BSD-3-Clause
// What is written over the soil in space: the axes' directions, a bar of known length, the size of the box.
import type { Ink } from "./film_axes";
import { digits } from "./film_numbers";
import { axes_of, type OrbitCamera } from "./space_camera";
import type { SpaceBox } from "./space_parts";

const FONT = '12px system-ui, "DejaVu Sans", sans-serif';
/** px of the page: of an axis that lies in the picture, and from the corner to where the axes meet. */
const AXIS = 34;
const CORNER = 52;
/** Part of the width that the bar of known length takes at the most. */
const BAR_PART = 0.2;
const AXES = [["x", "#d1495b"], ["y", "#2a9d4a"], ["z", "#3a78c9"]] as const;

/** A length in words: mm below 1 m. */
export function length_text(length: number): string {
  return length < 1 ? `${digits(1000 * length)} mm` : `${digits(length)} m`;
}

/** The largest of 1, 2, 5, 10, ... that is not above. */
export function round_length(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most) + 1e-9);
  return [5, 2, 1].find((digit) => digit * power <= most * (1 + 1e-9))! * power;
}

export function box_text(box: SpaceBox): string {
  return `box at the start: ${["x", "y", "z"].map((axis, d) => `${axis} ${length_text(box.upper[d] - box.lower[d])}`).join(", ")}`;
}

/** Writes over a picture of `width` by `height` px. */
export function draw_marks(context: CanvasRenderingContext2D, camera: OrbitCamera, box: SpaceBox, width: number, height: number, ink: Ink): void {
  context.save();
  context.font = FONT;
  context.lineWidth = 2;
  context.textAlign = "center";
  context.textBaseline = "middle";
  const { right, up, back } = axes_of(camera);
  const nearest_last = [0, 1, 2].sort((a, b) => back[a] - back[b]);
  for (const d of nearest_last) {
    const [name, colour] = AXES[d];
    const [x, y] = [CORNER + AXIS * right[d], height - CORNER - AXIS * up[d]];
    context.strokeStyle = context.fillStyle = colour;
    context.beginPath();
    context.moveTo(CORNER, height - CORNER);
    context.lineTo(x, y);
    context.stroke();
    const seen = Math.hypot(right[d], up[d]);
    const [out_x, out_y] = seen > 0.05 ? [(9 * right[d]) / seen, (-9 * up[d]) / seen] : [-9, 9];
    context.fillText(name, x + out_x, y + out_y);
  }
  const scale = height / camera.height, length = round_length((BAR_PART * width) / scale);
  const [from, to, y] = [width - 18 - length * scale, width - 18, height - 20];
  context.strokeStyle = context.fillStyle = ink.text;
  context.beginPath();
  context.moveTo(from, y - 5);
  context.lineTo(from, y);
  context.lineTo(to, y);
  context.lineTo(to, y - 5);
  context.stroke();
  context.fillText(length_text(length), (from + to) / 2, y - 11);
  context.fillStyle = ink.quiet;
  context.textAlign = "left";
  context.fillText(box_text(box), 12, 14);
  context.restore();
}
