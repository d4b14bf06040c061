// SPDX-License-Identifier: BSD-3-Clause
// What a painter of the soil is told and does; there are two, WebGL and a 2D canvas.
import type { Window } from "./film_camera";
import type { Soil } from "./film_soil";

/** One moment: `part` of the way from frame `frame` to the next one, seen through a window. */
export interface Look {
  frame: number;
  part: number;
  window: Window;
  /** Bytes of the field that have the first and the last colour. */
  from_byte: number;
  to_byte: number;
}

export interface Painter {
  readonly kind: "webgl" | "2d";
  readonly canvas: HTMLCanvasElement;
  /** Size in pixels of the device. */
  resize(width: number, height: number): void;
  show_soil(soil: Soil): void;
  /** Bytes by frame and 256 colours; null: the soil without a field, grey. */
  show_values(frames: Uint8Array[] | null, colours: Uint8Array): void;
  draw(look: Look): void;
  free(): void;
}

/** Squares are drawn larger than the particles are: they do not lie on a square grid, and soil stretches. */
export const CLOSE_GAPS = 1.6;
/** px of the device. */
export const SMALLEST_SQUARE = 1.5;
export const PLAIN = [150, 150, 150] as const;
