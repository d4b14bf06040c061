// SPDX-License-Identifier: BSD-3-Clause
// Where the desk begins: kinds of job by picture, and what the folder holds.
import { element } from "../element";
import { make } from "../film_elements";
import { api, doubts_of_new, type FileOf, type FolderOf, type Kind, type RunState, type Soil } from "./api";
import type { Place } from "./place";
import { is_part, status_badge } from "./runs_view";
import { bytes_words, picture_of } from "./words";

const link = (to: string, path: string, words: string) => element("a", { href: `#/${to}?path=${encodeURIComponent(path)}` }, words);

const drawn = new Map<string, string>();
async function picture_of_kind(kind: string): Promise<string> {
  const picture = drawn.get(kind) ?? (await api.picture(kind));
  drawn.set(kind, picture);
  return picture;
}

/** What is legible at the size of a card: the close-up of the model, else the model, without its words. */
function small(picture: string): string {
  const svg = new DOMParser().parseFromString(picture, "image/svg+xml").documentElement as unknown as SVGSVGElement;
  const panels = svg.querySelectorAll("svg"), panel = panels[panels.length - 1], [, , width, height] = svg.getAttribute("viewBox")!.split(" ").map(Number);
  for (const words of svg.querySelectorAll("text")) words.remove();
  const box = panel?.getAttribute("viewBox") ?? `${0.08 * width} ${0.1 * height} ${0.47 * width} ${0.8 * height}`, [, , wide, tall] = box.split(" ");
  for (const [name, value] of [["viewBox", box], ["width", wide], ["height", tall]]) svg.setAttribute(name, value);
  return new XMLSerializer().serializeToString(svg);
}

/** "pipe-in-clay" as a title. */
function job_of({ kind }: Kind): string {
  const words = kind === "cpt" ? "cone penetration test" : kind === "t-bar" ? "T-bar test" : kind.replaceAll("-", " ");
  return words[0].toUpperCase() + words.slice(1);
}

export class StartView implements Place {
  readonly element = make("div", "start_view");
  readonly title = "Start";
  private dialog = make("dialog", "new_case");
  private soils: Soil[] = [];
  private here = "";
  private list = make("div", "folder_list");
  private waiting: HTMLElement[] = [];
  private drawing = false;
  private gone = false;
  private pictures = new IntersectionObserver((seen) => {
    this.waiting.push(...seen.filter((each) => each.isIntersecting).map((each) => each.target as HTMLElement));
    void this.draw();
  });

  constructor(folder: string) {
    const kinds = make("div", "kinds", make("p", "quiet", "Loading …"));
    this.element.append(
      make("section", "", make("h2", "", `In ${folder}`), this.list),
      make("section", "", make("h2", "", "New case"), kinds), this.dialog);
    void this.show_folder("");
    void Promise.all([api.kinds(), api.soils().catch(() => [])])
      .then(([all, soils]) => {
        this.soils = soils;
        kinds.replaceChildren(...grouped(all).map(([group, list]) => make("div", "kind_group", make("h3", "", group), make("div", "cards", ...list.map((kind) => this.card(kind))))));
      })
      .catch((error: Error) => kinds.replaceChildren(make("p", "bad", error.message)));
  }

  leave(): void {
    this.gone = true;
    this.pictures.disconnect();
  }

  private card(kind: Kind): HTMLElement {
    const picture = make("div", "card_picture");
    picture.dataset.kind = kind.kind;
    this.pictures.observe(picture);
    const card = element("button", { type: "button", class: "card" });
    card.append(picture, make("strong", "", job_of(kind)), make("span", "quiet", kind.question));
    card.addEventListener("click", () => this.ask(kind));
    return card;
  }

  /** One picture at a time: the machine has other work. */
  private async draw(): Promise<void> {
    if (this.drawing) return;
    this.drawing = true;
    for (let picture = this.waiting.shift(); picture !== undefined && !this.gone; picture = this.waiting.shift()) {
      this.pictures.unobserve(picture);
      try {
        picture.replaceChildren(picture_of(small(await picture_of_kind(picture.dataset.kind!)), ""));
      } catch {
        picture.replaceChildren(make("span", "quiet", "no picture"));
      }
    }
    this.drawing = false;
  }

  /** Name, size and soil of the new case. */
  private ask(kind: Kind): void {
    const file = element("input", { type: "text", id: "new-file", value: `${this.here === "" ? "" : `${this.here}/`}${kind.kind.replaceAll("-", "_")}.toml`, required: "" });
    const size = element("select", { id: "new-size" }, ...kind.sizes.map((word) => element("option", {}, word)));
    size.value = kind.sizes.includes("quick") ? "quick" : (kind.sizes[0] ?? "");
    const fitting = this.soils.filter(({ soil }) => kind.soils.includes(soil)), source = make("p", "quiet");
    const soil = element("select", { id: "new-soil" }, element("option", { value: "" }, "as in the template"), ...fitting.map((each) => element("option", { value: each.soil }, each.title)));
    soil.addEventListener("change", () => {
      const chosen = fitting.find((each) => each.soil === soil.value);
      source.textContent = chosen ? `${chosen.source}. ${chosen.trust}` : "";
    });
    const form = element("form", { method: "dialog" }), wrong = make("p", "bad");
    const cpt = element("input", { type: "file", id: "new-cpt", accept: ".csv,.gef,.ags" }), place = element("input", { type: "text", id: "new-location", placeholder: "LOCA_ID, if the file has several" });
    const where = make("div", "", element("label", { for: "new-location" }, "Location in a file of AGS"), place);
    where.hidden = true;
    cpt.addEventListener("change", () => (where.hidden = !/\.ags$/i.test(cpt.files?.[0]?.name ?? "")));
    const begin = element("button", { type: "submit", class: "primary" }, "Create"), stop = element("button", { type: "button" }, "Cancel");
    form.append(
      make("h3", "", job_of(kind)), make("p", "quiet", `${kind.question} ${kind.title}.`),
      element("label", { for: "new-file" }, "File"), file,
      element("label", { for: "new-size" }, "Size of the cells, and speed"), size,
      ...(fitting.length > 0 ? [element("label", { for: "new-soil" }, "Soil"), soil, source] : []),
      ...(kind.sounding ? [element("label", { for: "new-cpt" }, "Strength from a sounding (CPT: .csv, .gef or .ags)"), cpt, where,
        make("p", "quiet", "Laboratory tests: berm fit turns them into parameters. A file of it opens at the desk, with the button Fit the soil.")] : []),
      wrong, make("div", "bar", begin, stop));
    stop.addEventListener("click", () => this.dialog.close());
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const path = file.value.endsWith(".toml") ? file.value : `${file.value}.toml`;
      const create = async () => {
        const file = cpt.files?.[0];
        if (file && file.size > most_bytes) throw new Error(`${file.name} has ${bytes_words(file.size)}, and the desk takes ${bytes_words(most_bytes)}: berm new --cpt takes larger ones.`);
        const sounding = file ? { cpt: { name: file.name, text: await text_in(file) }, ...(place.value ? { location: place.value } : {}) } : {};
        return api.create({ kind: kind.kind, path, ...(size.value ? { size: size.value } : {}), ...(soil.value ? { soil: soil.value } : {}), ...sounding });
      };
      create()
        .then(({ doubts }) => {
          doubts_of_new.set(path, doubts);
          this.dialog.close();
          location.hash = `#/case?path=${encodeURIComponent(path)}`;
        })
        .catch((error: Error) => (wrong.textContent = error.message)); // a message at the foot of the page would lie behind the dialog
    });
    this.dialog.replaceChildren(form);
    this.dialog.showModal();
    file.focus();
    file.select();
  }

  private async show_folder(path: string): Promise<void> {
    try {
      const [found, runs] = await Promise.all([api.folder(path), api.runs()]);
      this.here = path;
      this.list.replaceChildren(...this.rows(found, runs));
    } catch (error) {
      this.list.replaceChildren(make("p", "bad", (error as Error).message));
    }
  }

  private rows({ path, cases, studies, tests, folders }: FolderOf, runs: RunState[]): HTMLElement[] {
    const folder = (to: string, words: string) => {
      const face = make("button", "folder", words);
      face.type = "button";
      face.addEventListener("click", () => void this.show_folder(to));
      return face;
    };
    const up = path === "" || path === "." ? [] : [folder(path.includes("/") ? path.slice(0, path.lastIndexOf("/")) : "", "↑ up")];
    const files = (words: string, all: FileOf[]) => (all.length > 0 ? [make("h3", "", words), make("ul", "files", ...all.map((each) => make("li", "", link("case", each.path, each.path), make("span", "quiet", each.title ?? ""))))] : []);
    const recent = runs.filter(({ path }) => !is_part(path)).slice(-8).reverse();
    return [
      make("div", "folders", ...up, ...folders.filter((each) => each !== "out").map((each) => folder(each, `${each.split("/").pop()}/`))),
      ...files("Cases", cases), ...files("Studies", studies), ...files("Element tests and fits", tests),
      ...(recent.length > 0 ? [make("h3", "", "Runs"), make("ul", "files", ...recent.map((each) => make("li", "", link("run", each.path, each.path), status_badge(each.status), make("span", "quiet", each.case))))] : []),
      ...(cases.length + studies.length + tests.length + recent.length === 0 ? [make("p", "quiet", "No cases yet: choose a kind below.")] : []),
    ];
  }
}

/** Of a sounding. */
const most_bytes = 3e6;

/** Soundings of older programs are in Latin-1. */
async function text_in(file: File): Promise<string> {
  const bytes = await file.arrayBuffer();
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return new TextDecoder("windows-1252").decode(bytes);
  }
}

function grouped(kinds: Kind[]): [string, Kind[]][] {
  const groups = new Map<string, Kind[]>();
  for (const kind of kinds) groups.set(kind.group, [...(groups.get(kind.group) ?? []), kind]);
  return [...groups];
}
