// SPDX-License-Identifier: BSD-3-Clause
// Pages that berm made, in a frame: a report of one run or of several, a study, an envelope, tests of a soil.
import { element } from "../element";
import { make } from "../film_elements";
import { api, type Job } from "./api";
import type { Place } from "./place";
import { picture_of, results_of } from "./results";
import { Pulse, status_badge } from "./runs_view";
import { download, say } from "./words";

/** A page of berm in a frame, with a way to keep it. */
async function framed(path: string, ...more: HTMLElement[]): Promise<HTMLElement[]> {
  const { address, without_scripts } = await api.show(path);
  const keep = element("button", { type: "button" }, "Save the page"), alone = element("a", { href: address, target: "_blank", rel: "noopener" }, "Open in a new tab");
  keep.addEventListener("click", () => void api.file(path).then((file) => download(file, path.split("/").pop()!)));
  const note = make("p", "quiet", "The scripts of this page do not run here: another version of berm, or another program, wrote it. Write its report again to see all of it.");
  return [make("div", "bar", alone, keep, make("span", "quiet", path), ...more), ...(without_scripts ? [note] : []), element("iframe", { src: address, sandbox: "allow-scripts allow-downloads allow-popups", class: "page_frame", title: path })];
}

export class PageView implements Place {
  readonly element = make("div", "page_view");
  readonly title: string;

  constructor(path: string) {
    this.title = path;
    framed(path).then((parts) => this.element.replaceChildren(...parts)).catch((error: Error) => this.element.replaceChildren(make("p", "bad", error.message)));
  }
}

export class CompareView implements Place {
  readonly element = make("div", "page_view");
  readonly title = "Compare";

  constructor(private readonly runs: string[]) {
    this.element.append(make("p", "quiet", `The page of ${runs.length} runs is being made …`));
    const pdf = element("button", { type: "button" }, "PDF");
    pdf.addEventListener("click", () => void this.print());
    api.report(runs, false)
      .then(({ path }) => framed(path, pdf))
      .then((parts) => this.element.replaceChildren(...parts))
      .catch((error: Error) => this.element.replaceChildren(make("p", "bad", error.message)));
  }

  private async print(): Promise<void> {
    try {
      say("The page is being printed …");
      const { pdf } = await api.report(this.runs, true);
      if (pdf) download(await api.file(pdf), "compared.pdf");
    } catch (error) {
      say((error as Error).message, "bad");
    }
  }
}

/** More files are folded away. */
const few = 8;

export class JobView implements Place {
  readonly element = make("div", "page_view");
  readonly title: string;
  private head = make("div", "bar");
  private last = make("p", "quiet");
  private log = make("pre", "log");
  private page = make("div", "job_page");
  private shown = "";
  private pulse: Pulse;

  constructor(private readonly job: string) {
    this.title = job;
    this.element.append(make("h2", "", job), this.head, this.last, this.page, make("details", "", make("summary", "", "Output"), this.log));
    this.pulse = new Pulse(1500, () => this.look());
  }

  leave(): void {
    this.pulse.end();
  }

  private async look(): Promise<void> {
    try {
      const found = (await api.jobs()).find(({ job }) => job === this.job);
      if (!found) return this.head.replaceChildren(make("p", "quiet", "It was not started from this session of the desk. Its files are in the folder of that name."));
      this.show(found);
      if (found.status !== "running" && found.status !== "queued") await this.show_page(found);
    } catch (error) {
      this.head.replaceChildren(make("p", "bad", (error as Error).message));
    }
  }

  private show({ command, status, log_tail, made }: Job): void {
    this.log.textContent = log_tail;
    this.last.textContent = status === "running" ? (log_tail.trim().split("\n").pop() ?? "") : "";
    const content = JSON.stringify([status, made]);
    if (this.head.dataset.content === content) return; // buttons stay, with the focus in them
    this.head.dataset.content = content;
    const stop = element("button", { type: "button" }, "Stop");
    stop.addEventListener("click", () => void api.stop_job(this.job).catch((error: Error) => say(error.message, "bad")));
    const of_run = command === "uncertainty";
    const files = (of_run ? [] : [...made].sort((a, b) => a.localeCompare(b, "en", { numeric: true }))).map((path) => {
      const face = element("button", { type: "button", class: "file" }, path.split("/").pop()!);
      face.addEventListener("click", () => void api.file(path).then((file) => download(file, path.split("/").pop()!)));
      return face;
    });
    this.head.replaceChildren(make("strong", "", command), status_badge(status), ...(status === "running" || status === "queued" ? [stop] : []), ...(files.length > few ? [make("details", "", make("summary", "", `${files.length} files`), make("div", "bar", ...files))] : files),
      ...(of_run ? [element("a", { href: `#/run?path=${encodeURIComponent(this.job)}` }, "To the run, with the uncertainty of its key results")] : []));
    if (status === "failed") this.page.replaceChildren(make("p", "bad", log_tail.trim().split("\n").filter((line) => line.startsWith("berm:")).pop() ?? "It failed: see the output below."));
  }

  private async show_page({ command, made }: Job): Promise<void> {
    const content = JSON.stringify(made);
    if (command === "uncertainty" || this.shown === content) return;
    this.shown = content;
    const page = made.find((path) => path.endsWith(".html")), results = page ? await framed(page) : await results_of(made);
    this.page.append(...results);
  }
}

/** Programs that springs are written for, as berm export calls them. */
const programs: [word: string, name: string][] = [
  ["table", "tables (CSV)"], ["abaqus", "Abaqus"], ["orcaflex", "OrcaFlex"], ["ansys", "ANSYS"], ["sima", "SIMA (RIFLEX)"], ["calculix", "CalculiX"], ["opensees", "OpenSees"],
  ["moordyn", "MoorDyn"], ["buckpy", "BuckPy"], ["json", "JSON"], ["line", "shapes of a pipeline"], ["py", "p-y curves"],
];

export class ExportView implements Place {
  readonly element = make("div", "export_view");
  readonly title = "Export";
  private files = make("ul", "files");
  private warnings = make("div", "");
  private pictures = make("div", "pictures");
  private travels = make("fieldset", "travels", make("legend", "", "Sweeps (none ticked: all in that state)"));

  constructor(private readonly runs: string[]) {
    const to = element("select", { id: "export-to" }, ...programs.map(([word, name]) => element("option", { value: word }, name)));
    const state = element("select", { id: "export-state" }, element("option", { value: "" }, "operation, else touchdown"), ...["touchdown", "laid", "flooded", "emptied", "operation"].map((word) => element("option", {}, word)));
    const form = element("form", { class: "stacked" });
    form.append(
      make("h2", "", "Springs for a pipeline program"), make("p", "quiet", `Of ${runs.join(", ")}. Each number is given with its run, state and formula.`),
      element("label", { for: "export-to" }, "Program"), to, element("label", { for: "export-state" }, "State of the pipe"), state,
      this.travels, element("button", { type: "submit", class: "primary" }, "Export"));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.write({ to: to.value, state: state.value, travels: [...this.travels.querySelectorAll<HTMLInputElement>("input:checked")].map(({ value }) => value).join(",") });
    });
    this.element.append(form, this.warnings, this.files, this.pictures);
    void this.offer_travels();
  }

  /** The stages of the runs that have a horizontal resistance. */
  private async offer_travels(): Promise<void> {
    const runs = await Promise.all(this.runs.map((run) => api.run(run, 0).catch(() => null)));
    const names = new Set(runs.flatMap((run) => Object.entries(run?.summary?.quantities ?? {})).filter(([name, { of }]) => /(^|\.)H_(max|end)$/.test(name) && of).map(([, { of }]) => of));
    this.travels.hidden = names.size === 0;
    this.travels.append(...[...names].map((name) => make("label", "", element("input", { type: "checkbox", value: name }), ` ${name} `)));
  }

  private async write({ to, state, travels }: Record<string, string>): Promise<void> {
    try {
      const { files, warnings } = await api.springs({ runs: this.runs, to, ...(state ? { state } : {}), ...(travels ? { travels } : {}) });
      this.warnings.replaceChildren(...warnings.map((warning) => make("p", "fair", warning)));
      const shown = files.filter((path) => !/\.(gp|dat)$/.test(path)); // the two are what gnuplot drew a picture from
      this.pictures.replaceChildren(...(await Promise.all(shown.filter((path) => path.endsWith(".png")).map((path) => picture_of(path, path.split("/").pop()!)))));
      this.files.replaceChildren(...shown.map((path) => {
        const face = element("button", { type: "button", class: "file" }, path);
        face.addEventListener("click", () => void api.file(path).then((file) => download(file, path.split("/").pop()!)).catch((error: Error) => say(error.message, "bad")));
        return make("li", "", face);
      }));
      say(`${files.length} files are written.`);
    } catch (error) {
      this.files.replaceChildren(make("li", "bad", (error as Error).message));
    }
  }
}
