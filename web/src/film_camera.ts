// SPDX-License-Identifier: BSD-3-Clause
// What of the soil is seen. A camera is kept relative to the film's region of interest, so that two films of different size can move together.
import type { FilmData } from "./data";

/** Centre from the middle of the region of interest in widths of the region, and zoom; 0, 0, 1 shows the region. */
export interface Camera {
  x: number;
  y: number;
  zoom: number;
}

/** Part of the world in m that fills a plot. */
export interface Window {
  x: number;
  y: number;
  width: number;
  height: number;
}

export type Box = FilmData["view"];

export const REGION: Camera = { x: 0, y: 0, zoom: 1 };

/** What the camera sees in a plot whose width over height is `aspect`. */
export function window_of(camera: Camera, region: Box, aspect: number): Window {
  const side = region.upper[0] - region.lower[0];
  const width = Math.max(side, (region.upper[1] - region.lower[1]) * aspect) / camera.zoom;
  return {
    x: (region.lower[0] + region.upper[0]) / 2 + camera.x * side,
    y: (region.lower[1] + region.upper[1]) / 2 + camera.y * side,
    width,
    height: width / aspect,
  };
}

/** The camera that sees all of a box, with a little room around it. */
export function camera_of(box: Box, region: Box, aspect: number): Camera {
  const whole = window_of(REGION, box, aspect);
  const part = window_of(REGION, region, aspect);
  const side = region.upper[0] - region.lower[0];
  return { x: (whole.x - part.x) / side, y: (whole.y - part.y) / side, zoom: part.width / (1.04 * whole.width) };
}

/** Moves by parts of the plot's width and height. */
export function panned(camera: Camera, seen: Window, region: Box, right: number, up: number): Camera {
  const side = region.upper[0] - region.lower[0];
  return { ...camera, x: camera.x + (right * seen.width) / side, y: camera.y + (up * seen.height) / side };
}

/** Zooms by a factor and keeps the point at (right, up) from the plot's middle, in parts of its width and height, where it is. */
export function zoomed(camera: Camera, seen: Window, region: Box, factor: number, right: number, up: number): Camera {
  const moved = panned(camera, seen, region, right * (1 - 1 / factor), up * (1 - 1 / factor));
  return { ...moved, zoom: camera.zoom * factor };
}
