// SPDX-License-Identifier: BSD-3-Clause
// The section with the moving soil: one panel, or two that go together.
import type { FieldData, PageData } from "./data";
import type { Camera } from "./film_camera";
import { Clock } from "./film_clock";
import { common_range, type Range } from "./film_colours";
import { button, choice, make, set_options, tick_box } from "./film_elements";
import { KEYS_HELP } from "./film_gestures";
import { MirroredParts, mirrored_film } from "./film_mirror";
import { FilmPanel } from "./film_panel";
import { FilmParts } from "./film_soil";
import { FilmCurves, type FilmMoment } from "./film_curves";
import { save_film } from "./film_gif";
import { common_region, embedment_at, type FilmedRun, first_pair, frame_of_drag, type Join, joins_of, JOINS, partner, where } from "./film_together";
import { speed_choice } from "./film_transport";

/** Fills the section with the moving soil; `moved` hears what the panels show. */
export function show_films(section: HTMLElement, data: PageData, moved: (moments: FilmMoment[]) => void): Films | null {
  const runs = data.runs.filter((run): run is FilmedRun => run.film !== null && run.film.frames.length > 0);
  if (runs.length > 0) return new Films(section, runs, new FilmCurves(data), moved);
  section.append(make("p", "film-none quiet", "These runs contain no film of the soil."));
  return null;
}

/** s, between two frames. */
function time_at(run: FilmedRun, at: number): number {
  const { frames } = run.film;
  const frame = Math.min(Math.floor(at), frames.length - 1), next = Math.min(frame + 1, frames.length - 1);
  return frames[frame].time + (at - frame) * (frames[next].time - frames[frame].time);
}

export class Films {
  private runs: FilmedRun[] = [];
  private parts: FilmParts[] = [];
  private panels: FilmPanel[];
  private clocks: Clock[];
  private linked = true;
  private join: Join = "part";
  private speed = 10;
  private ranges = new Map<FilmPanel, Map<string, Range>>();
  private together = choice("film-together", "synchronised by", (value) => this.join_by(value as Join));
  private same = button("film-same", "Same embedment", "Put the left panel on the frame of its drag where the body is as deep as in the right panel", () => this.same_embedment());
  private save = button("film-gif", "Save film (GIF)", "Save all frames of the left panel, with the other beside it, as an animated picture", () => void this.save_gif());
  private moved: (moments: FilmMoment[]) => void;

  constructor(section: HTMLElement, private readonly halves: FilmedRun[], curves: FilmCurves, moved: (moments: FilmMoment[]) => void) {
    this.moved = (moments) => {
      curves.show(moments);
      moved(moments);
    };
    this.show_halves(true);
    const { runs } = this;
    const chosen = first_pair(runs);
    this.panels = chosen.map((run, i) => this.make_panel(run, i));
    this.clocks = this.panels.map((panel) => new Clock((seconds) => this.advance(panel, seconds), () => this.show_playing()));
    section.append(this.make_bar(), make("div", "film-panels", ...this.panels.map((panel) => panel.page.element)), curves.element, make("p", "film-help quiet", KEYS_HELP));
    section.classList.add("film");

    const names = this.fields_of(this.panels).map((field) => field.name);
    const field = names.includes("incremental_deviatoric_strain") ? "incremental_deviatoric_strain" : names[0];
    for (const [i, panel] of this.panels.entries()) {
      panel.field_name = field;
      panel.show_run(runs[chosen[i]], this.parts[chosen[i]]);
      panel.at = panel.last;
    }
    this.describe();
    if (this.right !== undefined) this.join = joins_of(this.panels[0].run, this.right.run)[0];
    this.same_embedment();
    this.describe();
    this.show_playing();
    this.wake(section);
  }

  /** Goes to the moment of a run that a panel shows. */
  follow({ run, time }: FilmMoment): void {
    const panel = this.panels.find((one) => one.run.name === run.name);
    if (panel !== undefined) this.move(panel, where(panel.run.film.frames.map((frame) => frame.time), time));
  }

  private make_panel(run: number, place: number): FilmPanel {
    const me = () => this.panels[place];
    return new FilmPanel(this.runs[run], this.parts[run], {
      run: (index) => this.show_run(me(), index),
      field: (name) => this.show_field(me(), name),
      move: (at) => this.move(me(), at),
      step: (frames) => this.move(me(), frames > 0 ? Math.floor(me().at + 1e-9) + frames : Math.ceil(me().at - 1e-9) + frames),
      first: () => this.move(me(), 0),
      last: () => this.move(me(), me().last),
      play: () => this.play_or_pause(me()),
      look: (camera) => this.look(me(), camera),
      whole_bed: () => this.look(me(), me().whole_bed()),
      range: (range) => this.set_range(me(), range),
    });
  }

  private make_bar(): HTMLElement {
    const bar = make("div", "film-bar-of-all", speed_choice("film-speed", this.speed, (speed) => (this.speed = speed)));
    if (this.panels.length === 2) {
      set_options(this.together.select, Object.entries(JOINS), this.join);
      bar.append(tick_box("film-linked", "Linked", true, (on) => this.link(on)), this.together.label, this.same);
    }
    if (this.halves.some((run) => run.film.around_axis)) bar.append(tick_box("film-both", "Both halves around the axis", true, (on) => this.mirror(on)));
    if (this.halves.some((run) => run.film.flow !== undefined))
      bar.append(tick_box("film-arrows", "Arrows of the water's flow", true, (on) => this.panels.forEach((panel) => panel.show_arrows(on))));
    bar.append(this.save);
    return bar;
  }

  /** Unpacks when the section comes near or the browser has time; draws only what is seen. */
  private wake(section: HTMLElement): void {
    const begin = () => this.panels.forEach((panel) => panel.begin());
    new IntersectionObserver((entries) => entries.some((entry) => entry.isIntersecting) && begin(), { rootMargin: "600px" }).observe(section);
    window.addEventListener("load", () => setTimeout(begin, 500));
    let on_screen = false;
    const look_again = () => {
      const seen = on_screen && !document.hidden;
      this.clocks.forEach((clock) => clock.hold(!seen));
      this.panels.forEach((panel) => panel.see(seen));
    };
    new IntersectionObserver((entries) => {
      on_screen = entries[entries.length - 1].isIntersecting;
      look_again();
    }).observe(section);
    document.addEventListener("visibilitychange", look_again);
    document.addEventListener("theme", () => this.panels.forEach((panel) => panel.recolour()));
  }

  /** Takes the runs around an axis with both of their halves, or as they are. */
  private show_halves(both: boolean): void {
    const mirrored = (run: FilmedRun) => both && run.film.around_axis;
    this.runs = this.halves.map((run) => (mirrored(run) ? { ...run, film: mirrored_film(run.film) } : run));
    this.parts = this.halves.map((run) => (mirrored(run) ? new MirroredParts(run.film) : new FilmParts(run.film)));
  }

  private mirror(both: boolean): void {
    this.pause();
    const shown = this.panels.map((panel) => this.runs.indexOf(panel.run));
    this.show_halves(both);
    for (const [i, panel] of this.panels.entries()) panel.show_run(this.runs[shown[i]], this.parts[shown[i]]);
    this.describe();
  }

  private get right(): FilmPanel | undefined {
    return this.panels[1];
  }

  /** The panel and, where they are linked, the other. */
  private with(panel: FilmPanel): FilmPanel[] {
    return this.linked ? this.panels : [panel];
  }

  private show_run(panel: FilmPanel, index: number): void {
    this.pause();
    panel.show_run(this.runs[index], this.parts[index]);
    this.describe();
    const other = this.panels.find((one) => one !== panel);
    panel.go_to(this.linked && other !== undefined ? this.partner(other, panel) : panel.last);
    this.tell();
  }

  private show_field(panel: FilmPanel, name: FieldData["name"]): void {
    for (const one of this.with(panel)) one.show_field(name);
    this.describe();
  }

  private move(panel: FilmPanel, at: number): void {
    this.pause();
    this.go(panel, at);
  }

  private go(panel: FilmPanel, at: number): void {
    panel.go_to(at);
    for (const one of this.with(panel)) if (one !== panel) one.go_to(this.partner(panel, one));
    this.tell();
  }

  /** Where `follower` is when `leader` is where it is. */
  private partner(leader: FilmPanel, follower: FilmPanel): number {
    return partner(this.join, leader.run, leader.at, follower.run);
  }

  private tell(): void {
    this.moved(this.panels.map((panel) => ({ run: this.halves[this.runs.indexOf(panel.run)], time: time_at(panel.run, panel.at) })));
  }

  private look(panel: FilmPanel, camera: Camera | null): void {
    if (camera !== null) for (const one of this.with(panel)) one.look(camera);
  }

  private play_or_pause(panel: FilmPanel): void {
    const clock = this.clocks[this.panels.indexOf(panel)];
    if (this.linked ? this.clocks.some((one) => one.playing) : clock.playing) {
      for (const one of this.with(panel)) this.clocks[this.panels.indexOf(one)].pause();
      return;
    }
    if (panel.at >= panel.last) this.go(panel, 0);
    clock.play();
  }

  private pause(): void {
    this.clocks.forEach((clock) => clock.pause());
  }

  /** Goes on by so many seconds; false at the end. Films that go together by the part of the run are as fast as the longer one. */
  private advance(panel: FilmPanel, seconds: number): boolean {
    const longest = Math.max(...this.with(panel).map((one) => one.last));
    const pace = this.linked && this.join === "part" && longest > 0 ? panel.last / longest : 1;
    this.go(panel, panel.at + seconds * this.speed * pace);
    return panel.at < panel.last;
  }

  private show_playing(): void {
    for (const [i, panel] of this.panels.entries()) {
      panel.page.show_playing(this.linked ? this.clocks.some((clock) => clock.playing) : this.clocks[i].playing);
    }
  }

  private link(on: boolean): void {
    this.linked = on;
    this.pause();
    const [left, right] = this.panels;
    if (on) {
      right.show_field(left.field_name);
      right.look(left.camera);
    }
    this.together.select.disabled = !on;
    this.describe();
    this.show_playing();
  }

  private join_by(join: Join): void {
    this.join = join;
    this.go(this.panels[0], this.panels[0].at);
  }

  /** The left panel goes to where it is as deep as the right one, which stays where that is as deep by what joins them; else embedment joins them from now on. */
  private same_embedment(): void {
    const [left, right] = this.panels;
    if (right === undefined) return;
    this.pause();
    const embedment = embedment_at(right.run, right.at), frame = frame_of_drag(left.run, embedment);
    if (frame === null) return this.tell();
    if (this.linked && joins_of(left.run, right.run).includes("embedment")) this.join = "embedment";
    this.go(left, frame);
    this.describe();
  }

  private async save_gif(): Promise<void> {
    this.pause();
    const [left] = this.panels, face = this.save.textContent;
    const shown = this.with(left);
    const moment = (frame: number) => shown.map((panel) => panel.picture_at(panel === left ? frame : partner(this.join, left.run, frame, panel.run), 1));
    this.save.disabled = true;
    const names = shown.map((panel) => panel.run.name).join(" ");
    try {
      await save_film(left.last + 1, this.speed, moment, names, (done) => (this.save.textContent = `frame ${done} of ${left.last + 1}`));
    } finally {  // also where a picture cannot be made: the film can be saved again
      this.save.textContent = face;
      this.save.disabled = false;
      for (const panel of this.panels) panel.request_draw();
    }
  }

  private set_range(panel: FilmPanel, range: Range | null): void {
    for (const one of this.with(panel)) {
      const own = this.ranges.get(one) ?? new Map<string, Range>();
      if (range === null) own.delete(one.field_name);
      else own.set(one.field_name, range);
      this.ranges.set(one, own);
    }
    this.describe();
  }

  /** Brings all controls to what the panels show. */
  private describe(): void {
    const shown_runs = this.panels.map((panel) => panel.run);
    for (const panel of this.panels) {
      panel.set_region(common_region(panel.run, shown_runs));
      const shown = this.with(panel);
      panel.page.set_runs(this.runs, this.runs.indexOf(panel.run));
      panel.page.set_fields(this.fields_of(shown), panel.field_name);
      const fields = shown.flatMap((one) => one.film.fields.filter((field) => field.name === panel.field_name));
      const usual = fields.length > 0 ? common_range(fields) : { from: 0, to: 1 };
      panel.set_range(this.ranges.get(panel)?.get(panel.field_name) ?? usual, usual);
    }
    if (this.right === undefined) return;
    const joins = joins_of(this.panels[0].run, this.right.run);
    if (!joins.includes(this.join)) this.join = joins[0];
    set_options(this.together.select, joins.map((join) => [join, JOINS[join]]), this.join);
    this.same.disabled = frame_of_drag(this.panels[0].run, embedment_at(this.right.run, this.right.at)) === null;
  }

  /** All fields that one of the panels' films holds. */
  private fields_of(panels: FilmPanel[]): FieldData[] {
    const all = new Map<string, FieldData>();
    for (const panel of panels) for (const field of panel.film.fields) if (!all.has(field.name)) all.set(field.name, field);
    return [...all.values()];
  }
}
