// SPDX-License-Identifier: BSD-3-Clause
// The soil of runs in space, seen from any side: a run, a field, a moment, a camera, cuts.
import type { FieldData, RunData, SpaceData } from "./data";
import { PAPER } from "./film_axes";
import { Clock } from "./film_clock";
import type { ColourBar } from "./film_colour_bar";
import { colour_table, type Range } from "./film_colours";
import { button, choice, make, set_options, tick_box } from "./film_elements";
import { listen } from "./film_gestures";
import { display_unit } from "./film_numbers";
import { PanelPage } from "./film_panel_page";
import { compose, save_picture } from "./film_picture";
import { moment_at, sentence } from "./film_reading";
import type { Values } from "./film_soil";
import type { FilmedRun } from "./film_together";
import { speed_choice } from "./film_transport";
import { axes_of, closer, type OrbitCamera, seeing, shifted, turned, VIEWS } from "./space_camera";
import { CutControls, kept_by } from "./space_cuts";
import { draw_marks } from "./space_marks";
import type { Bodies, SpaceLook } from "./space_painter";
import { on_surface, seen_box, type SpaceBox, SpaceParts, type SpaceSoil, type Surface } from "./space_parts";
import { SpaceStage } from "./space_stage";

/** A run in space whose film holds all of it. */
type SpaceRun = RunData & { film: SpaceData };

/** Radians for one px of the page. */
const TURN = 0.008;
const BODIES: Record<Bodies, string> = { solid: "solid", clear: "see-through", hidden: "hidden" };
const HELP =
  "A drag or Shift with arrows turns the view; a drag with Shift, two fingers, or the keys a d w s move it; + and − or the wheel zoom (Ctrl with the wheel without a click " +
  "on the picture). Keys i f r t: isometric, from the front, the side, above; 0 back to the beginning. Space plays, ← → go frame by frame, Home and End to the first and last.";

/** Shows the runs that have a film in space; does nothing where there is none. */
export function show_space(section: HTMLElement, runs: RunData[]): void {
  const films = runs.flatMap((run) => (run.film?.space ? [{ ...run, film: run.film.space }] : []));
  if (films.length > 0) new SpacePanel(section, films);
}

class SpacePanel {
  private at = 0;
  private run: SpaceRun;
  private parts: SpaceParts[];
  private field_name: string;
  private ranges = new Map<string, Range>();
  private camera: OrbitCamera | null = null;
  private soil: SpaceSoil | null = null;
  private surfaces: Surface[] = [];
  private values: Values | null = null;
  private colours: Uint8Array = new Uint8Array(4 * 256);
  private masks = new Map<number, Uint8Array>();
  private only_surface = false;
  private bodies: Bodies = "solid";
  private cut_bodies = true;
  private speed = 5;
  private pending = 0;
  private seen = true;
  private loading = 0;
  private may_load = false;
  private frames_drawn = 0;
  private bar_of = "";
  private page: PanelPage;
  private stage: SpaceStage;
  private cuts = new CutControls(() => this.request_draw());
  private clock = new Clock((seconds) => this.advance(seconds), () => this.page.show_playing(this.clock.playing));

  constructor(section: HTMLElement, private runs: SpaceRun[]) {
    this.run = runs[0];
    this.parts = runs.map((run) => new SpaceParts(run.film));
    this.field_name = this.run.film.fields[0].name;
    this.at = this.last;
    this.stage = new SpaceStage((another_painter) => {
      if (another_painter) this.arm_painter();
      this.bar_of = "";
      this.request_draw();
    });
    const step = (frames: number) => this.move(frames > 0 ? Math.floor(this.at + 1e-9) + frames : Math.ceil(this.at - 1e-9) + frames);
    const play = () => this.play_or_pause();
    this.page = new PanelPage(this.stage.element, this.stage.note, {
      run: (index) => this.show_run(index),
      field: (name) => this.show_field(name),
      move: (at) => this.move(at),
      step,
      play,
      zoom: (factor) => this.look(closer(this.camera!, factor)),
      region: () => this.look_from("iso", this.region()),
      whole_bed: () => this.look_from("iso"),
      range: (range) => this.set_range(range),
      save: () => this.save(),
    });
    listen(this.stage.element, {
      drag: (right, down) => this.look(turned(this.camera!, TURN * right, TURN * down)),
      pan: (right, down) => this.look(shifted(this.camera!, right / this.stage.size.height, down / this.stage.size.height)),
      zoom: (factor, about) => this.zoom(factor, about),
      play,
      step,
      first: () => this.move(0),
      last: () => this.move(this.last),
      region: () => this.look_from("iso"),
      keys: {
        ...Object.fromEntries(Object.entries(VIEWS).map(([name, { key }]) => [key, () => this.look_from(name as keyof typeof VIEWS)])),
        a: () => this.look(shifted(this.camera!, 0.05, 0)),
        d: () => this.look(shifted(this.camera!, -0.05, 0)),
        w: () => this.look(shifted(this.camera!, 0, 0.05)),
        s: () => this.look(shifted(this.camera!, 0, -0.05)),
      },
    });
    section.classList.add("film");
    this.stage.element.before(this.make_tools());
    section.append(make("h3", "", "In space"), make("div", "film-panels", this.page.element), make("p", "film-help quiet", HELP), make("h3", "", "The slice in the middle"));
    this.describe();
    this.page.show_playing(false);
    this.wake(section);
  }

  private get last(): number {
    return this.run.film.frames.length - 1;
  }

  private get filmed(): FilmedRun {
    return this.run;
  }

  private get field(): FieldData | null {
    return this.run.film.fields.find((field) => field.name === this.field_name) ?? null;
  }

  private make_tools(): HTMLElement {
    const views = Object.entries(VIEWS).map(([name, { label, key }]) =>
      button(`space-view space-${name}`, label, `${label} view (key ${key})`, () => this.look_from(name as keyof typeof VIEWS)));
    const bodies = choice("space-bodies", "Bodies", (value) => {
      this.bodies = value as Bodies;
      this.request_draw();
    });
    set_options(bodies.select, Object.entries(BODIES), this.bodies);
    const surface = tick_box("space-surface", "Only the soil's surface", false, (on) => {
      this.only_surface = on;
      this.request_draw();
    });
    const cut_bodies = tick_box("space-cut-bodies", "Cut bodies, too", true, (on) => {
      this.cut_bodies = on;
      this.request_draw();
    });
    const group = make("div", "space-tools", ...views, bodies.label, surface, cut_bodies, speed_choice("space-speed", this.speed, (speed) => (this.speed = speed)), this.cuts.element);
    group.setAttribute("role", "group");
    group.setAttribute("aria-label", "View, cuts and bodies");
    return group;
  }

  private wake(section: HTMLElement): void {
    const begin = () => {
      if (this.may_load) return;
      this.may_load = true;
      void this.load();
    };
    new IntersectionObserver((entries) => entries.some((entry) => entry.isIntersecting) && begin(), { rootMargin: "600px" }).observe(section);
    window.addEventListener("load", () => setTimeout(begin, 500));
    new IntersectionObserver((entries) => {
      this.seen = entries[entries.length - 1].isIntersecting;
      this.clock.hold(!this.seen);
      if (this.seen) this.request_draw();
    }).observe(this.stage.element);
    document.addEventListener("theme", () => {
      this.bar_of = "";
      this.request_draw();
    });
    // A canvas of WebGL is blank on paper; a picture of it is not, and has twice the pixels.
    addEventListener("beforeprint", () => this.page.show_print(this.picture(2)));
    addEventListener("afterprint", () => this.page.show_print(null));
  }

  private show_run(index: number): void {
    this.clock.pause();
    this.run = this.runs[index];
    this.soil = null;
    this.camera = null;
    this.at = this.last;
    if (this.field === null) this.field_name = this.run.film.fields[0].name;
    this.describe();
    void this.load();
  }

  private show_field(name: string): void {
    this.field_name = name;
    this.describe();
    void this.load();
  }

  private set_range(range: Range | null): void {
    if (range === null) this.ranges.delete(this.field_name);
    else this.ranges.set(this.field_name, range);
    this.request_draw();
  }

  private describe(): void {
    this.page.set_runs(this.runs, this.runs.indexOf(this.run));
    this.page.set_fields(this.run.film.fields, this.field_name);
  }

  private move(at: number): void {
    this.clock.pause();
    this.go(at);
  }

  private go(at: number): void {
    this.at = Math.min(this.last, Math.max(0, at));
    this.request_draw();
  }

  private play_or_pause(): void {
    if (this.clock.playing) return this.clock.pause();
    if (this.at >= this.last) this.go(0);
    this.clock.play();
  }

  private advance(seconds: number): boolean {
    this.go(this.at + seconds * this.speed);
    return this.at < this.last;
  }

  private look(camera: OrbitCamera): void {
    if (this.soil === null) return;
    const { box } = this.soil;
    const size = Math.hypot(...box.upper.map((x, d) => x - box.lower[d]));
    const target = camera.target.map((x, d) => Math.min(box.upper[d] + size / 2, Math.max(box.lower[d] - size / 2, x))) as OrbitCamera["target"];
    this.camera = { ...camera, target, height: Math.min(4 * size, Math.max(size / 200, camera.height)) };
    this.request_draw();
  }

  private look_from(view: keyof typeof VIEWS, box = this.whole()): void {
    if (box !== undefined) this.look(seeing(box, VIEWS[view], this.stage.aspect));
  }

  private whole(): SpaceBox | undefined {
    return this.soil === null ? undefined : seen_box(this.soil, this.surfaces);
  }

  /** The film's region of interest, over as much of z as along x. */
  private region(): SpaceBox | undefined {
    if (this.soil === null) return undefined;
    const { view } = this.run.film, { box } = this.soil;
    const half = (view.upper[0] - view.lower[0]) / 2, middle = (box.lower[2] + box.upper[2]) / 2;
    return {
      lower: [...view.lower, Math.max(box.lower[2], middle - half)] as OrbitCamera["target"],
      upper: [...view.upper, Math.min(box.upper[2], middle + half)] as OrbitCamera["target"],
    };
  }

  private zoom(factor: number, about: { x: number; y: number } | null): void {
    const { width, height } = this.stage.size;
    this.look(closer(this.camera!, factor, about === null ? 0 : (about.x - width / 2) / height, about === null ? 0 : (height / 2 - about.y) / height));
  }

  private async load(): Promise<void> {
    if (!this.may_load) return;
    const mine = ++this.loading;
    const { run, field } = this, parts = this.parts[this.runs.indexOf(run)];
    this.set_state("loading");
    this.stage.tell("Loading the soil in space …");
    try {
      const [soil, values, surfaces] = await Promise.all([
        parts.whole(), field === null ? null : parts.values(field), Promise.all(run.film.surfaces.map((surface) => parts.surface(surface)))]);
      if (mine !== this.loading) return;
      if (this.soil !== soil) {
        this.soil = soil;
        this.masks.clear();
        this.cuts.set_box(soil.box);
        this.camera = seeing(seen_box(soil, surfaces), VIEWS.iso, this.stage.aspect);
      }
      Object.assign(this, { values, surfaces });
      if (field !== null) this.colours = colour_table(field);
      this.arm_painter();
      this.bar_of = "";
      this.stage.tell("");
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
    this.stage.painter.show({ soil: this.soil, surfaces: this.surfaces, values: this.values?.frames ?? null, colours: this.colours });
  }

  private make_look(soil: SpaceSoil, line: string): SpaceLook {
    const { field, range } = this;
    const byte = (value: number) => (field === null ? 0 : (255 * (value - field.low)) / (field.high - field.low || 1));
    const moment = moment_at(this.filmed, this.at);
    // A slice is as thick as two particles: then no row falls between its sides.
    const thickness = 2 * soil.step * soil.sizes.reduce((a, b) => Math.max(a, b), 1);
    return {
      ...moment, camera: this.camera!, from_byte: byte(range.from), to_byte: byte(range.to), kept: kept_by(this.cuts.cuts, thickness),
      mask: this.only_surface ? this.surface_mask(soil, moment.frame) : null, bodies: this.bodies, cut_bodies: this.cut_bodies, line,
    };
  }

  private surface_mask(soil: SpaceSoil, frame: number): Uint8Array {
    const made = this.masks.get(frame) ?? on_surface(soil, frame);
    this.masks.set(frame, made);
    return made;
  }

  private get default_range(): Range {
    return { from: this.field?.low ?? 0, to: this.field?.high ?? 1 };
  }

  private get range(): Range {
    return this.ranges.get(this.field_name) ?? this.default_range;
  }

  private request_draw(): void {
    if (this.pending !== 0 || !this.seen) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      this.draw();
    });
  }

  private draw(): void {
    this.page.show_moment(this.filmed, this.at);
    if (this.soil === null || this.camera === null) return;
    this.stage.draw(this.make_look(this.soil, this.stage.ink.quiet), this.soil.box);
    this.stage.over.setAttribute("aria-label", `In space: ${sentence(this.filmed, this.field, this.at)}; ${this.direction()}`);
    const bar = this.colour_bar(), bar_now = JSON.stringify([bar?.range, this.field_name]);
    if (bar_now !== this.bar_of) {
      this.page.show_bar(bar, this.field?.label ?? "");
      this.bar_of = bar_now;
    }
    const { dataset } = this.page.element;
    dataset.run = this.run.name;
    dataset.frame = String(Number(this.at.toFixed(4)));
    dataset.field = this.field?.name ?? "";
    dataset.painter = this.stage.painter.kind;
    dataset.framesDrawn = String(++this.frames_drawn);
  }

  /** Where it is seen from, in words. */
  private direction(): string {
    const { back } = axes_of(this.camera!);
    return `seen from the direction (${back.map((x) => x.toFixed(2).replace("-", "−")).join(", ")})`;
  }

  private colour_bar(): ColourBar | null {
    const { field, values, range, default_range } = this;
    if (field === null || values === null) return null;
    const unit = display_unit(field.unit, Math.max(Math.abs(default_range.from), Math.abs(default_range.to)));
    return {
      colours: this.colours,
      range,
      unit,
      clipped_low: range.from > field.low || (range.from === field.low && values.at_low && field.low !== 0),
      clipped_high: range.to < field.high || (range.to === field.high && values.at_high && field.high !== 0),
    };
  }

  private save(): void {
    const picture = this.picture(3);
    if (picture !== null) save_picture(picture, `${this.run.name} in space ${this.field?.name ?? "soil"} frame ${Number(this.at.toFixed(1))}`);
  }

  /** What is seen, black on white, with colour bar and caption, `ratio` pixels for one px of the page; null before it is loaded. */
  private picture(ratio: number): HTMLCanvasElement | null {
    const { soil, camera, stage, field } = this;
    if (soil === null || camera === null) return null;
    const { width, height } = stage.size, bar = this.colour_bar();
    const bar_title = bar === null ? "" : `${field!.label} (${bar.unit.name})`;
    const left_out = this.run.film.note === null ? "" : ` Shown: ${this.run.film.note}.`;
    const caption = `${this.run.title}. ${sentence(this.filmed, field, this.at)}.${left_out}`;
    let picture: HTMLCanvasElement | null = null;
    stage.draw_at(ratio, this.make_look(soil, PAPER.quiet), (drawn) => {
      const draw = (context: CanvasRenderingContext2D) => {
        context.drawImage(drawn, 0, 0, width, height);
        draw_marks(context, camera, soil.box, width, height, PAPER);
      };
      picture = compose({ width, height, draw, bar, bar_title, caption, ratio });
    });
    return picture;
  }
}
