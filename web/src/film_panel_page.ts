// SPDX-License-Identifier: BSD-3-Clause
// The elements of a panel around its picture: run, field, frame, readings, colours, tools.
import type { FieldData } from "./data";
import { ink_of } from "./film_axes";
import { BAR_HEIGHT, type ColourBar, draw_colour_bar } from "./film_colour_bar";
import type { Range } from "./film_colours";
import { button, choice, icon, make, set_options } from "./film_elements";
import { digits, type Unit } from "./film_numbers";
import { readings, sentence } from "./film_reading";
import type { FilmedRun } from "./film_together";
import { type Player, Transport } from "./film_transport";

/** What the reader asks of a panel. */
export interface Wishes extends Player {
  run(index: number): void;
  field(name: FieldData["name"]): void;
  zoom(factor: number): void;
  region(): void;
  whole_bed(): void;
  /** null: back to the range that the page began with. */
  range(range: Range | null): void;
  save(): void;
}

export class PanelPage {
  readonly element = make("figure", "film-panel");
  private run: ReturnType<typeof choice>;
  private field: ReturnType<typeof choice>;
  private transport: Transport;
  private readings = make("dl", "film-readings");
  private left_out = make("p", "film-left-out quiet");
  private values: HTMLElement[] = [];
  private colours = make("div", "film-colours");
  private bar_title = make("div", "film-bar-title");
  private bar = make("canvas", "film-bar");
  private from = make("input", "film-from");
  private to = make("input", "film-to");
  private unit: Unit = { name: "", factor: 1 };

  constructor(stage: HTMLElement, note: HTMLElement, wishes: Wishes) {
    this.run = choice("film-run", "Run", (value) => wishes.run(Number(value)));
    this.field = choice("film-field", "Colours", (value) => wishes.field(value as FieldData["name"]));
    this.transport = new Transport(wishes);
    this.bar.setAttribute("role", "img");
    for (const [input, label] of [[this.from, "from"], [this.to, "to"]] as const) {
      input.type = "number";
      input.step = "any";
      input.setAttribute("aria-label", `Colours ${label}`);
      input.addEventListener("change", () => this.take_range(wishes));
    }
    this.colours.append(
      this.bar_title,
      this.bar,
      make("div", "film-range", make("label", "", "from ", this.from), make("label", "", " to ", this.to),
        button("film-range-back", "Default range", "Reset the range of the colours", () => wishes.range(null))),
    );
    this.element.append(
      make("div", "film-head", this.run.label, this.field.label),
      stage,
      this.transport.element,
      this.readings,
      this.left_out,
      this.colours,
      make("div", "film-tools",
        button("film-farther", icon("farther"), "Zoom out", () => wishes.zoom(1 / 1.5)),
        button("film-closer", icon("closer"), "Zoom in", () => wishes.zoom(1.5)),
        button("film-region", "Region of interest", "Show the region around the body's path", () => wishes.region()),
        button("film-whole", "Whole bed", "Show all of the soil", () => wishes.whole_bed()),
        button("film-save", "Save picture", "Save this panel with its colour bar as PNG", () => wishes.save()),
        note),
    );
  }

  set_runs(runs: FilmedRun[], chosen: number): void {
    set_options(this.run.select, runs.map((run, i) => [String(i), run.title && run.title !== run.name ? `${run.name}: ${run.title}` : run.name]), String(chosen));
    const run = runs[chosen];
    this.transport.set_frames(run.film.frames.length - 1, run.name);
    this.left_out.textContent = run.film.note ?? "";
    this.left_out.hidden = run.film.note === null;
    const rows = readings(run, 0).map(([name]) => ({ name: make("dt", "", name), value: make("dd", "") }));
    this.values = rows.map((row) => row.value);
    this.readings.replaceChildren(...rows.map((row) => make("div", "", row.name, row.value)));
  }

  /** Puts a picture in the place of all else, for paper; null takes it away. */
  show_print(picture: HTMLCanvasElement | null): void {
    this.element.querySelector(".film-print")?.remove();
    this.element.classList.toggle("film-printed", picture !== null);
    if (picture === null) return;
    picture.classList.add("film-print");
    this.element.append(picture);
  }

  set_fields(fields: FieldData[], chosen: string): void {
    set_options(this.field.select, fields.map((field) => [field.name, field.label]), chosen);
  }

  show_playing(playing: boolean): void {
    this.transport.show_playing(playing);
  }

  show_moment(run: FilmedRun, at: number): void {
    this.transport.show(at, run.film.frames.length - 1, sentence(run, null, at));
    readings(run, at).forEach(([, value], i) => {
      if (this.values[i].textContent !== value) this.values[i].textContent = value;
    });
  }

  /** Shows the colours' meaning; null: there is none. */
  show_bar(bar: ColourBar | null, label: string): void {
    this.colours.classList.toggle("film-without", bar === null);
    if (bar === null) return;
    const { range, unit } = bar;
    this.unit = unit;
    this.bar_title.textContent = `${label} (${unit.name})`;
    this.bar_title.dataset.unit = unit.name;
    const shown = (value: number) => String(Number((value / unit.factor).toPrecision(4)));
    this.from.value = shown(range.from);
    this.to.value = shown(range.to);
    this.from.setCustomValidity("");
    this.to.setCustomValidity("");
    this.bar.setAttribute("aria-label", `Colour bar: ${label}, from ${digits(range.from / unit.factor)} to ${digits(range.to / unit.factor)} ${unit.name}`);

    const width = this.bar.clientWidth;
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.bar.width = Math.round(width * ratio);
    this.bar.height = Math.round(BAR_HEIGHT * ratio);
    const context = this.bar.getContext("2d")!;
    context.scale(ratio, ratio);
    draw_colour_bar(context, bar, 0, 0, width, ink_of(this.element));
  }

  private take_range(wishes: Wishes): void {
    const range = { from: this.from.valueAsNumber * this.unit.factor, to: this.to.valueAsNumber * this.unit.factor };
    const sound = Number.isFinite(range.from) && Number.isFinite(range.to) && range.from < range.to;
    this.to.setCustomValidity(sound ? "" : "The range must end above where it begins.");
    if (sound) wishes.range(range);
    else this.to.reportValidity();
  }
}
