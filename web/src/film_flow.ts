// SPDX-License-Identifier: BSD-3-Clause
// The flow of the water as arrows over the soil, and the arrow that tells their scale.
import type { FlowData } from "./data";
import { digits, display_unit } from "./film_numbers";

/** An arrow: from where, and the flux there, m/s. */
export interface Arrow {
  x: number;
  y: number;
  flux: [number, number];
}

/** The arrows of a frame, and the flux of the one that is as long as they get. */
export interface Arrows {
  list: Arrow[];
  /** m/s */
  scale: number;
  /** m, between neighbours. */
  spacing: number;
}

// Of all arrows so many are not longer than the longest that is drawn: beside the end of an open boundary the flux has no bound.
const PART_IN_SCALE = 0.98;
// Lengths over the distance of neighbours, and the shortest that is drawn, px.
const LONGEST = 1.5;
const SHORTEST = 3;
const HEAD = 6;
const INK = "#10151a";
const HALO = "rgba(255, 255, 255, 0.75)";
const FONT = '11.5px system-ui, "DejaVu Sans", sans-serif';

/** Signed bytes x, y of all squares, one array per frame; throws where their number is wrong. */
export function decode_flow(bytes: Uint8Array, frames: number, squares: number): Int8Array[] {
  if (bytes.length !== 2 * frames * squares) throw new RangeError(`${bytes.length} bytes instead of ${2 * frames * squares}`);
  return Array.from({ length: frames }, (_, frame) => Int8Array.from(bytes.subarray(2 * frame * squares, 2 * (frame + 1) * squares)));
}

/** The arrows of one frame; without those that are zero. */
export function arrows_of(flow: FlowData, codes: Int8Array, frame: number): Arrows {
  const list: Arrow[] = [];
  const unit = flow.largest[frame] / 127;
  for (let square = 0; square < flow.columns * flow.rows; square++) {
    const [wx, wy] = [unit * codes[2 * square], unit * codes[2 * square + 1]];
    if (wx === 0 && wy === 0) continue;
    const x = flow.lower[0] + flow.side * ((square % flow.columns) + 0.5);
    const y = flow.lower[1] + flow.side * (Math.floor(square / flow.columns) + 0.5);
    list.push({ x, y, flux: [wx, wy] });
    if (flow.mirrored) list.push({ x: -x, y, flux: [-wx, wy] });
  }
  const sizes = list.map(({ flux }) => Math.hypot(...flux)).sort((a, b) => a - b);
  const scale = sizes.length === 0 ? 0 : round_down(sizes[Math.floor(PART_IN_SCALE * (sizes.length - 1))]);
  return { list, scale, spacing: flow.side };
}

/** 1, 2 or 5 times a power of ten. */
function round_down(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return power * (value >= 5 * power ? 5 : value >= 2 * power ? 2 : 1);
}

/** Draws the arrows with their middles where the flux is; `pixels`: px of the page of a metre. Longer ones than LONGEST are cut. */
export function draw_arrows(context: CanvasRenderingContext2D, arrows: Arrows, pixels: number, at_x: (x: number) => number, at_y: (y: number) => number): void {
  const longest = LONGEST * arrows.spacing * pixels;
  context.save();
  context.lineCap = "round";
  for (const [colour, width] of [[HALO, 3], [INK, 1.2]] as const) {
    context.strokeStyle = context.fillStyle = colour;
    context.lineWidth = width;
    for (const { x, y, flux } of arrows.list) {
      const size = Math.hypot(...flux);
      const length = Math.min(longest, (longest / 2) * (size / arrows.scale));
      if (length >= SHORTEST) draw_arrow(context, at_x(x), at_y(y), [flux[0] / size, -flux[1] / size], length);
    }
  }
  context.restore();
}

/** The arrow of the scale and what it stands for, its right end at `right`. */
export function draw_scale(context: CanvasRenderingContext2D, arrows: Arrows, pixels: number, right: number, middle: number, ink: string): void {
  if (!(arrows.scale > 0)) return;
  const unit = display_unit("m/s", arrows.scale);
  const text = `flow of the water: ${digits(arrows.scale / unit.factor, 1)} ${unit.name}`;
  const length = Math.min(80, (LONGEST / 2) * arrows.spacing * pixels);
  context.save();
  context.font = FONT;
  context.textAlign = "right";
  context.textBaseline = "middle";
  context.fillStyle = ink;
  context.fillText(text, right - length - 8, middle);
  context.lineCap = "round";
  context.strokeStyle = ink;
  context.lineWidth = 1.2;
  draw_arrow(context, right - length / 2, middle, [1, 0], length);
  context.restore();
}

function draw_arrow(context: CanvasRenderingContext2D, x: number, y: number, [along, down]: [number, number], length: number): void {
  const [tip_x, tip_y] = [x + (along * length) / 2, y + (down * length) / 2];
  const head = Math.min(HEAD, length / 2);
  context.beginPath();
  context.moveTo(x - (along * length) / 2, y - (down * length) / 2);
  context.lineTo(tip_x, tip_y);
  for (const side of [-0.5, 0.5]) {
    context.moveTo(tip_x, tip_y);
    context.lineTo(tip_x - head * (along + side * down), tip_y - head * (down - side * along));
  }
  context.stroke();
}
