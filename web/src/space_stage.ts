// SPDX-License-Identifier: BSD-3-Clause
// The picture of the soil in space: a painter's canvas, and a canvas over it for axes and lengths.
import { type Ink, ink_of } from "./film_axes";
import { make } from "./film_elements";
import { SpaceCanvas } from "./space_canvas";
import { draw_marks } from "./space_marks";
import type { SpaceLook, SpacePainter } from "./space_painter";
import type { SpaceBox } from "./space_parts";
import { SpaceWebgl } from "./space_webgl";

const NOTES = { webgl: "drawn by WebGL", "2d": "This browser has no WebGL: the picture is still and without smooth shading; it is drawn anew for each choice." };

export class SpaceStage {
  readonly element = make("div", "film-stage space-stage");
  readonly over = make("canvas", "film-over");
  readonly message = make("p", "film-message");
  readonly note = make("span", "film-note");
  painter!: SpacePainter;
  private ratio = 0;

  /** `repaint` is called when the picture has to be drawn again: another size, another painter. */
  constructor(private repaint: (another_painter: boolean) => void) {
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "group");
    this.over.setAttribute("role", "img");
    this.message.setAttribute("role", "status");
    this.element.append(this.over, this.message);
    this.take_painter(this.best_painter(new URLSearchParams(location.search).get("painter")));
    new ResizeObserver(() => this.repaint(false)).observe(this.element);
  }

  get size(): { width: number; height: number } {
    return { width: Math.max(40, this.element.clientWidth), height: Math.max(40, this.element.clientHeight) };
  }

  get aspect(): number {
    return this.size.width / this.size.height;
  }

  /** The colours of the page as they are now. */
  get ink(): Ink {
    return ink_of(this.element);
  }

  draw(look: SpaceLook, box: SpaceBox): void {
    this.follow_size();
    this.painter.draw(look);
    const context = this.over.getContext("2d")!, { width, height } = this.size;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    draw_marks(context, look.camera, box, width, height, this.ink);
  }

  /** Draws at so many pixels per px of the page, hands it to `use`, and goes back to the size on the page. */
  draw_at(ratio: number, look: SpaceLook, use: (soil: HTMLCanvasElement) => void): void {
    const { width, height } = this.size;
    this.painter.resize(Math.round(width * ratio), Math.round(height * ratio));
    this.painter.draw(look);
    use(this.painter.canvas);
    this.ratio = 0;
    this.repaint(false);
  }

  tell(message: string): void {
    this.message.textContent = message;
    this.message.hidden = message === "";
  }

  private follow_size(): void {
    const ratio = Math.min(2, window.devicePixelRatio || 1), { width, height } = this.size;
    const [columns, rows] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (ratio === this.ratio && this.over.width === columns && this.over.height === rows) return;
    this.ratio = ratio;
    this.over.width = columns;
    this.over.height = rows;
    this.painter.resize(columns, rows);
  }

  /** WebGL, by software if it must be; ?painter=2d in the address decides otherwise. */
  private best_painter(wanted: string | null): SpacePainter {
    if (wanted === "2d") return new SpaceCanvas();
    try {
      const painter = new SpaceWebgl(() => {
        if (this.painter !== painter) return;
        this.take_painter(new SpaceCanvas());
        this.repaint(true);
      });
      return painter;
    } catch {
      return new SpaceCanvas();
    }
  }

  private take_painter(painter: SpacePainter): void {
    this.painter?.canvas.remove();
    this.painter?.free();
    this.painter = painter;
    this.ratio = 0;
    painter.canvas.className = "film-over";
    painter.canvas.setAttribute("aria-hidden", "true");
    this.element.prepend(painter.canvas);
    this.note.textContent = NOTES[painter.kind];
  }
}
