// SPDX-License-Identifier: BSD-3-Clause
import uPlot from "uplot";
import { element } from "../element";
import { is_dark, page_colour } from "../theme";
import type { RunStyle } from "./run_style";
import { draw_marks } from "./marks";
import { draw_remeshings } from "./remeshings";
import type { Line, Scene, SceneAxis } from "./scene";
import { ticks_of } from "./ticks";
import type { Range } from "./ticks";

/** The part of a scene that is seen. */
export interface View {
  x: Range;
  y: Range;
}

/** A point that the readout speaks of. */
export interface Dot {
  x: number;
  y: number;
  style: RunStyle;
}

/** What a plot tells of the reader's hand; places are px from the left top corner of the plotting area. */
export interface PlotEvents {
  zoomed(view: View): void;
  reset(): void;
  pointed(left: number, top: number): void;
}

const font = '12px system-ui, "DejaVu Sans", sans-serif';
const widths = { raw: 1, plain: 1.75, mean: 2.25, band: 0 };
export const band_opacity = 0.16;

/** A scene drawn on a canvas of uPlot's. The points of a line may go anywhere, so each series has its own x and y (uPlot's mode 2). */
export class Plot {
  private drawn: uPlot | null = null;
  private view: View | null = null;
  private dots: Dot[] = [];
  private marks: Dot[] = [];

  constructor(private readonly holder: HTMLElement, private readonly events: PlotEvents) {}

  show(scene: Scene, view: View, width: number, height: number): void {
    this.drawn?.destroy();
    this.view = view;
    this.dots = [];
    // uPlot takes its scales from the first series, so there is one even where nothing is shown.
    const data = [null, ...scene.lines.map((line) => [line.x, line.y]), [[], []]] as unknown as uPlot.AlignedData;
    this.drawn = new uPlot(this.options(scene, width, height), data, this.holder);
    this.listen_to_touch();
  }

  /** Sets the cursor's lines at a point of the scene. */
  set_cursor(x: number, y: number): void {
    const [left, top] = this.place(x, y);
    this.drawn?.setCursor({ left, top }, false);
  }

  /** Sets dots at points of the scene. */
  set_dots(dots: Dot[]): void {
    this.dots = dots;
    this.place_dots();
  }

  /** Sets larger dots that stay until they are set anew, also when the scene is drawn again. */
  set_marks(marks: Dot[]): void {
    if (marks.length === 0 && this.marks.length === 0) return;
    this.marks = marks;
    this.place_dots();
  }

  /** px from the left top corner of the plotting area. */
  place(x: number, y: number): [left: number, top: number] {
    return [this.drawn!.valToPos(x, "x"), this.drawn!.valToPos(y, "y")];
  }

  describe(text: string): void {
    const canvas = this.drawn?.root.querySelector("canvas");
    canvas?.setAttribute("role", "img");
    canvas?.setAttribute("aria-label", text);
  }

  private options(scene: Scene, width: number, height: number): uPlot.Options {
    const dark = is_dark();
    const colour = (line: Line) => (dark ? line.style.colour.dark : line.style.colour.light);
    const facets = [{ scale: "x", auto: false }, { scale: "y", auto: false }];
    const series = scene.lines.map((line): uPlot.Series => line.weight === "band" ? {
      facets, auto: false, fill: colour(line), alpha: band_opacity, width: 0, paths: area_of, points: { show: false },
    } : {
      facets, auto: false, stroke: colour(line), width: widths[line.weight], alpha: line.weight === "raw" ? 0.45 : 1,
      dash: line.weight === "raw" ? [] : line.style.dash, paths: path_of, points: { show: false },
    });
    return {
      mode: 2, width, height, legend: { show: false }, padding: [10, 20, 0, 0],
      series: [{}, ...series, { facets, auto: false, paths: path_of, points: { show: false } }] as uPlot.Series[],
      scales: { x: this.scale("x", scene.x), y: this.scale("y", scene.y) },
      axes: [axis_options("x", scene.x), axis_options("y", scene.y)],
      cursor: {
        drag: { x: true, y: true, uni: 24, dist: 6, setScale: false },
        dataIdx: () => null,
        points: { show: false },
        bind: { dblclick: () => () => (this.events.reset(), null) },
      },
      hooks: {
        setSelect: [(u) => this.selected(u)],
        setCursor: [(u) => u.cursor.left! >= 0 && this.events.pointed(u.cursor.left!, u.cursor.top!)],
        draw: [(u) => draw_remeshings(u, scene), (u) => draw_marks(u, scene), () => this.place_dots()],
      },
    };
  }

  private scale(key: "x" | "y", axis: SceneAxis): uPlot.Scale {
    return { time: false, auto: true, distr: axis.logarithmic ? 3 : 1, dir: axis.downwards ? -1 : 1, range: () => this.view![key] };
  }

  private selected(u: uPlot): void {
    const { left, top, width, height } = u.select;
    if (width === 0 && height === 0) return;
    const range = (key: "x" | "y", from: number, to: number): Range => {
      const ends = [u.posToVal(from, key), u.posToVal(to, key)];
      return [Math.min(...ends), Math.max(...ends)];
    };
    const view = { x: range("x", left, left + width), y: range("y", top, top + height) };
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    // What this leads to replaces the plot whose event is at work here.
    queueMicrotask(() => this.events.zoomed(view));
  }

  private place_dots(): void {
    const over = this.drawn?.over;
    if (over === undefined) return;
    for (const old of over.querySelectorAll(".chart_dot")) old.remove();
    const { width, height } = this.drawn!.bbox;
    for (const [{ x, y, style }, name] of [...this.marks.map((each) => [each, "chart_dot chart_moment"] as const), ...this.dots.map((each) => [each, "chart_dot"] as const)]) {
      const [left, top] = this.place(x, y);
      if (!(left >= -1 && top >= -1 && left <= width / uPlot.pxRatio + 1 && top <= height / uPlot.pxRatio + 1)) continue;
      const dot = element("div", { class: name });
      dot.style.left = `${left}px`;
      dot.style.top = `${top}px`;
      dot.style.background = is_dark() ? style.colour.dark : style.colour.light;
      over.append(dot);
    }
  }

  // uPlot listens to the mouse alone.
  private listen_to_touch(): void {
    const over = this.drawn!.over;
    const follow = (event: PointerEvent) => {
      if (event.pointerType !== "mouse") this.drawn?.setCursor({ left: event.offsetX, top: event.offsetY });
    };
    over.addEventListener("pointerdown", follow);
    over.addEventListener("pointermove", follow);
  }
}

/** A line through its points in their order, broken where one is missing. */
function path_of(u: uPlot, index: number): uPlot.Series.Paths {
  const [xs, ys] = u.data[index] as unknown as [(number | null)[], (number | null)[]];
  const stroke = new Path2D();
  let pen_down = false;
  xs.forEach((x, i) => {
    const y = ys[i];
    if (x === null || y === null) {
      pen_down = false;
      return;
    }
    const left = u.valToPos(x, "x", true), top = u.valToPos(y, "y", true);
    if (pen_down) stroke.lineTo(left, top);
    else stroke.moveTo(left, top);
    pen_down = true;
  });
  return { stroke, fill: null, clip: null, flags: 1 };
}

/** The same closed and filled. */
function area_of(u: uPlot, index: number): uPlot.Series.Paths {
  return { stroke: null, fill: path_of(u, index).stroke as Path2D, clip: null, flags: 1 };
}

// px that a tick with its label takes.
const tick_space = { x: 76, y: 44 };

function axis_options(key: "x" | "y", axis: SceneAxis): uPlot.Axis {
  const ticks = (u: uPlot) => {
    const size = (key === "x" ? u.bbox.width : u.bbox.height) / uPlot.pxRatio;
    return ticks_of([u.scales[key].min!, u.scales[key].max!], axis.logarithmic, Math.max(2, Math.floor(size / tick_space[key])));
  };
  return {
    scale: key, label: axis.title, font, labelFont: font, labelSize: 22, labelGap: 4, gap: 4,
    stroke: () => page_colour("--text"),
    grid: { stroke: () => page_colour("--grid"), width: 1 },
    ticks: { stroke: () => page_colour("--line"), width: 1, size: 5 },
    border: { show: true, stroke: () => page_colour("--quiet"), width: 1 },
    splits: (u) => ticks(u).at,
    filter: (_, splits) => splits,
    values: (u) => ticks(u).labels,
    size: key === "x" ? 30 : (u, labels) => label_width(u, labels) + 14,
  };
}

function label_width(u: uPlot, labels: string[] | null): number {
  u.ctx.save();
  u.ctx.font = font;
  const width = Math.max(24, ...(labels ?? []).map((label) => u.ctx.measureText(label).width));
  u.ctx.restore();
  return width;
}
