// SPDX-License-Identifier: BSD-3-Clause
// All runs of the folder, and the studies and other commands that start some; several runs are compared from here.
import { element } from "../element";
import { make } from "../film_elements";
import { api, type Job, type RunState, type Status } from "./api";
import type { Place } from "./place";
import { edit_run } from "./run_edit";
import { bytes_words, duration_words, say, value_words } from "./words";

export function status_badge(status: Status): HTMLElement {
  return make("span", `badge ${status}`, status);
}

export function progress_bar(progress: number | null): HTMLElement {
  const bar = element("progress", { max: 1, "aria-label": "part done" });
  if (progress !== null) bar.value = progress;
  return bar;
}

/** Asks again and again while the page is in sight. */
export class Pulse {
  private waiting = 0;
  private ended = false;

  constructor(private readonly every: number, private readonly beat: () => Promise<void>) {
    document.addEventListener("visibilitychange", this.seen);
    void this.again();
  }

  end(): void {
    this.ended = true;
    clearTimeout(this.waiting);
    document.removeEventListener("visibilitychange", this.seen);
  }

  private seen = () => {
    clearTimeout(this.waiting);
    if (!document.hidden) void this.again();
  };

  private async again(): Promise<void> {
    await this.beat();
    clearTimeout(this.waiting);
    if (!this.ended && !document.hidden) this.waiting = window.setTimeout(() => void this.again(), this.every);
  }
}

/** Whether a study, an envelope or another command made it, and its own page shows it. */
export const is_part = (path: string) => /\/runs\//.test(path) || path.startsWith("out/element/");

export class RunsView implements Place {
  readonly element = make("div", "runs_view");
  readonly title = "Runs";
  private chosen = new Set<string>();
  private table = make("tbody", "");
  private jobs = make("tbody", "");
  private note = make("p", "quiet");
  private compare = element("button", { type: "button", class: "primary" }, "Compare");
  private export_all = element("button", { type: "button" }, "Export springs …");
  private parts = element("input", { type: "checkbox", id: "parts" });
  private pulse: Pulse;

  constructor() {
    this.parts.addEventListener("change", () => void this.look());
    this.compare.addEventListener("click", () => (location.hash = `#/compare?${[...this.chosen].map((path) => `path=${encodeURIComponent(path)}`).join("&")}`));
    this.export_all.addEventListener("click", () => (location.hash = `#/export?${[...this.chosen].map((path) => `path=${encodeURIComponent(path)}`).join("&")}`));
    this.element.append(
      make("h2", "", "Runs"), make("div", "bar", this.compare, this.export_all, this.note, make("label", "", this.parts, " also runs of studies, envelopes and factors of safety")),
      make("table", "list", make("thead", "", make("tr", "", ...["", "run", "ended", "key number", "size", "status", "", ""].map((word) => make("th", "", word)))), this.table),
      make("h2", "", "Studies, envelopes, factors of safety, element tests, fits"),
      make("table", "list", make("thead", "", make("tr", "", ...["", "results", "status", "last message", ""].map((word) => make("th", "", word)))), this.jobs));
    this.show_choice();
    this.pulse = new Pulse(1500, () => this.look());
  }

  leave(): void {
    this.pulse.end();
  }

  private show_choice(): void {
    this.compare.disabled = this.chosen.size < 2;
    this.export_all.disabled = this.chosen.size < 1;
    this.note.textContent = this.chosen.size < 2 ? "Tick two runs or more to compare them on one page." : `${this.chosen.size} runs chosen`;
  }

  private async look(): Promise<void> {
    try {
      const [runs, jobs] = await Promise.all([api.runs(), api.jobs()]);
      const order: Status[] = ["running", "queued", "stopped", "failed", "finished"];
      const sorted = runs.filter(({ path }) => this.parts.checked || !is_part(path)).sort((a, b) => order.indexOf(a.status) - order.indexOf(b.status) || a.path.localeCompare(b.path));
      patch(this.table, sorted.map((run) => [run.path, JSON.stringify(run), () => this.row(run)]));
      patch(this.jobs, jobs.map((job) => [job.job, JSON.stringify([job.status, job.log_tail, job.made]), () => this.job_row(job)]));
      if (runs.length === 0) this.note.textContent = "There are no runs yet. Those that you start in a terminal appear here, too.";
    } catch (error) {
      this.note.textContent = (error as Error).message;
    }
  }

  private row(run: RunState): HTMLTableRowElement {
    const box = element("input", { type: "checkbox", "aria-label": `choose ${run.path}` });
    box.checked = this.chosen.has(run.path);
    box.addEventListener("change", () => {
      if (box.checked) this.chosen.add(run.path);
      else this.chosen.delete(run.path);
      this.show_choice();
    });
    return make("tr", "", make("td", "", box), make("td", "", element("a", { href: `#/run?path=${encodeURIComponent(run.path)}` }, run.path), make("p", "notes quiet", run.title ?? run.case), ...(run.notes ? [make("p", "notes", run.notes)] : [])),
      make("td", "quiet unit", date_words(run.date)), make("td", "number", run.answer ? `${run.answer.name} ${value_words(run.answer.value, run.answer.unit)}` : ""),
      make("td", "number quiet", run.bytes === undefined ? "" : bytes_words(run.bytes)), make("td", "", status_badge(run.status)), make("td", "", ...(run.status === "running" ? [progress_bar(run.progress), ` ${duration_words(run.time_left_s)}`] : [])),
      make("td", "acts", ...stop_or_resume(run), this.editor(run), ...(is_at_work(run) ? [] : [this.remover(run.path)])));
  }

  private editor(run: RunState): HTMLElement {
    const face = act("Edit …", async () => {
      const path = await edit_run(run.path, run.notes ?? "", can_be_named(run));
      if (path !== null && path !== run.path && this.chosen.delete(run.path)) this.chosen.add(path);
      await this.look();
    });
    face.setAttribute("aria-label", `name and notes of ${run.path}`);
    return face;
  }

  private remover(path: string): HTMLElement {
    const face = act("Delete", async () => {
      if (!confirm(`Delete ${path} and all that is in it? This cannot be undone.`)) return;
      await api.remove(path);
      this.chosen.delete(path);
      this.show_choice();
      await this.look();
    });
    face.setAttribute("aria-label", `delete ${path}`);
    return face;
  }

  private job_row(job: Job): HTMLTableRowElement {
    const says = job.log_tail.trim().split("\n").pop() ?? "";
    return make("tr", "", make("td", "", job.command), make("td", "", element("a", { href: `#/job?job=${encodeURIComponent(job.job)}` }, job.job)), make("td", "", status_badge(job.status)), make("td", "quiet", says),
      make("td", "", ...(job.status === "running" || job.status === "queued" ? [act("Stop", () => api.stop_job(job.job))] : [])));
  }
}

export const is_at_work = ({ status }: RunState) => status === "running" || status === "queued";
/** Those of studies are found by their names. */
export const can_be_named = (run: RunState) => !is_at_work(run) && !is_part(run.path);

/** "2026-12-01 08:06" of a date of the summary, in the reader's time. */
function date_words(date: string | undefined): string {
  if (!date) return "";
  const time = new Date(date), two = (number: number) => String(number).padStart(2, "0");
  return `${time.getFullYear()}-${two(time.getMonth() + 1)}-${two(time.getDate())} ${two(time.getHours())}:${two(time.getMinutes())}`;
}

function act(words: string, does: () => Promise<unknown>): HTMLButtonElement {
  const face = make("button", "", words);
  face.type = "button";
  face.addEventListener("click", () => {
    face.disabled = true;
    does().catch((error: Error) => say(error.message, "bad")).finally(() => (face.disabled = false));
  });
  return face;
}

export function stop_or_resume(run: RunState): HTMLElement[] {
  if (run.status === "running" || run.status === "queued") return [act("Stop", () => api.stop(run.path))];
  if (run.can_resume) return [act("Resume", () => api.start({ resume: run.path }))];
  return [];
}

/** Rows whose content is the same stay, with the focus in them. */
function patch(body: HTMLElement, rows: [key: string, content: string, make_row: () => HTMLTableRowElement][]): void {
  const old = new Map([...body.children].map((row) => [(row as HTMLElement).dataset.row!, row as HTMLElement]));
  const next = rows.map(([key, content, make_row]) => {
    const was = old.get(key);
    if (was && was.dataset.content === content) return was;
    const row = make_row();
    Object.assign(row.dataset, { row: key, content });
    return row;
  });
  if (next.length !== body.children.length || next.some((row, i) => body.children[i] !== row)) body.replaceChildren(...next);
}
