// SPDX-License-Identifier: BSD-3-Clause
// The section with the moving line: its charts, what plays them, and the cards of its slices. It goes together with the film of the soil.
import type { PageData } from "./data";
import { Clock } from "./film_clock";
import type { FilmMoment } from "./film_curves";
import { button, choice, make, set_options } from "./film_elements";
import { type KeyPlayer, listen_to_keys, player_keys } from "./film_gestures";
import { digits, display_unit } from "./film_numbers";
import { where } from "./film_together";
import { type Player, speed_choice, Transport } from "./film_transport";
import { has_cards, SliceCards } from "./line_cards";
import { heaped_words } from "./line_bed";
import type { LineChart } from "./line_chart";
import { charts_below_plan } from "./line_charts";
import { PlanChart } from "./line_plan";
import { line_readings, line_sentence } from "./line_reading";
import { is_line_run, type LineRun, type LineShapes, read_line, time_at } from "./line_shapes";
import { stage_ends, type StageEnd, words_of_end } from "./line_stages";

/** px: paper, on which drawings shrink or grow to its width. */
const PAPER_WIDTH = 700;
const HELP = "Keys, after a click on the picture: space plays, ← → go frame by frame, Home and End to the first and last. Numbers on the line are slices: point at one to see its card, click to go there.";

/** Fills the section of the line, if the page has one; `moved` hears of the time that the reader goes to. */
export function show_line(section: HTMLElement | null, data: PageData, moved: (moment: FilmMoment) => void): LineFilm | null {
  if (section === null) return null;
  const runs = data.runs.filter(is_line_run);
  if (runs.length > 0) return new LineFilm(section, runs, moved);
  section.append(make("p", "quiet", "There is no line to show yet."));
  return null;
}

export class LineFilm implements Player, KeyPlayer {
  private at = 0;
  private run!: LineRun;
  private ends: StageEnd[] = [];
  private charts: LineChart[] = [];
  private cards: SliceCards | null = null;
  private speed = 5;
  private pending = 0;
  private drawn = 0;
  private loading = 0;
  private paper = false;
  /** The film of the soil goes where this one goes, and not the other way round. */
  private leads = false;
  private stage = make("div", "line_stage");
  private stages = make("div", "line_stages");
  private readings = make("dl", "film-readings");
  private values: HTMLElement[] = [];
  private note = make("p", "quiet line_note");
  private place_of_cards = make("div", "line_place_of_cards");
  private transport = new Transport(this);
  private clock = new Clock((seconds) => this.advance(seconds), (playing) => this.transport.show_playing(playing));

  constructor(private readonly section: HTMLElement, runs: LineRun[], private readonly moved: (moment: FilmMoment) => void) {
    const bar = make("div", "film-bar-of-all", speed_choice("line-speed", this.speed, (speed) => (this.speed = speed)));
    if (runs.length > 1) {
      const run = choice("line-run", "Run", (index) => void this.show_run(runs[Number(index)]));
      set_options(run.select, runs.map((each, i) => [String(i), each.name]), "0");
      bar.prepend(run.label);
    }
    this.stage.tabIndex = 0;
    this.stage.setAttribute("role", "group");
    const keys = player_keys(this);
    listen_to_keys(this.stage, (event) => (event.shiftKey ? undefined : keys[event.key]));
    section.classList.add("film");
    section.append(bar, this.readings, this.stage, this.transport.element, this.stages, this.note, make("p", "film-help quiet", HELP), this.place_of_cards);
    this.transport.show_playing(false);
    this.wake();
    void this.show_run(runs[0]);
  }

  play(): void {
    if (this.clock.playing) return this.clock.pause();
    if (this.at >= this.last_frame) this.go(0);
    this.clock.play();
  }

  step(frames: number): void {
    this.move(frames > 0 ? Math.floor(this.at + 1e-9) + frames : Math.ceil(this.at - 1e-9) + frames);
  }

  move(at: number): void {
    this.clock.pause();
    this.go(at);
  }

  first(): void {
    this.move(0);
  }

  last(): void {
    this.move(this.last_frame);
  }

  /** Goes where the film of the soil of this run is. */
  follow(moments: FilmMoment[]): void {
    const moment = moments.find(({ run }) => run.name === this.run.name);
    if (moment === undefined || this.leads) return;
    this.clock.pause();
    this.at = where(this.run.line.frames.map((frame) => frame.time), moment.time);
    this.request_draw();
  }

  private get last_frame(): number {
    return this.run.line.frames.length - 1;
  }

  private go(at: number): void {
    this.at = Math.min(this.last_frame, Math.max(0, at));
    this.request_draw();
    this.lead();
  }

  private lead(): void {
    this.leads = true;
    this.moved({ run: this.run, time: time_at(this.run.line, this.at) });
    this.leads = false;
  }

  private advance(seconds: number): boolean {
    this.go(this.at + seconds * this.speed);
    return this.at < this.last_frame;
  }

  private async show_run(run: LineRun): Promise<void> {
    this.clock.pause();
    const mine = ++this.loading;
    this.run = run;
    this.charts = [];
    this.at = this.last_frame;
    this.transport.set_frames(this.last_frame, run.name);
    this.note.textContent = "";
    try {
      const shapes = await read_line(run.line);
      if (mine === this.loading) this.take(shapes);
    } catch (error) {
      this.stage.replaceChildren(make("p", "line_message", (error as Error).message));
      this.section.dataset.state = "damaged";
    }
  }

  private take(shapes: LineShapes): void {
    const { run } = this;
    this.note.textContent = caption(run, shapes);
    const picked = (slice: number | null) => {
      plan.highlight(slice);
      this.cards?.highlight(slice);
    };
    this.ends = stage_ends(run);
    this.cards = has_cards(run) ? new SliceCards(run, this.ends, picked) : null;
    const plan = new PlanChart(run, shapes, this.ends, this.cards === null ? null : picked);
    this.charts = [plan, ...charts_below_plan(run, shapes, this.ends)];
    this.stage.replaceChildren(...this.charts.map((chart) => chart.element));
    this.place_of_cards.replaceChildren(...(this.cards === null ? [] : [
      make("h3", "", "Slices"),
      make("p", "quiet", `Resistance H and vertical reaction V, divided by the submerged weight W of the line as it was laid (${weight_words(run)}), and embedment w, against the displacement u of the pipe since it was laid; in the stages that load the line. All slices have the same axes. A ring and bold numbers mark the largest of all slices.`),
      this.cards.element]));
    this.stages.replaceChildren(...this.ends.map((end) =>
      button("line_to_end", words_of_end(run, end), `Go to the end of ${end.name}`, () => this.move(end.frame))));
    const rows = line_readings(run, 0).map(([name]) => ({ name: make("dt", "", name), value: make("dd", "") }));
    this.values = rows.map((row) => row.value);
    this.readings.replaceChildren(...rows.map((row) => make("div", "", row.name, row.value)));
    this.section.dataset.state = "ready";
    this.lay_out();
    this.lead();
  }

  private wake(): void {
    let width = 0;
    new ResizeObserver(() => {
      if (this.stage.clientWidth === width || this.paper) return;
      width = this.stage.clientWidth;
      this.lay_out();
    }).observe(this.stage);
    const look_again = (seen: boolean) => this.clock.hold(!seen || document.hidden);
    let on_screen = true;
    new IntersectionObserver((entries) => look_again((on_screen = entries[entries.length - 1].isIntersecting))).observe(this.section);
    document.addEventListener("visibilitychange", () => look_again(on_screen));
    // Paper does not move: it has the ends of all stages.
    addEventListener("beforeprint", () => this.print(true));
    addEventListener("afterprint", () => this.print(false));
  }

  private print(paper: boolean): void {
    this.paper = paper;
    this.lay_out();
  }

  private lay_out(): void {
    const width = this.paper ? PAPER_WIDTH : Math.floor(this.stage.clientWidth);
    if (this.charts.length === 0 || width === 0) return;
    for (const chart of this.charts) chart.lay_out(width);
    this.cards?.lay_out(this.paper);
    this.draw();
  }

  private request_draw(): void {
    if (this.pending !== 0) return;
    this.pending = requestAnimationFrame(() => {
      this.pending = 0;
      this.draw();
    });
  }

  private draw(): void {
    const { run, at } = this, now = line_readings(run, at);
    this.transport.show(at, this.last_frame, line_sentence(run, at));
    if (this.charts.length === 0) return;
    for (const chart of this.charts) chart.show(this.paper ? null : at);
    this.cards?.go_to(time_at(run.line, at));
    now.forEach(([, value], i) => {
      if (this.values[i].textContent !== value) this.values[i].textContent = value;
    });
    const stage = run.line.frames[Math.ceil(at)].stage;
    [...this.stages.children].forEach((each, i) => each.classList.toggle("line_under_way", this.ends[i].name === stage));
    this.stage.setAttribute("aria-label", line_sentence(run, at));
    Object.assign(this.section.dataset, { frame: String(Number(at.toFixed(4))), framesDrawn: String(++this.drawn) });
  }
}

function weight_words(run: LineRun): string {
  const unit = display_unit("N/m", run.line.weight);
  return `${digits(run.line.weight / unit.factor)} ${unit.name}`;
}

const words_of_half = {
  symmetric: "Left of x = 0 is the mirror image. ", antisymmetric: "Left of x = 0 is the other half, rotated by 180 degrees. ", none: "",
};

function caption(run: LineRun, shapes: LineShapes): string {
  const { half, slices, note, diameter } = run.line, last = slices[slices.length - 1], heaped = heaped_words(shapes.rise);
  const soil = heaped ?? `Brown: the strip that the pipe has swept so far${diameter > 0 ? `, its diameter of ${digits(diameter)} m in it` : ""}; soil lies heaped up in berms along its edges. `;
  return `${words_of_half[half]}${soil}Dotted vertical line: the last slice at ${digits(last)} m; beyond it the soil is modelled by springs. Thin: the line at the ends of stages, hot in red, cold in blue.` +
    (note === null ? "" : ` Shown: ${note}.`);
}
