// SPDX-License-Identifier: BSD-3-Clause
// The soil on a 2D canvas, for browsers without WebGL: the same picture, pixel by pixel.
import { CLOSE_GAPS, type Look, type Painter, PLAIN, SMALLEST_SQUARE } from "./film_painter";
import { fill_square, fill_triangle, type Pixels } from "./film_raster";
import type { Soil } from "./film_soil";

/** Steps of the colour table for one byte of a field: as many as a narrow colour range needs. */
const STEPS = 8;

export class CanvasPainter implements Painter {
  readonly kind = "2d";
  readonly canvas = document.createElement("canvas");
  private context: CanvasRenderingContext2D;
  private image = new ImageData(1, 1);
  private pixels: Pixels = { width: 1, height: 1, colours: new Uint32Array(1) };
  private soil: Soil | null = null;
  private values: Uint8Array[] | null = null;
  private palette = new Uint32Array(256);
  private table = new Uint32Array(255 * STEPS + 1);
  private table_of = "";
  private corners = new Float64Array(0);
  private shades = new Float64Array(0);

  constructor() {
    this.context = this.canvas.getContext("2d")!;
  }

  resize(width: number, height: number): void {
    this.canvas.width = width;
    this.canvas.height = height;
    this.image = new ImageData(width, height);
    this.pixels = { width, height, colours: new Uint32Array(this.image.data.buffer) };
  }

  show_soil(soil: Soil): void {
    this.soil = soil;
    this.values = null;
    this.table_of = "";
    this.corners = new Float64Array(soil.triangles === null ? 0 : 2 * soil.count);
    this.shades = new Float64Array(soil.triangles === null ? 0 : soil.count);
  }

  show_values(frames: Uint8Array[] | null, colours: Uint8Array): void {
    this.values = frames;
    this.palette = new Uint32Array(colours.slice().buffer);
    this.table_of = "";
  }

  draw(look: Look): void {
    if (this.soil === null) return;
    this.pixels.colours.fill(0);
    this.make_table(look);
    if (this.soil.triangles === null) this.draw_particles(this.soil, look);
    else this.draw_triangles(this.soil, this.soil.triangles, look);
    this.context.putImageData(this.image, 0, 0);
  }

  free(): void {
    this.resize(1, 1);
  }

  private draw_particles(soil: Soil, look: Look): void {
    const { pixels, table, values } = this;
    const { part } = look;
    const next_frame = Math.min(look.frame + 1, soil.places.length - 1);
    const [now, next] = [soil.places[look.frame], soil.places[next_frame]];
    const [shade, shade_next] = [values?.[look.frame], values?.[next_frame]];
    const sizes = soil.sizes!;
    const { code, left, top } = this.placing(soil, look);
    const { width, height } = pixels;
    const border = Math.max((soil.largest_size * code * CLOSE_GAPS) / 2, 2);
    for (let p = 0; p < soil.count; p++) {
      const y = top - code * (now[2 * p + 1] + part * (next[2 * p + 1] - now[2 * p + 1]));
      if (y < -border || y > height + border) continue;
      const x = left + code * (now[2 * p] + part * (next[2 * p] - now[2 * p]));
      if (x < -border || x > width + border) continue;
      const byte = shade === undefined ? 0 : shade[p] + part * (shade_next![p] - shade[p]);
      fill_square(pixels, x, y, Math.max(sizes[p] * code * CLOSE_GAPS, SMALLEST_SQUARE), table[(byte * STEPS + 0.5) | 0]);
    }
  }

  private draw_triangles(soil: Soil, triangles: Uint32Array, look: Look): void {
    const { corners, shades, values } = this;
    const { part } = look;
    const next_frame = Math.min(look.frame + 1, soil.places.length - 1);
    const [now, next] = [soil.places[look.frame], soil.places[next_frame]];
    const { code, left, top } = this.placing(soil, look);
    for (let p = 0; p < soil.count; p++) {
      corners[2 * p] = left + code * (now[2 * p] + part * (next[2 * p] - now[2 * p]));
      corners[2 * p + 1] = top - code * (now[2 * p + 1] + part * (next[2 * p + 1] - now[2 * p + 1]));
      const byte = values === null ? 0 : values[look.frame][p] + part * (values[next_frame][p] - values[look.frame][p]);
      shades[p] = byte * STEPS;
    }
    for (let t = 0; t < triangles.length; t += 3) {
      fill_triangle(this.pixels, corners, shades, triangles[t], triangles[t + 1], triangles[t + 2], this.table);
    }
  }

  /** Pixels of one code, and where the codes 0, 0 are. */
  private placing(soil: Soil, look: Look): { code: number; left: number; top: number } {
    const { width, height } = this.pixels;
    const scale = width / look.window.width;
    return {
      code: soil.step * scale,
      left: width / 2 + (soil.lower[0] - look.window.x) * scale,
      top: height / 2 - (soil.lower[1] - look.window.y) * scale,
    };
  }

  /** Colours of a field's bytes, with steps between them, as pixels. */
  private make_table(look: Look): void {
    const wanted = `${look.from_byte} ${look.to_byte} ${this.values === null}`;
    if (wanted === this.table_of) return;
    this.table_of = wanted;
    const plain = new Uint32Array(new Uint8Array([...PLAIN, 255]).buffer)[0];
    for (let i = 0; i < this.table.length; i++) {
      const at = (i / STEPS - look.from_byte) / (look.to_byte - look.from_byte);
      this.table[i] = this.values === null ? plain : this.palette[Math.round(255 * Math.min(1, Math.max(0, at)))];
    }
  }
}
