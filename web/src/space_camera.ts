// SPDX-License-Identifier: BSD-3-Clause
// Where the soil in space is seen from: parallel rays, so that one scale holds all over the picture.
import type { SpaceBox, Vector } from "./space_parts";

export interface OrbitCamera {
  /** Radians: 0 from the front (against z), then to the right (against x); elevation pi / 2 from above. */
  azimuth: number;
  elevation: number;
  /** m, the middle of the picture. */
  target: Vector;
  /** m that the picture's height shows. */
  height: number;
}

export const VIEWS = {
  iso: { label: "Isometric", key: "i", azimuth: Math.PI / 4, elevation: Math.atan(Math.SQRT1_2) },
  front: { label: "Front", key: "f", azimuth: 0, elevation: 0 },
  side: { label: "Side", key: "r", azimuth: Math.PI / 2, elevation: 0 },
  above: { label: "Above", key: "t", azimuth: 0, elevation: Math.PI / 2 },
} as const;

/** Unit vectors of the picture: to the right, up, and towards who looks. */
export function axes_of(camera: OrbitCamera): { right: Vector; up: Vector; back: Vector } {
  const [sa, ca, se, ce] = [Math.sin(camera.azimuth), Math.cos(camera.azimuth), Math.sin(camera.elevation), Math.cos(camera.elevation)];
  return { right: [ca, 0, -sa], up: [-sa * se, ce, -ca * se], back: [sa * ce, se, ca * ce] };
}

export function dot(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The camera of these directions that sees all of a box in a picture whose width over height is `aspect`. */
export function seeing(box: SpaceBox, directions: { azimuth: number; elevation: number }, aspect: number): OrbitCamera {
  const target = [0, 1, 2].map((d) => (box.lower[d] + box.upper[d]) / 2) as Vector;
  const camera = { azimuth: directions.azimuth, elevation: directions.elevation, target, height: 1 };
  const { right, up } = axes_of(camera);
  const across = (axis: Vector) => [0, 1, 2].reduce((sum, d) => sum + Math.abs(axis[d]) * (box.upper[d] - box.lower[d]), 0);
  return { ...camera, height: 1.25 * Math.max(across(up), across(right) / aspect) };
}

/** Turns by radians; never beyond straight from above or below. */
export function turned(camera: OrbitCamera, to_left: number, up: number): OrbitCamera {
  const azimuth = (camera.azimuth - to_left) % (2 * Math.PI);
  return { ...camera, azimuth, elevation: Math.min(Math.PI / 2, Math.max(-Math.PI / 2, camera.elevation + up)) };
}

/** Moves what is seen by parts of the picture's height, to the right and down. */
export function shifted(camera: OrbitCamera, right: number, down: number): OrbitCamera {
  const axes = axes_of(camera);
  const target = camera.target.map((x, d) => x + camera.height * (down * axes.up[d] - right * axes.right[d])) as Vector;
  return { ...camera, target };
}

/** Zooms and keeps what is (right, up) from the middle, in parts of the picture's height, where it is. */
export function closer(camera: OrbitCamera, factor: number, right = 0, up = 0): OrbitCamera {
  const { right: r, up: u } = axes_of(camera), part = camera.height * (1 - 1 / factor);
  const target = camera.target.map((x, d) => x + part * (right * r[d] + up * u[d])) as Vector;
  return { ...camera, target, height: camera.height / factor };
}
