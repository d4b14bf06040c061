// SPDX-License-Identifier: BSD-3-Clause
// Squares and triangles in a picture of 32-bit colours; a pixel is filled where its centre lies inside.

export interface Pixels {
  width: number;
  height: number;
  colours: Uint32Array;
}

/** A square of side `side` around x, y (px, y down). */
export function fill_square(pixels: Pixels, x: number, y: number, side: number, colour: number): void {
  const { width, colours } = pixels;
  const left = Math.max(0, Math.ceil(x - side / 2 - 0.5));
  const right = Math.min(width, Math.ceil(x + side / 2 - 0.5));
  const bottom = Math.min(pixels.height, Math.ceil(y + side / 2 - 0.5));
  for (let row = Math.max(0, Math.ceil(y - side / 2 - 0.5)); row < bottom; row++) {
    const end = row * width + right;
    for (let at = row * width + left; at < end; at++) colours[at] = colour;
  }
}

/** The triangle of corners a, b, c (places x, y in px, y down) with shades that are linear between the corners; shade i has colour table[i]. */
export function fill_triangle(
  pixels: Pixels, places: Float64Array, shades: Float64Array, a: number, b: number, c: number, table: Uint32Array,
): void {
  const ax = places[2 * a], ay = places[2 * a + 1];
  const bx = places[2 * b], by = places[2 * b + 1];
  const cx = places[2 * c], cy = places[2 * c + 1];
  const { width, height, colours } = pixels;
  const twice_area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
  if (twice_area === 0) return;
  if (Math.max(ax, bx, cx) < 0 || Math.min(ax, bx, cx) > width) return;
  const along_x = ((shades[b] - shades[a]) * (cy - ay) - (shades[c] - shades[a]) * (by - ay)) / twice_area;
  const along_y = ((shades[c] - shades[a]) * (bx - ax) - (shades[b] - shades[a]) * (cx - ax)) / twice_area;
  const last = table.length - 1;
  const end_row = Math.min(height, Math.ceil(Math.max(ay, by, cy) - 0.5));
  for (let row = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5)); row < end_row; row++) {
    const y = row + 0.5;
    let from = Infinity;
    let to = -Infinity;
    const crosses = (x1: number, y1: number, x2: number, y2: number) => {
      if (y1 <= y === y2 <= y) return;
      const x = x1 + ((y - y1) / (y2 - y1)) * (x2 - x1);
      if (x < from) from = x;
      if (x > to) to = x;
    };
    crosses(ax, ay, bx, by);
    crosses(bx, by, cx, cy);
    crosses(cx, cy, ax, ay);
    const first = Math.max(0, Math.ceil(from - 0.5));
    const end = Math.min(width, Math.ceil(to - 0.5));
    let shade = shades[a] + (first + 0.5 - ax) * along_x + (y - ay) * along_y;
    for (let x = first; x < end; x++, shade += along_x) {
      colours[row * width + x] = table[shade <= 0 ? 0 : shade >= last ? last : (shade + 0.5) | 0];
    }
  }
}
