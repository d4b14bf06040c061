// SPDX-License-Identifier: BSD-3-Clause
// What a painter of the soil in space is given; there are two, WebGL and a 2D canvas.
import type { OrbitCamera } from "./space_camera";
import type { Kept } from "./space_cuts";
import type { SpaceBox, SpaceSoil, Surface } from "./space_parts";

export type Bodies = "solid" | "clear" | "hidden";

/** All that does not change from frame to frame. */
export interface SpaceModel {
  soil: SpaceSoil;
  surfaces: Surface[];
  /** Bytes of the field by frame; null: the soil is grey. */
  values: Uint8Array[] | null;
  /** 256 colours. */
  colours: Uint8Array;
}

/** One moment: `part` of the way from frame `frame` to the next one. */
export interface SpaceLook {
  frame: number;
  part: number;
  camera: OrbitCamera;
  from_byte: number;
  to_byte: number;
  kept: Kept;
  /** 1 for particles that are shown; null: all. */
  mask: Uint8Array | null;
  bodies: Bodies;
  cut_bodies: boolean;
  /** Of the lines of the box. */
  line: string;
}

export interface SpacePainter {
  readonly kind: "webgl" | "2d";
  readonly canvas: HTMLCanvasElement;
  resize(width: number, height: number): void;
  show(model: SpaceModel): void;
  draw(look: SpaceLook): void;
  free(): void;
}

/** Balls are drawn larger than the cubes that they stand for, so that no gaps are seen between them. */
export const BALL = 1.3;
export const BODY = "#9aa3ad";
export const CLEAR = 0.35;

/** Ends of the twelve edges of a box: x, y, z of each. */
export function edges_of(box: SpaceBox): number[] {
  const corner = (k: number) => [0, 1, 2].map((d) => ((k >> d) & 1 ? box.upper[d] : box.lower[d]));
  const edges: number[] = [];
  for (let k = 0; k < 8; k++) for (let d = 0; d < 3; d++) if (!((k >> d) & 1)) edges.push(...corner(k), ...corner(k | (1 << d)));
  return edges;
}

/** The corners of a body between two frames. */
export function corners_at(surface: Surface, frame: number, part: number): Float64Array {
  const [now, next] = [surface.corners[frame], surface.corners[Math.min(frame + 1, surface.corners.length - 1)]];
  return part === 0 ? now : now.map((x, i) => x + part * (next[i] - x));
}
