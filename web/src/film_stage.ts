// SPDX-License-Identifier: BSD-3-Clause
// The picture of a panel: a painter's canvas for the soil, and a canvas over it for axes and bodies.
import { draw_axes, ink_of, MARGIN, type Scene } from "./film_axes";
import { CanvasPainter } from "./film_canvas";
import { make } from "./film_elements";
import type { Look, Painter } from "./film_painter";
import { WebglPainter } from "./film_webgl";

const NOTES = { webgl: "drawn by WebGL", "2d": "drawn without WebGL" };

/** px of the page */
const TALLEST = 560;

export class FilmStage {
  readonly element = make("div", "film-stage");
  readonly over = make("canvas", "film-over");
  readonly message = make("p", "film-message");
  readonly note = make("span", "film-note");
  painter!: Painter;
  private ratio = 0;
  private height_over_width = 0.6;

  /** `repaint` is called when the picture has to be drawn again: another size, another painter. */
  constructor(private repaint: (another_painter: boolean) => void) {
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "group");
    this.over.setAttribute("role", "img");
    this.message.setAttribute("role", "status");
    this.element.append(this.over, this.message);
    this.take_painter(this.best_painter(new URLSearchParams(location.search).get("painter")));
    const follow = () => {
      this.fit(this.height_over_width);
      this.repaint(false);
    };
    new ResizeObserver(follow).observe(this.element);
    window.addEventListener("resize", follow);
  }

  /** px of the page that the soil fills. */
  get plot(): { width: number; height: number } {
    return {
      width: Math.max(40, this.element.clientWidth - MARGIN.left - MARGIN.right),
      height: Math.max(40, this.element.clientHeight - MARGIN.top - MARGIN.bottom),
    };
  }

  /** Makes the picture as high as the region of interest asks for; on paper it keeps its shape. */
  fit(height_over_width: number): void {
    this.height_over_width = height_over_width;
    const plot_height = Math.min(TALLEST, Math.max(0.45, Math.min(1, height_over_width)) * this.plot.width);
    const shape = `${this.element.clientWidth} / ${Math.round(plot_height) + MARGIN.top + MARGIN.bottom}`;
    if (this.element.clientWidth > 0 && this.element.style.aspectRatio !== shape) this.element.style.aspectRatio = shape;
  }

  draw(look: Look, scene: Omit<Scene, "width" | "height">): void {
    this.follow_size();
    this.painter.draw(look);
    const context = this.over.getContext("2d")!;
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    const [width, height] = [this.element.clientWidth, this.element.clientHeight];
    context.clearRect(0, 0, width, height);
    draw_axes(context, { ...scene, width, height }, ink_of(this.element));
  }

  /** Draws the soil at so many pixels per px of the page, hands it to `use`, and goes back to the size on the page. */
  draw_at(ratio: number, look: Look, use: (soil: HTMLCanvasElement) => void): void {
    const { width, height } = this.plot;
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
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    const { plot, over, painter } = this;
    const { clientWidth, clientHeight } = this.element;
    const [width, height] = [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    if (ratio === this.ratio && over.width === width && over.height === height) return;
    this.ratio = ratio;
    over.width = width;
    over.height = height;
    painter.resize(Math.round(plot.width * ratio), Math.round(plot.height * ratio));
    // In parts of the whole, so that both canvases shrink alike on paper.
    const { style } = painter.canvas;
    style.left = `${(100 * MARGIN.left) / clientWidth}%`;
    style.top = `${(100 * MARGIN.top) / clientHeight}%`;
    style.width = `${(100 * plot.width) / clientWidth}%`;
    style.height = `${(100 * plot.height) / clientHeight}%`;
  }

  /** WebGL by a graphics card, else the 2D canvas, which is faster than WebGL by software; ?painter=webgl or ?painter=2d in the address decide otherwise. */
  private best_painter(wanted: string | null): Painter {
    if (wanted === "2d") return new CanvasPainter();
    try {
      const painter = new WebglPainter(wanted === "webgl", () => {
        if (this.painter !== painter) return;
        this.take_painter(new CanvasPainter());
        this.repaint(true);
      });
      return painter;
    } catch {
      return new CanvasPainter();
    }
  }

  private take_painter(painter: Painter): void {
    this.painter?.canvas.remove();
    this.painter?.free();
    this.painter = painter;
    this.ratio = 0;
    painter.canvas.className = "film-soil";
    painter.canvas.setAttribute("aria-hidden", "true");
    this.element.prepend(painter.canvas);
    this.note.textContent = NOTES[painter.kind];
  }
}
