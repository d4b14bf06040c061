// SPDX-License-Identifier: BSD-3-Clause
// A study of uncertain parameters, from a finished run: which numbers of its case vary, which key results are measured.
import { element } from "../element";
import { make } from "../film_elements";
import { api, type Summary } from "./api";
import { CaseText, type Path } from "./case_text";
import type { Place } from "./place";
import { range_in } from "./ranges";
import { value_words } from "./words";

interface Varied { key: string; low: string; best: string; high: string }
interface Measured { quantity: string; unit: string }

/** Shown instead of SI units, which they are a thousandth of. */
const thousands: Record<string, string> = { "N/m": "kN/m", N: "kN", Pa: "kPa", "N m": "kN m" };

const text = (words: string) => JSON.stringify(words);
/** What a template marks as to be set. */
const is_marked = (read: CaseText, path: Path) => path[0] === "material" && /^<-/.test(read.comment(path));

/** The study as TOML; without a sample each parameter is low and high in turn. */
export function study_of(case_name: string, varied: Varied[], measured: Measured[], sample: number): string {
  const lines = ["# SPDX-License-Identifier: BSD-3-Clause", `title = ${text(`Low, best and high of ${case_name}`)}`, "", "[[case]]", `name = ${text(case_name.replace(/\.toml$/, ""))}`, `file = ${text(case_name)}`];
  if (sample > 0) {
    lines.push("", "[sample]", `size = ${sample}`, "seed = 1");
    for (const { key, low, best, high } of varied) lines.push("", "[[sample.parameter]]", `name = ${text(key)}`, `keys = [${text(key)}]`, `low = ${low}`, `best = ${best}`, `high = ${high}`);
  } else {
    lines.push("", "[[axis]]", 'name = "parameter"', "[[axis.value]]", 'name = "best"');
    for (const { key, low, high } of varied)
      for (const [word, value] of [["low", low], ["high", high]]) lines.push("[[axis.value]]", `name = ${text(`${key} ${word}`)}`, `set = [${text(`${key}=${value}`)}]`);
  }
  for (const { quantity, unit } of measured)
    lines.push("", "[[measure]]", `name = ${text(quantity)}`, `quantity = ${text(quantity)}`, ...(thousands[unit] ? [`unit = ${text(thousands[unit])}`, "scale = 0.001"] : []));
  return `${lines.join("\n")}\n`;
}

/** A number with its unit, times a factor, as TOML spells it; null where it is none. */
export function scaled(value: unknown, factor: number): string | null {
  const found = /^\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(.*)$/.exec(typeof value === "number" || typeof value === "string" ? String(value) : "");
  const number = found ? Number(found[1]) : 0;
  if (!found || !(number > 0)) return null; // the distribution is a lognormal one
  const next = String(Number((number * factor).toPrecision(4)));
  return typeof value === "number" ? next : text(`${next} ${found[2]}`.trim());
}

/** The first of NAME.toml, NAME_2.toml ... that is not there. */
async function free_name(folder: string, name: string): Promise<string> {
  const { studies, cases } = await api.folder(folder.replace(/\/$/, "")), taken = new Set([...studies, ...cases].map(({ path }) => path));
  for (let k = 1; ; ++k) {
    const next = k === 1 ? `${name}.toml` : `${name}_${k}.toml`;
    if (!taken.has(next)) return next;
  }
}

export class VaryView implements Place {
  readonly element = make("div", "vary_view");
  readonly title = "Low, best, high";
  private rows: { key: string; best: string; chosen: HTMLInputElement; low: HTMLInputElement; high: HTMLInputElement }[] = [];
  private measures: { measured: Measured; chosen: HTMLInputElement }[] = [];
  private sample = element("input", { type: "number", id: "sample", min: 0, max: 100000, value: 20 });
  private count = make("p", "quiet");
  private wrong = make("p", "bad");

  constructor(private readonly run: string) {
    void this.show().catch((error: Error) => this.element.replaceChildren(make("p", "bad", error.message)));
  }

  private async show(): Promise<void> {
    const now = await api.run(this.run, 0);
    if (!now.summary) throw new Error(`${this.run} has no key results yet.`);
    const file = now.case, folder = file.includes("/") ? file.slice(0, file.lastIndexOf("/") + 1) : "", case_name = file.slice(folder.length);
    const read = new CaseText((await api.read(file)).text);
    const write = element("button", { type: "submit", class: "primary" }, "Run the study"), form = element("form", { class: "vary" });
    const name = element("input", { type: "text", id: "study-file", value: await free_name(folder, `${file.replace(/\.toml$/, "")}_study`), required: "" });
    form.append(
      make("h2", "", `Low, best and high of ${file}`),
      make("p", "quiet", "Select uncertain parameters and give their 5 % and 95 % values; the case has the best ones. Low and high are those that the case gives beside a field; else 0.8 and 1.25 times the best value. The distribution is lognormal; the file of the study can name another."),
      this.parameters(read), make("h3", "", "Key results"), this.quantities(now.summary, now.answer?.name),
      element("label", { for: "sample" }, "Rows of the sample: 20 or more for a low and a high estimate; 0: each parameter low and high in turn, no sample"), this.sample,
      element("label", { for: "study-file" }, "File of the study"), name, this.count, this.wrong, write);
    form.addEventListener("input", () => this.tell());
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.begin(case_name, name.value);
    });
    this.element.append(form);
    this.tell();
  }

  private parameters(read: CaseText): HTMLElement {
    const numbers: Path[] = ["material", "contact"].flatMap((table) =>
      Object.entries((read.at([table]) ?? {}) as Record<string, Record<string, unknown>>).flatMap(([name, keys]) => Object.keys(keys).map((key): Path => [table, name, key])));
    const given = numbers.some((path) => range_in(read.comment(path)) !== null);
    const rows = numbers.flatMap((path) => {
      const value = read.at(path), range = range_in(read.comment(path)), best = scaled(value, 1), key = path.join(".");
      const low = range?.low ?? scaled(value, 0.8), high = range?.high ?? scaled(value, 1.25);
      if (low === null || best === null || high === null) return [];
      const field = (words: string, value_: string) => element("input", { type: "text", "aria-label": `${words} of ${key}`, value: value_.replaceAll('"', "") });
      const row = { key, best, chosen: element("input", { type: "checkbox", "aria-label": `vary ${key}` }), low: field("low", low), high: field("high", high) };
      row.chosen.checked = given ? range !== null : is_marked(read, path);
      this.rows.push(row);
      return [{ first: range !== null || is_marked(read, path), face: make("tr", "", make("td", "", row.chosen), make("td", "", make("code", "", key)), make("td", "", row.low), make("td", "unit", best.replaceAll('"', "")), make("td", "", row.high)) }];
    });
    if (rows.length === 0) throw new Error("The materials and contacts of this case have no numbers to vary.");
    const table = (some: typeof rows) => make("div", "scrolls", make("table", "list", make("thead", "", make("tr", "", ...["", "parameter", "low (5 %)", "best", "high (95 %)"].map((word) => make("th", "", word)))), make("tbody", "", ...some.map(({ face }) => face))));
    const first = rows.filter((row) => row.first), others = rows.filter((row) => !row.first);
    return first.length === 0 || others.length === 0 ? table(rows) : make("div", "", table(first), make("details", "", make("summary", "", `${others.length} more numbers of soils and contacts`), table(others)));
  }

  /** The key number of the kind of run is ticked. */
  private quantities({ quantities }: Summary, key = ""): HTMLElement {
    const all = Object.entries((quantities ?? {}) as Record<string, { value?: unknown; unit: string; meaning: string; kind?: string }>).filter(([, { value, kind }]) => typeof value === "number" && kind === "answer");
    return make("div", "measures", ...all.map(([name, { value, unit, meaning }]) => {
      const chosen = element("input", { type: "checkbox" });
      chosen.checked = name === key;
      this.measures.push({ measured: { quantity: name, unit }, chosen });
      const face = make("label", "", chosen, ` ${name} `, make("span", "quiet", value_words(value as number, unit)));
      face.title = meaning;
      return face;
    }));
  }

  private tell(): void {
    const varied = this.rows.filter(({ chosen }) => chosen.checked).length, measured = this.measures.filter(({ chosen }) => chosen.checked).length;
    this.count.textContent = varied === 0 ? "Tick a parameter." : measured === 0 ? "Tick a key result." : `${1 + 2 * varied + Number(this.sample.value)} runs of the case.`;
  }

  private async begin(case_name: string, file: string): Promise<void> {
    const literal = (words: string) => (Number.isFinite(Number(words)) ? words.trim() : text(words.trim()));
    const varied = this.rows.filter(({ chosen }) => chosen.checked).map(({ key, best, low, high }) => ({ key, best, low: literal(low.value), high: literal(high.value) }));
    const measured = this.measures.filter(({ chosen }) => chosen.checked).map((each) => each.measured);
    if (varied.length === 0 || measured.length === 0) return;
    try {
      const there = await api.read(file).catch(() => null), study = study_of(case_name, varied, measured, Number(this.sample.value));
      if (there !== null && there.text !== study) throw new Error(`${file} exists with other contents: give the study another name.`);
      if (there === null) await api.save(file, study, null);
      const { job } = await api.work("study", file);
      location.hash = `#/job?job=${encodeURIComponent(job)}`;
    } catch (error) {
      this.wrong.textContent = (error as Error).message;
    }
  }
}
