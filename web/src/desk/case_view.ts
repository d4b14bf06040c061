// SPDX-License-Identifier: BSD-3-Clause
// A case: form and text side by side and always in step, the model as it changes, and what berm check finds. A study and element tests have form and text.
import { createEditor, type Editor, type Finding } from "../editor/editor";
import type { Schema } from "../editor/schema";
import { element } from "../element";
import { make } from "../film_elements";
import { api, type Checked, doubts_of_new, type InputKind, Refusal } from "./api";
import { CaseText, type Path } from "./case_text";
import { Form } from "./form";
import type { Place } from "./place";
import { bytes_words, duration_words, hurry, picture_of, say } from "./words";

/** A study has cases, an input of element tests has tests, one of a fit measured ones, one of contours a storm. */
export function kind_of(text: string): InputKind {
  return /^\[\[case\]\]/m.test(text) ? "study" : /^\[\[test\]\]/m.test(text) ? "element" : /^\[\[measured\]\]/m.test(text) ? "fit" : /^\[storm\]/m.test(text) ? "cyclic" : /^\[sea\]/m.test(text) ? "sea" : /^\[\[section\]\]/m.test(text) ? "route" : "case";
}

const run_words: Record<InputKind, string> = { case: "Run", study: "Run the study", element: "Run the tests", fit: "Fit the soil", cyclic: "Cyclic strength", sea: "Sea state", route: "Springs by KP" };

export class CaseView implements Place {
  readonly element = make("div", "case_view");
  readonly title: string;
  private form: Form;
  private editor!: Editor;
  private text: CaseText;
  private modified: string | number | null;
  private saved: string;
  private findings = make("ul", "findings");
  private estimate = make("p", "quiet estimate");
  private model = make("div", "model");
  private state = make("span", "quiet");
  private save_button = element("button", { type: "button", class: "primary" }, "Save");
  private run_button: HTMLButtonElement;
  private from_form = false;
  private last_check: Promise<Finding[]> = Promise.resolve([]);
  private draw_later = hurry(500, () => void this.draw());
  private gone = false;

  constructor(private readonly path: string, read: { text: string; modified: string | number }, private readonly kind: InputKind, schema: Schema, cores: number) {
    this.title = path;
    this.run_button = element("button", { type: "button", class: "primary" }, run_words[kind]);
    this.saved = read.text;
    this.modified = read.modified;
    this.text = new CaseText(read.text);
    this.form = new Form(schema, (at, literal) => this.change(literal === "" ? this.text.without(at) : this.text.with(at, literal)), (at, comment) => this.change(this.text.with_comment(at, comment)), (at) => this.look_at(at));
    const threads = element("input", { type: "number", min: 1, max: cores, value: cores, id: "threads", "aria-label": "threads" });
    this.run_button.addEventListener("click", () => void this.run(Number(threads.value)));
    this.save_button.addEventListener("click", () => void this.save());
    const is_case = kind === "case", text_box = make("div", "text_box");
    const job = (words: string, title: string, does: () => void) => {
      const face = element("button", { type: "button", title }, words);
      face.addEventListener("click", does);
      return face;
    };
    const jobs = is_case ? [
      job("Element tests", "Put the soils of this case into laboratory tests (berm element): triaxial, simple shear", () => void this.test_soil()),
      job("Envelope", "Find the loads that the soil can carry (berm envelope): many runs", () => confirm("An envelope takes eleven runs of this case or more. Begin?") && void this.work("envelope")),
      job("Factor of safety", "Find by how much the strength can be reduced until the soil fails (berm safety): some ten runs", () => void this.work("safety"))] : [];
    const checked = make("section", "pane side_pane", make("h2", "", "Model"), this.model, make("h2", "", "Findings"), ...(doubts_of_new.get(path) ?? []).map((doubt) => make("p", "fair", doubt)), this.estimate, this.findings);
    this.element.classList.toggle("no_model", !is_case);
    this.element.append(
      make("div", "bar", this.save_button, this.run_button, make("label", "threads", "threads ", threads), ...jobs, this.state, this.switcher()),
      make("div", "panes", make("section", "pane form_pane", this.form.element), make("section", "pane text_pane", text_box), ...(is_case ? [checked] : [])));
    this.editor = createEditor(text_box, { schema, text: read.text, onChange: (now) => this.typed(now), ...(is_case ? { check: (now: string) => (this.last_check = this.check(now)) } : {}) });
    this.form.show(this.text);
    this.show_state();
    void this.draw();
  }

  /** Where there is no room for both, form or text. */
  private switcher(): HTMLElement {
    const faces = (["form", "text"] as const).map((side) => {
      const face = element("button", { type: "button", "aria-pressed": String(side === "form") }, side === "form" ? "Form" : "Text");
      face.addEventListener("click", () => this.show_side(side));
      face.dataset.side = side;
      return face;
    });
    return make("span", "switch", ...faces);
  }

  private show_side(side: "form" | "text"): void {
    this.element.classList.toggle("text_side", side === "text");
    for (const face of this.element.querySelectorAll<HTMLElement>(".switch button")) face.setAttribute("aria-pressed", String(face.dataset.side === side));
    this.editor.view.requestMeasure();
  }

  /** Asks before changes are lost. */
  may_leave(): boolean {
    return this.editor.text() === this.saved || confirm(`${this.path} has changes that are not saved. Leave it anyway?`);
  }

  leave(): void {
    this.gone = true;
    this.editor.destroy();
  }

  keys(event: KeyboardEvent): boolean {
    if (!(event.ctrlKey || event.metaKey)) return false;
    if (event.key === "s") void this.save();
    else if (event.key === "Enter") void this.run(Number(this.element.querySelector<HTMLInputElement>("#threads")!.value));
    else return false;
    return true;
  }

  private change(next: string): void {
    if (next === this.text.text) return;
    this.from_form = true;
    this.put(next);
    this.from_form = false;
  }

  /** The part that differs goes into the editor, so that its place and its undoing stay. */
  private put(next: string): void {
    const now = this.editor.text();
    let begin = 0;
    while (begin < now.length && now[begin] === next[begin]) ++begin;
    let end = 0;
    while (end < now.length - begin && end < next.length - begin && now[now.length - 1 - end] === next[next.length - 1 - end]) ++end;
    this.editor.view.dispatch({ changes: { from: begin, to: now.length - end, insert: next.slice(begin, next.length - end) } });
  }

  private typed(now: string): void {
    this.text = new CaseText(now);
    this.element.classList.toggle("no_toml", this.text.value === null);
    this.form.show(this.text);
    if (this.from_form) this.element.classList.remove("no_toml");
    this.show_state();
    this.draw_later();
  }

  /** Shows the line of the field. */
  private look_at(path: Path): void {
    const line = this.editor.view.state.doc.line(Math.min(this.text.line(path), this.editor.view.state.doc.lines));
    this.editor.view.dispatch({ selection: { anchor: line.from }, scrollIntoView: true });
  }

  private show_state(): void {
    const clean = this.editor ? this.editor.text() === this.saved : true;
    this.save_button.disabled = clean;
    this.state.textContent = clean ? "saved" : "changed, not saved";
  }

  private async check(now: string): Promise<Finding[]> {
    this.estimate.textContent = "Checking …";
    try {
      const checked = await api.check(this.path, now);
      if (!this.gone && now === this.editor.text()) this.show_checked(checked);
      return checked.findings;
    } catch (error) {
      if (!(error instanceof Refusal && error.status === 409)) this.estimate.textContent = (error as Error).message;
      return [];
    }
  }

  private show_checked({ findings, estimate }: Checked): void {
    this.estimate.textContent = estimate === null ? "" : `${estimate.particles > 0 ? `${estimate.particles.toLocaleString("en")} particles; ` : ""}a run takes ${duration_words(estimate.time_s)}, ${bytes_words(estimate.memory_bytes)} of memory and ${bytes_words(estimate.disk_bytes)} on the disk.`;
    const order = { error: 0, warning: 1, note: 2 }, shown = [...findings].sort((a, b) => order[a.level] - order[b.level]);
    this.findings.replaceChildren(...shown.map((finding) => {
      const face = make("button", `finding ${finding.level}`, make("strong", "", finding.key ?? finding.level), ` ${finding.message}${finding.nearest ? ` Did you mean ${finding.nearest}?` : ""}`);
      face.type = "button";
      face.addEventListener("click", () => this.go_to(finding));
      return make("li", "", face);
    }));
    if (shown.every(({ level }) => level === "note")) this.findings.prepend(make("li", "good", "No errors and no warnings."));
    this.run_button.disabled = shown.some(({ level }) => level === "error");
  }

  private go_to({ key, line }: Finding): void {
    if (line) {
      const { doc } = this.editor.view.state, at = doc.line(Math.min(line, doc.lines)).from;
      this.editor.view.dispatch({ selection: { anchor: at }, scrollIntoView: true });
    }
    if (key) this.show_side("form");
    if (key && this.form.go_to(key)) return;
    this.show_side("text");
    this.editor.view.focus();
  }

  private async draw(): Promise<void> {
    if (this.kind !== "case") return;
    const now = this.editor.text();
    try {
      const svg = await api.draw(this.path, now);
      if (!this.gone) this.model.replaceChildren(picture_of(svg, `The model of ${this.path}`));
      this.model.classList.remove("old");
    } catch {
      this.model.classList.add("old");
    }
  }

  private async save(): Promise<boolean> {
    const now = this.editor.text();
    try {
      this.modified = (await api.save(this.path, now, this.modified)).modified;
      this.saved = now;
      this.show_state();
      return true;
    } catch (error) {
      say((error as Error).message, "bad");
      return false;
    }
  }

  private async run(threads: number): Promise<void> {
    if (this.kind !== "case") return this.work(this.kind, { threads, replace: true });
    if (this.editor.text() !== this.saved && !(await this.save())) return;
    await this.last_check;
    try {
      const { path } = await api.start({ case: this.path, threads });
      location.hash = `#/run?path=${encodeURIComponent(path)}`;
    } catch (error) {
      say((error as Error).message, "bad");
    }
  }

  /** Writes tests of each material beside the case, if there are none yet, and runs them. */
  private async test_soil(): Promise<void> {
    if (this.editor.text() !== this.saved && !(await this.save())) return;
    const file = this.path.replace(/\.toml$/, "_element.toml"), name = this.path.split("/").pop()!;
    try {
      const there = await api.read(file).catch(() => null);
      if (there === null) await api.save(file, element_tests(name, this.text), null);
      const { job } = await api.work("element", file, { replace: true });
      location.hash = `#/job?job=${encodeURIComponent(job)}`;
    } catch (error) {
      say((error as Error).message, "bad");
    }
  }

  private async work(what: string, more: Record<string, unknown> = {}): Promise<void> {
    if (this.editor.text() !== this.saved && !(await this.save())) return;
    try {
      const { job } = await api.work(what, this.path, more);
      location.hash = `#/job?job=${encodeURIComponent(job)}`;
    } catch (error) {
      say((error as Error).message, "bad");
    }
  }
}

/** Undrained tests of what has an undrained strength, drained and undrained ones of the rest, under 20 kPa. */
export function element_tests(case_name: string, text: CaseText): string {
  const materials = Object.entries((text.at(["material"]) ?? {}) as Record<string, Record<string, unknown>>);
  const tests = materials.flatMap(([name, soil]) => {
    const angle = quantity(soil.friction_angle), total = soil.law === "clay" || angle === 0;
    const one = (kind: string, drained: boolean) =>
      `[[test]]\nname = "${name}_${kind}_${drained ? "drained" : "undrained"}"\nkind = "${kind}"\nmaterial = "${name}"\ndrained = ${drained}\n` +
      (kind === "triaxial" ? 'confining_stress = "20 kPa"\n' : 'vertical_stress = "20 kPa"\nk0 = 0.6\n') + "strain_path = [0.2]\n";
    return total ? [one("triaxial", false), one("simple_shear", false)] : [one("triaxial", true), one("simple_shear", true)];
  });
  return `# SPDX-License-Identifier: BSD-3-Clause\n# Laboratory tests of the soils of ${case_name}: change them as you like.\ntitle = "Soils of ${case_name}"\nmaterials_from = "${case_name}"\n\n${tests.join("\n")}`;
}

function quantity(value: unknown): number {
  return typeof value === "number" ? value : Number.parseFloat(String(value));
}

