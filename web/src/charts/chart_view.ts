// SPDX-License-Identifier: BSD-3-Clause
import type { RunData } from "../data";
import { element } from "../element";
import { download, file_name } from "./download";
import { figure_element, figure_svg } from "./figure_svg";
import { nearest_in_time, nearest_points, point_of, stepped } from "./nearest";
import type { Plan } from "./plan";
import { Plot } from "./plot";
import type { View } from "./plot";
import { readout } from "./readout";
import { make_scene } from "./scene";
import type { Scene, Settings } from "./scene";
import { table_csv } from "./table_csv";
import type { Range } from "./ticks";

const keys: Record<string, number> = {
  ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1, PageDown: 10, PageUp: -10, End: Infinity, Home: -Infinity,
};

/** A chart on the page: its heading and buttons, the plot, and the readout below. */
export class ChartView {
  readonly figure: HTMLElement;
  private readonly heading = element("h4");
  private readonly reset_button = element("button", { type: "button", class: "chart_reset" }, "Reset zoom");
  private readonly holder = element("div", { class: "chart_plot", tabindex: 0, role: "group" });
  private readonly numbers = element("div", { class: "wide" });
  private readonly printed = element("div", { class: "chart_print", "aria-hidden": "true" });
  private readonly told = element("p", { class: "chart_told", "aria-live": "polite" });
  private readonly plot: Plot;
  private scene!: Scene;
  /** null: all of it. */
  private zoom: View | null = null;
  /** Points of the traces in the readout, by trace; null before the reader pointed at one. */
  private picked: (number | null)[] | null = null;

  /** `tallest`: px, of the plot. */
  constructor(
    private plan: Plan, private settings: Settings, private readonly runs: RunData[], choices: HTMLElement | null = null, private readonly tallest = 340,
  ) {
    const csv = element("button", { type: "button", class: "chart_csv" }, "CSV");
    const svg = element("button", { type: "button", class: "chart_svg" }, "SVG");
    csv.addEventListener("click", () => download(this.file_name("csv"), "text/csv", table_csv(this.scene)));
    svg.addEventListener("click", () => download(this.file_name("svg"), "image/svg+xml", figure_svg(this.scene, this.view())));
    this.reset_button.addEventListener("click", () => this.set_zoom(null));
    const buttons = element("div", { class: "chart_buttons" }, this.reset_button, csv, svg);
    this.figure = element(
      "div", { class: "chart" }, element("div", { class: "chart_head" }, this.heading, buttons), choices, this.holder, this.printed, this.numbers, this.told);
    this.plot = new Plot(this.holder, {
      zoomed: (view) => this.set_zoom(view),
      reset: () => this.set_zoom(null),
      pointed: (left, top) => this.point_at(nearest_points(this.scene, left, top, (x, y) => this.plot.place(x, y))),
    });
    this.holder.addEventListener("keydown", (event) => this.key(event));
    // On paper lines and letters, not pixels.
    addEventListener("beforeprint", () => this.scene && this.printed.replaceChildren(figure_element(this.scene, this.view(), "print", `_${++figures}`)));
    addEventListener("afterprint", () => this.printed.replaceChildren());
  }

  /** Marks where runs are at moments (s), on the lines that have these moments. */
  mark(moments: { run: RunData; time: number }[]): void {
    if (this.scene === undefined) return;
    this.plot.set_marks(moments.flatMap(({ run, time }) => {
      const trace = this.scene.traces.find((each) => each.run === run);
      const at = trace === undefined ? null : nearest_in_time(trace, time);
      const point = trace === undefined || at === null ? null : point_of(this.scene, trace, at, true);
      return point === null ? [] : [{ x: point[0], y: point[1], style: trace!.style }];
    }));
  }

  /** Shows another plan; where it is of other quantities the zoom is gone. */
  set_plan(plan: Plan): void {
    this.plan = plan;
    this.zoom = this.picked = null;
    this.show(this.settings);
  }

  show(settings: Settings): void {
    if (settings.units !== this.settings.units) this.zoom = null;
    const pointed = this.picked && new Map(this.scene.traces.map((trace, i) => [trace.label, this.picked![i]]));
    this.settings = { ...settings };
    this.scene = make_scene(this.plan, settings, this.runs);
    this.picked = pointed && this.scene.traces.map((trace) => pointed.get(trace.label) ?? null);
    this.figure.dataset.chart = this.plan.id;
    this.figure.classList.toggle("chart_own_key", !this.plan.by_run);
    this.heading.textContent = this.plan.title;
    this.holder.setAttribute("aria-label", `${this.plan.title}: arrow keys move the cursor from row to row`);
    this.draw();
  }

  /** Draws anew, for another size or theme. */
  draw(): void {
    const width = Math.floor(this.holder.clientWidth);
    if (width === 0 || this.scene === undefined) return;
    this.plot.show(this.scene, this.view(), width, Math.round(Math.min(this.tallest, Math.max(240, 0.62 * width))));
    this.tell();
  }

  private file_name(ending: string): string {
    return file_name(this.plan.id, what_of(this.scene.traces.map((trace) => trace.run), this.runs), ending);
  }

  private view(): View {
    return this.zoom ?? { x: this.scene.x.full, y: this.scene.y.full };
  }

  private set_zoom(view: View | null): void {
    this.zoom = view;
    this.draw();
  }

  private point_at(picked: (number | null)[]): void {
    this.picked = picked;
    this.tell();
  }

  /** Brings what stands around the canvas to what the canvas shows. */
  private tell(): void {
    const view = this.view();
    this.reset_button.disabled = this.zoom === null;
    this.figure.dataset.x = view.x.join(" ");
    this.figure.dataset.y = view.y.join(" ");
    this.figure.dataset.lines = String(this.scene.lines.length);
    this.plot.describe(described(this.scene, view));
    const picked = this.picked ?? this.scene.traces.map((trace) => stepped(this.scene, trace, -1, Infinity));
    this.numbers.replaceChildren(readout(this.scene, picked));
    this.plot.set_dots(this.picked === null ? [] : this.scene.traces.flatMap((trace, i) => {
      const at = picked[i];
      const point = at === null ? null : point_of(this.scene, trace, at, !this.settings.raw);
      return point === null ? [] : [{ x: point[0], y: point[1], style: trace.style }];
    }));
  }

  /** Moves the first trace's cursor from row to row; the others follow to the nearest. */
  private key(event: KeyboardEvent): void {
    const lead = this.scene.traces[0];
    const step = keys[event.key];
    if (step === undefined || lead === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const from = this.picked?.[0] ?? (step > 0 ? -1 : lead.argument.length);
    const at = stepped(this.scene, lead, from, step * (event.shiftKey ? 10 : 1));
    const point = point_of(this.scene, lead, at);
    if (point === null) return;
    const picked = nearest_points(this.scene, ...this.plot.place(...point), (x, y) => this.plot.place(x, y));
    picked[0] = at;
    this.plot.set_cursor(...point);
    this.point_at(picked);
    this.told.textContent = [...this.numbers.querySelectorAll("tbody tr:first-child > *")].map((cell) => cell.textContent!.trim()).join(", ");
  }
}

/** Tells the parts of one figure from those of another. */
let figures = 0;

/** The run that is shown, or how many. */
function what_of(shown: RunData[], all: RunData[]): string {
  const names = [...new Set(shown.map((run) => run.name))];
  return names.length > 1 ? `${names.length} runs` : names[0] ?? all[0].name;
}

/** What the canvas shows, to be read aloud. */
function described(scene: Scene, view: View): string {
  const ends = ([low, high]: Range) => `${Number(low.toPrecision(3))} to ${Number(high.toPrecision(3))}`;
  const names = scene.traces.map((trace) => trace.label).join(", ");
  return `${scene.plan.title}. Across: ${scene.x.title}, ${ends(view.x)}; up: ${scene.y.title}, ${ends(view.y)}. Lines: ${names || "none"}.`;
}
