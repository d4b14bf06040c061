// SPDX-License-Identifier: BSD-3-Clause
// One panel: a run, a field, a moment, a camera. It loads what it needs and draws when one of them has changed.
import type { FieldData } from "./data";
import { type Box, type Camera, camera_of, panned, REGION, type Window, window_of, zoomed } from "./film_camera";
import type { ColourBar } from "./film_colour_bar";
import { colour_table, type Range } from "./film_colours";
import { listen } from "./film_gestures";
import { draw_axes, MARGIN, PAPER, type Scene } from "./film_axes";
import { type Arrows, arrows_of } from "./film_flow";
import { display_unit } from "./film_numbers";
import type { Look } from "./film_painter";
import { PanelPage, type Wishes } from "./film_panel_page";
import { compose, save_picture } from "./film_picture";
import { moment_at, sentence } from "./film_reading";
import { FilmParts, type Soil, type Values } from "./film_soil";
import { FilmStage } from "./film_stage";
import type { FilmedRun } from "./film_together";

/** What a panel asks of those who join the panels; `look` and `play` come from the picture, too. */
export interface PanelWishes extends Omit<Wishes, "zoom" | "region" | "save"> {
  look(camera: Camera): void;
  first(): void;
  last(): void;
}

export class FilmPanel {
  at = 0;
  camera: Camera = REGION;
  field_name: FieldData["name"] = "deviatoric_strain";
  region: Box;
  readonly page: PanelPage;
  readonly stage: FilmStage;
  private soil: Soil | null = null;
  private values: Values | null = null;
  private outlines: Float64Array[][] = [];
  private flow: Int8Array[] | null = null;
  private with_arrows = true;
  private default_range: Range = { from: 0, to: 1 };
  private range: Range = this.default_range;
  private colours: Uint8Array = new Uint8Array(4 * 256);
  private pending = 0;
  private seen = true;
  private loading = 0;
  private frames_drawn = 0;
  private may_load = false;
  private bar_of = "";

  constructor(
    public run: FilmedRun,
    private parts: FilmParts,
    private wishes: PanelWishes,
  ) {
    this.region = run.film.view;
    this.stage = new FilmStage((another_painter) => {
      if (another_painter) this.arm_painter();
      this.bar_of = "";
      this.request_draw();
    });
    this.page = new PanelPage(this.stage.element, this.stage.note, {
      ...wishes,
      zoom: (factor) => this.zoom(factor, null),
      region: () => wishes.look(REGION),
      save: () => this.save(),
    });
    // A canvas of WebGL is blank on paper; a picture of the panel is not, and has twice the pixels.
    addEventListener("beforeprint", () => this.page.show_print(this.picture_at(this.at, 2)));
    addEventListener("afterprint", () => this.page.show_print(null));
    listen(this.stage.element, {
      drag: (right, down) => {
        const { width, height } = this.stage.plot;
        wishes.look(this.bounded(panned(this.camera, this.window, this.region, -right / width, down / height)));
      },
      zoom: (factor, about) => this.zoom(factor, about),
      play: () => wishes.play(),
      step: (frames) => wishes.step(frames),
      first: () => wishes.first(),
      last: () => wishes.last(),
      region: () => wishes.look(REGION),
    });
  }

  get film(): FilmedRun["film"] {
    return this.run.film;
  }

  get last(): number {
    return this.film.frames.length - 1;
  }

  /** null: this film does not hold the field that the panels show. */
  get field(): FieldData | null {
    return this.film.fields.find((field) => field.name === this.field_name) ?? null;
  }

  show_run(run: FilmedRun, parts: FilmParts): void {
    this.run = run;
    this.parts = parts;
    this.soil = null;
    void this.load();
  }

  /** What the camera looks at where it is not moved. */
  set_region(region: Box): void {
    this.region = region;
    this.stage.fit((region.upper[1] - region.lower[1]) / (region.upper[0] - region.lower[0]));
    this.camera = this.bounded(this.camera);
    this.request_draw();
  }

  show_field(name: FieldData["name"]): void {
    this.field_name = name;
    void this.load();
  }

  show_arrows(on: boolean): void {
    this.with_arrows = on;
    this.request_draw();
  }

  go_to(at: number): void {
    this.at = Math.min(this.last, Math.max(0, at));
    this.request_draw();
  }

  look(camera: Camera): void {
    this.camera = this.bounded(camera);
    this.request_draw();
  }

  /** The camera that sees all soil; null before it is loaded. */
  whole_bed(): Camera | null {
    return this.soil === null ? null : camera_of(this.soil.bounds, this.region, this.aspect);
  }

  set_range(range: Range, default_range: Range): void {
    this.default_range = default_range;
    this.range = range.to > range.from ? range : { from: range.from, to: range.from + 1e-12 };
    this.request_draw();
  }

  /** Lets the panel unpack its film from now on. */
  begin(): void {
    if (this.may_load) return;
    this.may_load = true;
    void this.load();
  }

  see(seen: boolean): void {
    this.seen = seen;
    if (seen) this.request_draw();
  }

  /** Draws before the next paint if the panel is seen; many changes make one drawing. */
  request_draw(): void {
    if (this.pending !== 0 || !this.seen) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      this.draw();
    });
  }

  /** Draws with the page's colours as they are now; before a print at once, seen or not. */
  recolour(): void {
    this.bar_of = "";
    if (matchMedia("print").matches) this.draw();
    else this.request_draw();
  }

  private get aspect(): number {
    const { width, height } = this.stage.plot;
    return width / height;
  }

  private get window(): Window {
    return window_of(this.camera, this.region, this.aspect);
  }

  private zoom(factor: number, about: { x: number; y: number } | null): void {
    const { width, height } = this.stage.plot;
    const right = about === null ? 0 : (about.x - MARGIN.left) / width - 0.5;
    const up = about === null ? 0 : 0.5 - (about.y - MARGIN.top) / height;
    const allowed = this.bounded({ ...this.camera, zoom: this.camera.zoom * factor }).zoom / this.camera.zoom;
    this.wishes.look(zoomed(this.camera, this.window, this.region, allowed, right, up));
  }

  /** Neither farther than the whole bed, nor so near that particles become tiles; the middle stays over the bed. */
  private bounded(camera: Camera): Camera {
    const { lower, step } = this.film;
    const view = this.region;
    const region = window_of(REGION, view, this.aspect);
    const bed = { lower, upper: [lower[0] + 65535 * step, lower[1] + 65535 * step] as [number, number] };
    const farthest = region.width / (1.5 * (bed.upper[0] - bed.lower[0]));
    const zoom = Math.min(100, Math.max(Math.min(0.5, farthest), camera.zoom));
    const side = view.upper[0] - view.lower[0];
    const within = (value: number, axis: 0 | 1) => {
      const middle = (view.lower[axis] + view.upper[axis]) / 2;
      return Math.min((bed.upper[axis] - middle) / side, Math.max((bed.lower[axis] - middle) / side, value));
    };
    return { x: within(camera.x, 0), y: within(camera.y, 1), zoom };
  }

  private async load(): Promise<void> {
    if (!this.may_load) return;
    const mine = ++this.loading;
    const { field, parts, film } = this;
    this.set_state("loading");
    this.stage.tell("Loading the film …");
    try {
      const [soil, values, outlines, flow] = await Promise.all([
        parts.soil(),
        field === null ? null : parts.values(field),
        Promise.all(film.rigids.map((rigid) => parts.outline(rigid))),
        film.flow === undefined ? null : parts.flow(film.flow),
      ]);
      if (mine !== this.loading) return;
      this.soil = soil;
      this.values = values;
      this.outlines = outlines;
      this.flow = flow;
      if (field !== null) this.colours = colour_table(field);
      this.arm_painter();
      this.bar_of = "";
      this.stage.tell(field === null ? "This film does not contain the chosen field; its soil is grey." : "");
      this.set_state("ready");
      this.request_draw();
    } catch (error) {
      if (mine !== this.loading) return;
      this.stage.tell((error as Error).message);
      this.set_state("damaged");
    }
  }

  private set_state(state: "loading" | "ready" | "damaged"): void {
    this.page.element.dataset.state = state;
    this.stage.element.setAttribute("aria-busy", String(state === "loading"));
  }

  private arm_painter(): void {
    if (this.soil === null) return;
    this.stage.painter.show_soil(this.soil);
    this.stage.painter.show_values(this.values?.frames ?? null, this.colours);
  }

  private make_look(): Look {
    const byte = (value: number) => (this.field === null ? 0 : (255 * (value - this.field.low)) / (this.field.high - this.field.low || 1));
    return { ...moment_at(this.run, this.at), window: this.window, from_byte: byte(this.range.from), to_byte: byte(this.range.to) };
  }

  private draw(): void {
    this.page.show_moment(this.run, this.at);
    if (this.soil === null) return;
    this.stage.draw(this.make_look(), this.scene());
    const label = sentence(this.run, this.field, this.at);
    this.stage.over.setAttribute("aria-label", label);
    const bar = this.colour_bar();
    const bar_now = JSON.stringify([bar?.range, this.field?.name, this.default_range]);
    if (bar_now !== this.bar_of) {
      this.page.show_bar(bar, this.field?.label ?? "");
      this.bar_of = bar_now;
    }
    const { dataset } = this.page.element;
    dataset.run = this.run.name;
    dataset.frame = String(Number(this.at.toFixed(4)));
    dataset.field = this.field?.name ?? "";
    dataset.arrows = String(this.arrows_now()?.list.length ?? 0);
    dataset.painter = this.stage.painter.kind;
    dataset.framesDrawn = String(++this.frames_drawn);
  }

  private scene(): Omit<Scene, "width" | "height"> {
    return { window: this.window, surface: this.film.surface, ground: this.film.ground, outlines: this.outlines_now(), arrows: this.arrows_now() };
  }

  /** Those of the nearest frame. */
  private arrows_now(): Arrows | null {
    if (!this.with_arrows || this.flow === null || this.film.flow === undefined) return null;
    const frame = Math.round(this.at);
    return arrows_of(this.film.flow, this.flow[frame], frame);
  }

  private outlines_now(): Float64Array[] {
    const { frame, part } = moment_at(this.run, this.at);
    return this.outlines.map((frames) => {
      const [now, next] = [frames[frame], frames[Math.min(frame + 1, frames.length - 1)]];
      return part === 0 ? now : now.map((x, i) => x + part * (next[i] - x));
    });
  }

  private colour_bar(): ColourBar | null {
    const { field, values, range } = this;
    if (field === null || values === null) return null;
    const unit = display_unit(field.unit, Math.max(Math.abs(this.default_range.from), Math.abs(this.default_range.to)));
    return {
      colours: this.colours,
      range,
      unit,
      clipped_low: range.from > field.low || (range.from === field.low && values.at_low && field.low !== 0),
      clipped_high: range.to < field.high || (range.to === field.high && values.at_high && field.high !== 0),
    };
  }

  private save(): void {
    const picture = this.picture_at(this.at, 3);
    if (picture !== null) save_picture(picture, `${this.run.name} ${this.field?.name ?? "soil"} frame ${Number(this.at.toFixed(1))}`);
  }

  /** The panel with its colour bar and a caption as it is at a moment, black on white, `ratio` pixels for one px of the page; null before it is loaded. */
  picture_at(at: number, ratio: number): HTMLCanvasElement | null {
    if (this.soil === null) return null;
    const before = this.at;
    this.at = at;
    const { element } = this.stage;
    const bar = this.colour_bar();
    const scene = { ...this.scene(), width: element.clientWidth, height: element.clientHeight };
    const bar_title = bar === null ? "" : `${this.field!.label} (${bar.unit.name})`;
    const caption = `${this.run.title}. ${sentence(this.run, this.field, at)}.`;
    let picture: HTMLCanvasElement | null = null;
    const { width, height } = scene;
    this.stage.draw_at(ratio, this.make_look(), (soil) => {
      const draw = (context: CanvasRenderingContext2D) => {
        context.drawImage(soil, MARGIN.left, MARGIN.top, width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom);
        draw_axes(context, scene, PAPER);
      };
      picture = compose({ width, height, draw, bar, bar_title, caption, ratio });
    });
    this.at = before;
    return picture;
  }
}
