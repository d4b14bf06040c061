// SPDX-License-Identifier: BSD-3-Clause
// A case as a form, made from its schema: a group for each table, what the file sets in sight, the rest folded away.
import { below, is_table, keys_of, type Schema, type Words } from "../editor/schema";
import { element } from "../element";
import { make } from "../film_elements";
import type { CaseText, Path } from "./case_text";
import { may_vary, type Range, range_in, with_range, without_range, wrong_in } from "./ranges";
import { in_unit, type Quantity, quantity_of, spelled, units_of } from "./units";

/** A value was changed: as TOML spells it, "" where the key goes. */
export type Changed = (path: Path, literal: string) => void;
/** The comment behind it was changed. */
export type Said = (path: Path, comment: string) => void;

/** "material.clay", or of a stage its name: "stage.drag". */
export function words_of(text: CaseText, path: Path): string {
  return path
    .map((key, i) => {
      if (typeof key !== "number") return key;
      const name = text.at([...path.slice(0, i + 1), "name"]);
      return typeof name === "string" ? name : `[${key}]`;
    })
    .join(".");
}

const words_in = (value: unknown): Words =>
  new Map(Object.entries((value ?? {}) as Record<string, unknown>).filter((pair): pair is [string, string] => typeof pair[1] === "string"));

/** A key of a table, or of a table in it: its path from the group, and its schema. */
interface Field {
  path: Path;
  schema: Schema & { "x-unit"?: string };
}

/** Keys with values, those of small tables within ("until.time") among them. */
function fields_of(table: Schema, value: unknown, path: Path): Field[] {
  const found: Field[] = [];
  for (const [key, schema] of Object.entries(keys_of(table, words_in(value)))) {
    const inner = (value as Record<string, unknown> | undefined)?.[key];
    if (!is_table(schema)) found.push({ path: [...path, key], schema });
    else if (schema.type === "object" && (schema.properties || schema.oneOf)) found.push(...fields_of(schema, inner, [...path, key]));
  }
  return found;
}

/** A table of the case that has a group of its own. */
interface Group {
  path: Path;
  table: Schema;
}

/** The case itself, tables, tables by name, and items of arrays, as far as the case has them; tables that it lacks come last. */
function groups_of(schema: Schema, text: CaseText): { present: Group[]; lacking: { key: string; schema: Schema }[] } {
  const present: Group[] = [{ path: [], table: leaves_alone(schema, words_in(text.value)) }], lacking: { key: string; schema: Schema }[] = [];
  for (const [key, one] of Object.entries(keys_of(schema, words_in(text.value)))) {
    if (!is_table(one)) continue;
    const value = text.at([key]);
    if (value === undefined) lacking.push({ key, schema: one });
    else if (Array.isArray(value)) value.forEach((_, i) => present.push({ path: [key, i], table: below(schema, new Map(), key) ?? {} }));
    else if (typeof one.additionalProperties === "object")
      for (const name of Object.keys(value as object)) present.push({ path: [key, name], table: one.additionalProperties });
    else present.push({ path: [key], table: one });
  }
  return { present, lacking };
}

/** Where an engineer looks for a table; settings of the calculation come last. */
const themes: [name: string, tables: string[]][] = [
  ["Case", [""]], ["Site and soil", ["material", "random_field", "body", "initial_state"]], ["Structure", ["rigid", "pipeline", "contact", "rigid_contact"]], ["Loads and stages", ["stage", "traction"]],
  ["Numerics", []],
];
const theme_of = (path: Path) => Math.max(themes.findIndex(([, tables]) => tables.includes(String(path[0] ?? ""))), -1);
const rank = (path: Path) => (theme_of(path) < 0 ? themes.length - 1 : theme_of(path));

/** "undrained_strength_gradient" as a reader says it. */
export function in_words(key: string): string {
  const words = key.replaceAll("_", " ").replaceAll(".", ": ");
  return key.length === 1 ? key : words[0].toUpperCase() + words.slice(1);
}

/** A template marks with an arrow what is to be changed, and may say what it is. */
const mark = /^<-\s*/;
/** With them the title comes first. */
const is_first = (text: CaseText, path: Path) => mark.test(text.comment(path)) || (path.length === 1 && path[0] === "title" && /#\s*<-/.test(text.text));

/** The keys of the case that are no tables. */
function leaves_alone(schema: Schema, words: Words): Schema {
  return { properties: Object.fromEntries(Object.entries(keys_of(schema, words)).filter(([, one]) => !is_table(one))) };
}

export class Form {
  readonly element = make("div", "form");
  private open = new Set<string>();
  private folded = new Set<string>();

  constructor(private readonly schema: Schema, private readonly changed: Changed, private readonly said: Said, private readonly looked_at: (path: Path) => void) {
    this.element.setAttribute("role", "form");
    this.element.setAttribute("aria-label", "The case");
  }

  /** Draws the form anew, and leaves the reader in the field where he was. */
  show(text: CaseText): void {
    if (text.value === null) return;
    const focused = document.activeElement instanceof HTMLElement && this.element.contains(document.activeElement) ? document.activeElement.id : "";
    const { present, lacking } = groups_of(this.schema, text);
    const ordered = [...present].sort((a, b) => rank(a.path) - rank(b.path)), to_set = this.to_set(text, ordered);
    this.element.replaceChildren(...to_set, ...ordered.map((group, i) => this.group(text, group, to_set.length === 0 && i < 2)), this.more(lacking));
    if (focused) document.getElementById(focused)?.focus({ preventScroll: true });
  }

  /** Opens the group of a key, and goes to its field; false where the form has none. */
  go_to(key: string): boolean {
    const field = [...this.element.querySelectorAll<HTMLElement>("[data-key]")].find((each) => each.dataset.key === key || key.startsWith(`${each.dataset.key}[`));
    const group = [...this.element.querySelectorAll<HTMLDetailsElement>("details.group")].reverse().find((each) => key === each.dataset.path || key.startsWith(`${each.dataset.path}.`));
    const place = field ?? group;
    if (!place) return false;
    for (let parent: HTMLElement | null = place; parent && parent !== this.element; parent = parent.parentElement) if (parent instanceof HTMLDetailsElement) parent.open = true;
    place.scrollIntoView({ block: "center" });
    (field?.querySelector<HTMLElement>("input, select") ?? place.querySelector<HTMLElement>("summary"))?.focus({ preventScroll: true });
    return true;
  }

  /** What the template marks, by theme. */
  private to_set(text: CaseText, groups: Group[]): HTMLElement[] {
    const marked = groups.flatMap((group) => fields_of(group.table, text.at(group.path), group.path).filter(({ path }) => is_first(text, path)).map((field) => ({ group: group.path, field })));
    return themes.flatMap(([theme], number) => {
      const own = marked.filter(({ group }) => rank(group) === number);
      if (own.length === 0) return [];
      let last = "";
      const rows = own.flatMap(({ group, field }) => {
        const name = words_of(text, group), head = name === last || group.length === 0 ? [] : [make("p", "quiet of_table", name.split(".").slice(1).join(".") || name)];
        last = name;
        return [...head, this.field(text, field, group)];
      });
      return [make("section", "to_set", make("h3", "", theme), ...rows)];
    });
  }

  private group(text: CaseText, { path, table }: Group, opened: boolean): HTMLElement {
    const name = words_of(text, path), value = text.at(path), all = fields_of(table, value, path).filter((field) => !is_first(text, field.path));
    const is_set = ({ path: at }: Field) => text.spelled(at) !== null;
    const set = all.filter(is_set), unset = all.filter((field) => !is_set(field));
    const details = make("details", "group"), shown = opened || this.open.has(name);
    details.open = shown && !this.folded.has(name);
    details.dataset.path = name;
    details.addEventListener("toggle", () => {
      (details.open ? this.open : this.folded).add(name);
      (details.open ? this.folded : this.open).delete(name);
    });
    details.append(
      make("summary", "", make("span", "group_name", path.length === 0 ? "general" : name), make("span", "quiet group_digest", digest(set, text, path))),
      ...set.map((field) => this.field(text, field, path)));
    if (unset.length > 0) {
      const more = make("details", "advanced", make("summary", "", unset.length === 1 ? "1 more key" : `${unset.length} more keys`)), key = `${name}/more`;
      more.open = this.open.has(key);
      const fill = () => more.childElementCount === 1 && more.append(...unset.map((field) => this.field(text, field, path)));
      if (more.open) fill();
      more.addEventListener("toggle", () => {
        if (more.open) this.open.add(key), fill();
        else this.open.delete(key);
      });
      details.append(more);
    }
    return details;
  }

  private field(text: CaseText, { path, schema }: Field, group: Path): HTMLElement {
    const key = path.slice(group.length).join("."), id = `field-${path.join("-")}`, spelling = text.spelled(path);
    const meaning = (schema.description ?? "").split("\n\n")[0];
    const row = make("div", spelling === null ? "field unset" : "field");
    row.dataset.key = words_of(text, path);
    const said = without_range(text.comment(path)).replace(mark, ""), label = element("label", { for: id, title: key }, in_words(key));
    if (said && mark.test(text.comment(path))) label.append(make("span", "quiet said", said));
    const control = this.control(id, path, schema, spelling, text.former(path)), range = may_vary(text, path) ? this.range(text, path, id, quantity_of(spelling!, schema["x-unit"] ?? "")?.unit ?? "") : null;
    if (range) control.append(range.face);
    row.append(label, control, ...(range ? [range.box] : []), element("p", { class: "quiet meaning", id: `${id}-meaning` }, meaning));
    row.querySelector(`#${CSS.escape(id)}`)?.setAttribute("aria-describedby", `${id}-meaning`);
    row.addEventListener("focusin", () => this.looked_at(path));
    return row;
  }

  /** Low and high below the best value, and the button that shows them. */
  private range(text: CaseText, path: Path, id: string, unit: string): { face: HTMLElement; box: HTMLElement } {
    const now = range_in(text.comment(path)), name = `${id}-range`, words = in_words(String(path[path.length - 1])), box = make("div", "range");
    const face = element("button", { type: "button", id: name, class: "of_range", "aria-label": `low and high of ${words}`, title: "Low and high: the 5 % and 95 % values, for Low, best, high of a finished run" }, "±");
    const field = (side: keyof Range) => element("input", { type: "text", id: `${id}-${side}`, "aria-label": `${side} ${words}`, value: now?.[side] ?? "", placeholder: `${side}${unit ? `, ${unit}` : ""}`, autocomplete: "off" });
    const low = field("low"), high = field("high");
    for (const each of [low, high])
      each.addEventListener("change", () => {
        if ((low.value === "") !== (high.value === "")) return; // the other one is still to come
        const range = { low: low.value, high: high.value }, wrong = wrong_in(range);
        each.setCustomValidity(wrong);
        if (wrong) each.reportValidity();
        else this.said(path, with_range(text.comment(path), range, unit));
      });
    const show = () => {
      box.hidden = now === null && !this.open.has(name);
      face.setAttribute("aria-expanded", String(!box.hidden));
      box.replaceChildren(...(box.hidden ? [] : [low, high]));
    };
    face.addEventListener("click", () => {
      if (!this.open.delete(name)) this.open.add(name);
      show();
      if (!box.hidden) low.focus();
    });
    show();
    return { face, box };
  }

  private control(id: string, path: Path, schema: Field["schema"], spelling: string | null, former: string | null): HTMLElement {
    const preset = schema.default === undefined ? "" : String(schema.default);
    if (schema.enum || schema.type === "boolean") {
      const words = schema.enum ?? ["true", "false"], literal = (word: string) => (schema.enum ? JSON.stringify(word) : word);
      const select = element("select", { id }, element("option", { value: "" }, preset ? `${preset} (default)` : "–"), ...words.map((word) => element("option", { value: literal(word) }, word)));
      select.value = spelling ?? "";
      select.addEventListener("change", () => this.changed(path, select.value));
      return select;
    }
    if (Array.isArray(schema.type) && schema.type.includes("number")) return this.number(id, path, schema["x-unit"] ?? "", preset, spelling, former);
    const input = element("input", { id, type: "text", placeholder: preset || (schema.type === "array" ? "[…]" : ""), spellcheck: "false" });
    const of_text = schema.type === "string";
    input.value = of_text && spelling?.startsWith('"') ? (JSON.parse(spelling) as string) : (spelling ?? "");
    input.addEventListener("change", () => this.changed(path, input.value === "" ? "" : of_text ? JSON.stringify(input.value) : input.value));
    return input;
  }

  /** `former`: what stood in a field that was cleared, whose unit it keeps. */
  private number(id: string, path: Path, si: string, preset: string, spelling: string | null, former: string | null): HTMLElement {
    const known = spelling === null ? null : quantity_of(spelling, si), was = former === null ? null : quantity_of(former, si), word = spelling !== null && known === null;
    const input = element("input", { id, type: "text", inputmode: "decimal", placeholder: was ? `was ${was.number}` : preset, autocomplete: "off" });
    const all = units_of(si), first = was?.unit ?? usual(si, preset, all);
    let now: Quantity = known ?? { number: "", unit: first, plain: false };
    input.value = word ? spelling!.replace(/^"|"$/g, "") : now.number;
    const write = () => this.changed(path, spelled({ ...now, number: input.value }, si));
    input.addEventListener("change", write);
    const box = make("span", "quantity", input);
    if (si === "") return box;
    const select = element("select", { "aria-label": `unit of ${path[path.length - 1]}` }, ...all.map((unit) => element("option", {}, unit)));
    select.value = now.unit;
    select.addEventListener("change", () => {
      now = input.value === "" ? { ...now, unit: select.value, plain: false } : in_unit({ ...now, number: input.value }, si, select.value);
      input.value = now.number;
      if (input.value !== "") write();
    });
    box.append(select);
    return box;
  }

  /** Tables that the case has not. */
  private more(lacking: { key: string; schema: Schema }[]): HTMLElement {
    const list = make("details", "group", make("summary", "", make("span", "group_name", "more tables")));
    list.dataset.path = "";
    for (const { key, schema } of lacking)
      list.append(make("div", "field", make("code", "", schema.type === "array" ? `[[${key}]]` : typeof schema.additionalProperties === "object" ? `[${key}.NAME]` : `[${key}]`), make("p", "quiet meaning", (schema.description ?? "").split("\n\n")[0])));
    list.append(make("p", "quiet", "Write the header of a table into the text: its keys are offered as you type, and the form follows."));
    return list;
  }
}

/** The unit of the default, or the first. */
function usual(si: string, preset: string, all: string[]): string {
  const unit = /^[-+\d.eE]+\s+(.+)$/.exec(preset)?.[1];
  return unit !== undefined && all.includes(unit) ? unit : (all[0] ?? si);
}

/** What a closed group tells: its first words and numbers. */
function digest(set: Field[], text: CaseText, group: Path): string {
  return set
    .filter(({ path }) => path.length === group.length + 1)
    .slice(0, 3)
    .map(({ path }) => text.spelled(path)!.replace(/^"|"$/g, ""))
    .filter((words) => words.length < 30)
    .join(" · ");
}
