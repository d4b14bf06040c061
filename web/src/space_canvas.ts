// SPDX-License-Identifier: BSD-3-Clause
// The soil in space on a 2D canvas, for browsers without WebGL: particles and triangles one over the other, the farthest first.
import { PLAIN } from "./film_painter";
import { axes_of, dot } from "./space_camera";
import { BALL, BODY, CLEAR, corners_at, edges_of, type SpaceLook, type SpaceModel, type SpacePainter } from "./space_painter";

export class SpaceCanvas implements SpacePainter {
  readonly kind = "2d";
  readonly canvas = document.createElement("canvas");
  private context = this.canvas.getContext("2d")!;
  private model: SpaceModel | null = null;

  resize(width: number, height: number): void {
    this.canvas.width = width;
    this.canvas.height = height;
  }

  show(model: SpaceModel): void {
    this.model = model;
  }

  draw(look: SpaceLook): void {
    if (this.model === null) return;
    const { context, canvas } = this;
    context.clearRect(0, 0, canvas.width, canvas.height);
    const { right, up, back } = axes_of(look.camera);
    const scale = canvas.height / look.camera.height;
    const at = (place: ArrayLike<number>): [number, number] => {
      const from = [0, 1, 2].map((d) => place[d] - look.camera.target[d]);
      return [canvas.width / 2 + scale * dot(right, from), canvas.height / 2 - scale * dot(up, from)];
    };
    context.strokeStyle = look.line;
    context.beginPath();
    const edges = edges_of(this.model.soil.box);
    for (let i = 0; i < edges.length; i += 6) {
      context.moveTo(...at(edges.slice(i, i + 3)));
      context.lineTo(...at(edges.slice(i + 3, i + 6)));
    }
    context.stroke();
    const shapes = [...this.particles(this.model, look, at, scale, back), ...this.triangles(this.model, look, at, back)];
    for (const shape of shapes.sort((a, b) => a.depth - b.depth)) shape.fill();
  }

  free(): void {
    this.resize(1, 1);
  }

  private particles({ soil, values, colours }: SpaceModel, look: SpaceLook, at: (place: number[]) => [number, number], scale: number, back: number[]) {
    const next = Math.min(look.frame + 1, soil.places.length - 1);
    const [now, then] = [soil.places[look.frame], soil.places[next]];
    const shapes: { depth: number; fill(): void }[] = [];
    for (let p = 0; p < soil.count; p++) {
      if (look.mask !== null && look.mask[p] === 0) continue;
      const place = [0, 1, 2].map((d) => soil.lower[d] + soil.step * (now[3 * p + d] + look.part * (then[3 * p + d] - now[3 * p + d])));
      if (!inside(place, look)) continue;
      const byte = values === null ? 0 : values[look.frame][p] + look.part * (values[next][p] - values[look.frame][p]);
      const shade = Math.round(255 * Math.min(1, Math.max(0, (byte - look.from_byte) / (look.to_byte - look.from_byte))));
      const colour = values === null ? PLAIN : colours.subarray(4 * shade, 4 * shade + 3);
      const side = Math.max(1.5, BALL * soil.sizes[p] * soil.step * scale);
      const fill = () => {
        const [x, y] = at(place);
        this.context.fillStyle = `rgb(${colour[0]},${colour[1]},${colour[2]})`;
        this.context.fillRect(x - side / 2, y - side / 2, side, side);
      };
      shapes.push({ depth: dot(back, place), fill });
    }
    return shapes;
  }

  private triangles({ surfaces }: SpaceModel, look: SpaceLook, at: (place: number[]) => [number, number], back: number[]) {
    const shapes: { depth: number; fill(): void }[] = [];
    if (look.bodies === "hidden") return shapes;
    for (const surface of surfaces) {
      const corners = corners_at(surface, look.frame, look.part);
      for (let t = 0; t < surface.triangles.length; t += 3) {
        const three = [0, 1, 2].map((k) => [...corners.subarray(3 * surface.triangles[t + k], 3 * surface.triangles[t + k] + 3)]);
        const middle = [0, 1, 2].map((d) => (three[0][d] + three[1][d] + three[2][d]) / 3);
        if (look.cut_bodies && !inside(middle, look)) continue;
        if (same(three[0], three[1]) || same(three[1], three[2]) || same(three[2], three[0])) continue;
        const fill = () => {
          const { context } = this;
          context.beginPath();
          for (const corner of three) context.lineTo(...at(corner));
          context.closePath();
          context.globalAlpha = look.bodies === "clear" ? CLEAR : 1;
          context.fillStyle = context.strokeStyle = shaded(three, back);
          context.fill();
          context.stroke();
          context.globalAlpha = 1;
        };
        shapes.push({ depth: dot(back, middle), fill });
      }
    }
    return shapes;
  }
}

function inside(place: number[], look: SpaceLook): boolean {
  return place.every((x, d) => x >= look.kept.lower[d] && x <= look.kept.upper[d]);
}

function same(a: number[], b: number[]): boolean {
  return a.every((x, d) => x === b[d]);
}

/** The colour of a body's triangle: bright where it faces who looks. */
function shaded([a, b, c]: number[][], back: number[]): string {
  const [u, v] = [b, c].map((corner) => corner.map((x, d) => x - a[d]));
  const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const light = 0.45 + 0.55 * Math.abs(dot(normal, back)) / (Math.hypot(...normal) || 1);
  const own = [1, 3, 5].map((at) => Math.round(light * parseInt(BODY.slice(at, at + 2), 16)));
  return `rgb(${own.join(",")})`;
}
