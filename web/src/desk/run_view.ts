// SPDX-License-Identifier: BSD-3-Clause
// A run: how far it is, its curves as they grow, the soil as it moves, and what can be done with it.
import { element } from "../element";
import { digits } from "../film_numbers";
import { make } from "../film_elements";
import { api, type Column, type Quantity, type RunNow, type Summary } from "./api";
import { LiveChart } from "./live_chart";
import type { Place } from "./place";
import { own_charts } from "./own_charts";
import { edit_run } from "./run_edit";
import { can_be_named, progress_bar, Pulse, status_badge, stop_or_resume } from "./runs_view";
import { SoilPicture } from "./soil_picture";
import { download, duration_words, say, value_words } from "./words";

type Value = number | string | null;

/** In m: less is round-off, or a spring that settles. */
const least_travel = 1e-6;

/** From the least to the largest value. */
function travel(values: (number | null)[]): number {
  const known = values.filter((value): value is number => value !== null);
  return known.reduce((most, value) => Math.max(most, value), -Infinity) - known.reduce((least, value) => Math.min(least, value), Infinity);
}

/** How often values turn by more than a tenth of all their travel. */
function turns(values: (number | null)[]): number {
  const step = travel(values) / 10;
  let count = 0, way = 0, extreme = values[0] ?? 0;
  for (const value of values) {
    if (value === null) continue;
    if (way === 0) {
      if (Math.abs(value - extreme) > step) way = Math.sign(value - extreme), extreme = value;
    } else if ((value - extreme) * way > 0) extreme = value;
    else if ((extreme - value) * way > step) ++count, way = -way, extreme = value;
  }
  return count;
}

/** Whether the results of a run are not to be used. */
function is_invalid(summary?: Summary | null): boolean {
  const invalid = summary?.invalid;
  return Array.isArray(invalid) ? invalid.length > 0 : Boolean(invalid);
}

export class RunView implements Place {
  readonly element = make("div", "run_view");
  readonly title: string;
  private head = make("div", "bar run_head");
  private why = make("p", "bad why");
  private sentence = make("p", "sentence");
  private notes = make("p", "notes quiet");
  private warnings = make("div", "");
  private acts = make("div", "bar");
  private charts: LiveChart[] = [];
  private chart_place = make("div", "live_charts");
  private own_place = make("div", "live_charts");
  private own: LiveChart[] = [];
  private soil = new SoilPicture();
  private answer = make("div", "answer");
  private log = make("pre", "log");
  private rows: Value[][] = [];
  private of = "";
  private columns: Column[] = [];
  private consolidating: Set<string> | null = null;
  private status = "";
  private pulse: Pulse;

  constructor(private readonly path: string) {
    this.title = path;
    this.element.append(
      make("h2", "", path), this.head, this.why, this.sentence, this.warnings, this.notes, this.acts,
      make("div", "run_panes", make("section", "pane", make("h2", "", "Curves"), this.own_place, this.chart_place), make("section", "pane", make("h2", "", "Soil"), this.soil.element, make("h2", "", "Key results"), this.answer)),
      make("details", "", make("summary", "", "Log"), this.log));
    this.pulse = new Pulse(1000, () => this.look());
  }

  leave(): void {
    this.pulse.end();
    [...this.charts, ...this.own].forEach((chart) => chart.end());
  }

  private async look(): Promise<void> {
    try {
      let now: RunNow;
      do {
        now = await api.run(this.path, this.rows.length);
        if (now.of !== this.of) {
          // It began anew or was resumed: what was read before may not hold.
          const again = this.of !== "" && this.rows.length > 0;
          this.of = now.of;
          if (again) {
            this.rows = [];
            now = await api.run(this.path, 0);
          }
        }
        this.rows.push(...now.rows);
        this.columns = now.columns;
      } while (now.more);
      this.show(now);
      if (now.columns.length > 0 && (now.status === "running" || this.soil.frame < 0)) {
        const soil = await api.soil(this.path, this.soil.frame);
        if (soil) this.soil.show(soil);
      }
      if (now.status === "finished" && this.status === "running") say("The run has ended.");
      this.status = now.status;
    } catch (error) {
      this.head.replaceChildren(make("p", "bad", (error as Error).message));
    }
  }

  private show(now: RunNow): void {
    const left = now.status === "running" && now.time_left_s !== null ? `${duration_words(now.time_left_s)} left` : "";
    const words = now.progress === null ? "" : `${Math.round(100 * now.progress)} %`;
    this.head.replaceChildren(status_badge(now.status), ...(now.status === "running" ? [progress_bar(now.progress)] : []), make("span", "", words), make("span", "quiet", left),
      make("span", "quiet", now.case ? `of ${now.case}` : ""));
    this.why.textContent = now.why ? `${now.why.replace(/[.]?$/, ".")} ${what_can_be_done(now)}` : "";
    this.why.hidden = !now.why;
    this.sentence.textContent = is_invalid(now.summary) ? "" : now.summary?.text?.answer ?? "";
    this.sentence.hidden = !this.sentence.textContent;
    this.notes.textContent = now.notes ?? "";
    this.notes.hidden = !now.notes;
    const offered = `${now.status} ${now.can_resume} ${now.notes ?? ""}`;
    if (this.acts.dataset.of !== offered) {
      const focused = this.acts.contains(document.activeElement);
      this.acts.dataset.of = offered;
      this.acts.replaceChildren(...stop_or_resume(now), ...this.buttons(now));
      if (focused) this.acts.querySelector("button")?.focus();
    }
    this.log.textContent = now.log_tail;
    if (now.summary) this.consolidating = new Set(Object.keys(now.summary.quantities ?? {}).filter((name) => name.startsWith("U_of_")).map((name) => name.slice("U_of_".length)));
    this.show_curves();
    const content = now.summary ? JSON.stringify(now.summary) : "";
    if (now.summary && this.answer.dataset.content !== content) void this.show_own();
    if (now.summary && this.answer.dataset.content !== content) this.show_answer(now.summary, now.status === "finished" ? "" : this.stage_now(), now.answer?.name); // else what is open stays open
    this.answer.dataset.content = content;
    if (now.summary) return;
    this.answer.replaceChildren(...this.live_numbers());
  }

  private buttons(now: RunNow): HTMLElement[] {
    const button = (words: string, title: string, does: () => void) => {
      const face = element("button", { type: "button", title }, words);
      face.addEventListener("click", does);
      return face;
    };
    const report = (pdf: boolean) => () => void this.report(pdf);
    return [
      button("Report", "The page of this run (berm report)", report(false)), button("PDF", "The page, printed", report(true)),
      ...(now.status === "finished" ? [
        button("Export springs …", "Springs for pipeline programs (berm export)", () => (location.hash = `#/export?path=${encodeURIComponent(this.path)}`)),
        button("Low, best, high …", "Vary uncertain parameters (berm study)", () => (location.hash = `#/vary?path=${encodeURIComponent(this.path)}`)),
        button("Uncertainty", "Also runs on other cells and at another speed (berm run --uncertainty), and extrapolates to zero cell size; the check of the case says how long it takes", () => void this.uncertainty())] : []),
      button("Name, notes …", "Another name of the run's folder, and notes about it", () => void this.edit(now)),
      ...(now.case.endsWith(".toml") ? [button("Case of this run", "Open the case as this run has it", () => (location.hash = `#/case?path=${encodeURIComponent(`${this.path}/case.toml`)}`))] : []),
    ];
  }

  private async edit(now: RunNow): Promise<void> {
    const path = await edit_run(this.path, now.notes ?? "", can_be_named(now));
    if (path !== null && path !== this.path) location.hash = `#/run?path=${encodeURIComponent(path)}`;
    else await this.look();
  }

  private async show_own(): Promise<void> {
    const found = await own_charts(this.path);
    this.own.forEach((chart) => chart.end());
    this.own = found.map(({ chart }) => chart);
    this.own_place.replaceChildren(...found.map(({ face }) => face));
    found.forEach(({ fill }) => fill());
  }

  private async report(pdf: boolean): Promise<void> {
    try {
      say("The page is being made …");
      const made = await api.report([this.path], pdf);
      if (pdf && made.pdf) download(await api.file(made.pdf), made.pdf.split("/").pop()!);
      else location.hash = `#/page?path=${encodeURIComponent(made.path)}`;
    } catch (error) {
      say((error as Error).message, "bad");
    }
  }

  private async uncertainty(): Promise<void> {
    try {
      const { job } = await api.work("uncertainty", this.path);
      location.hash = `#/job?job=${encodeURIComponent(job)}`;
    } catch (error) {
      say((error as Error).message, "bad");
    }
  }

  private index(label: string): number {
    return this.columns.findIndex((column) => column.label === label);
  }

  /** U counts in stages in which the soil consolidates, as the results of a run that has ended name them. */
  private numbers(index: number): (number | null)[] {
    const stage = this.index("stage");
    if (this.columns[index]?.name === "U" && this.consolidating) return this.rows.map((row) => (this.consolidating!.has(String(row[stage])) ? (row[index] as number) : null));
    return this.rows.map((row) => (typeof row[index] === "number" ? (row[index] as number) : null));
  }

  /** What is drawn, y over x: V(w), H(u) and w(u) of a body that is driven, over time where it has not moved that way; V, H and u over time where it turns; of a line its displacement; of soil that consolidates U. */
  private curves(): [y: string, x: string][] {
    const line = this.columns.filter(({ name }) => name === "line_y_m").map(({ label }): [string, string] => [label, "time"]);
    if (this.index("u") < 0 || this.index("w") < 0) return [...line, ...this.columns.filter(({ name, unit }) => name !== "time_s" && unit !== null && name !== "line_y_m").slice(0, 3).map(({ label }): [string, string] => [label, "time"])];
    const over = (label: string) => (travel(this.numbers(this.index(label))) > least_travel ? label : "time"), [u, w] = [over("u"), over("w")];
    const in_time: [string, string][] = u === "u" && turns(this.numbers(this.index("u"))) >= 2 ? [["u", "time"], ["H", "time"]] : [];
    const water: [string, string][] = this.columns.some(({ name }) => name === "U") && travel(this.numbers(this.columns.findIndex(({ name }) => name === "U"))) > 0 ? [["U", "time"]] : [];
    return [...water, ...line, ["V", in_time.length > 0 ? "time" : w], ["H", u], ["w", u], ...in_time];
  }

  private show_curves(): void {
    if (this.rows.length === 0) {
      if (this.charts.length === 0) this.chart_place.replaceChildren(make("p", "quiet", "No results yet."));
      return;
    }
    const pairs = this.curves().filter(([y, x]) => this.index(y) >= 0 && this.index(x) >= 0), drawn = JSON.stringify(pairs);
    if (this.chart_place.dataset.drawn !== drawn) {
      this.chart_place.dataset.drawn = drawn;
      this.charts.forEach((chart) => chart.end());
      this.charts = pairs.map(([y, x]) => new LiveChart(this.columns[this.index(x)], this.columns[this.index(y)]));
      this.chart_place.replaceChildren(...this.charts.map((chart) => chart.element));
    }
    for (const chart of this.charts) chart.show(this.numbers(this.index(chart.x.label)), this.numbers(this.index(chart.y.label)));
  }

  /** The last row of what an engineer watches, and of what tells whether the run is to be trusted. */
  private live_numbers(): HTMLElement[] {
    const last = this.rows[this.rows.length - 1];
    if (!last) return [];
    const watched = ["stage", "time", "u", "w", "H", "V", "energy error", "vibration of the soil at the body", "overlap"];
    return [make("dl", "numbers", ...watched.flatMap((label) => {
      const index = this.index(label);
      if (index < 0 || last[index] === null) return [];
      const value = last[index]!, { unit, meaning } = this.columns[index];
      const term = make("dt", "", label);
      term.title = meaning;
      return [term, make("dd", "", typeof value === "number" ? `${digits(value)} ${unit === "1" || unit === null ? "" : unit}` : value)];
    }))];
  }

  /** The stage that the run is in, or did not come to the end of. */
  private stage_now(): string {
    const last = this.rows[this.rows.length - 1], stage = last?.[this.index("stage")];
    return typeof stage === "string" ? stage : "";
  }

  /** `cut`: the stage that did not end, of a run that did not; `key`: the key number of the kind of run. */
  private show_answer({ quantities, checks, warnings, invalid, uncertainty }: Summary, cut: string, key = ""): void {
    const row = (name: string, each: Quantity) => {
      const term = make("td", "", name), is_cut = cut !== "" && (each.of === cut || name.startsWith(`${cut}.`));
      term.title = each.meaning;
      const band = uncertainty?.quantities[name];
      return make("tr", is_cut ? "cut" : name === key ? "key" : "", term, make("td", "number", value_words(each.value, each.unit)), ...(uncertainty ? [make("td", "number band", band ? `${value_words(band.converged, each.unit)} ± ${value_words(band.half_width, each.unit)}` : "")] : []),
        make("td", "quiet", `${is_cut ? `(${cut} did not end: as far as it got) ` : ""}${each.meaning}`));
    };
    const numbers = Object.entries(quantities ?? {}).filter(([, each]) => typeof each.value === "number"), is_answer = ([, { kind }]: [string, Quantity]) => kind === "answer";
    const table_of = (some: [string, Quantity][]) => make("div", "scrolls", make("table", "list", ...(uncertainty ? [make("thead", "", make("tr", "", ...["", "this run", "converged", ""].map((word) => make("th", "", word))))] : []), make("tbody", "", ...some.slice(0, 60).map(([name, each]) => row(name, each)))));
    numbers.sort(([a], [b]) => Number(b === key) - Number(a === key));
    const others = numbers.filter((each) => !is_answer(each));
    const trust = Object.entries(checks ?? {}).filter(([, value]) => typeof value === "number" || typeof value === "boolean").slice(0, 12);
    this.answer.replaceChildren(
      ...(cut ? [make("p", "fair", `The run has not finished. Numbers of ${cut} are of an unfinished stage, and later stages are missing.`)] : []),
      table_of(numbers.filter(is_answer)),
      ...(others.length > 0 ? [make("details", "", make("summary", "", "Ratios, prescribed values and quality"), table_of(others))] : []),
      make("details", "", make("summary", "", "Checks"), make("dl", "numbers", ...trust.flatMap(([name, value]) => [make("dt", "", name.replaceAll("_", " ")), make("dd", "", typeof value === "number" ? digits(value) : String(value))]))));
    this.warnings.replaceChildren(
      ...(is_invalid({ invalid }) ? [make("p", "bad", `Do not use the results of this run${Array.isArray(invalid) ? `: ${invalid.join("; ")}` : ""}.`)] : []),
      ...(warnings ?? []).slice(0, 6).map((warning) => make("p", "fair", warning)));
  }
}

/** After a run that did not come to its end. */
function what_can_be_done({ status, can_resume, case: file }: RunNow): string {
  if (can_resume) return "Resume continues it from its last checkpoint.";
  return status === "failed" && file !== "" ? `It would fail again: change ${file} and run it again.` : "Run its case again.";
}
