// SPDX-License-Identifier: BSD-3-Clause
// The desk: a page for each address behind #, "#/case?path=line.toml".
import type { Schema } from "../editor/schema";
import { element } from "../element";
import { make } from "../film_elements";
import { follow_theme } from "../theme";
import { type About, api, type InputKind, take_token, use_token } from "./api";
import { CaseView, kind_of } from "./case_view";
import { CompareView, ExportView, JobView, PageView } from "./page_view";
import type { Place } from "./place";
import { RunView } from "./run_view";
import { RunsView } from "./runs_view";
import { StartView } from "./start_view";
import { VaryView } from "./vary_view";

const KEYS: [keys: string, what: string][] = [
  ["g s", "start"], ["g r", "runs"], ["Ctrl+S", "save the case"], ["Ctrl+Enter", "run the case"], ["Ctrl+Space", "offer keys and words, in the text"], ["?", "this list"], ["Esc", "close"],
];

class Desk {
  private place: Place | null = null;
  private shown = "";
  private main = make("main", "");
  private links = new Map<string, HTMLAnchorElement>();
  private schemas = new Map<InputKind, Schema>();
  private keys = make("dialog", "keys");
  private before = "";

  constructor(private readonly about: About) {
    const link = (to: string, words: string) => {
      const made = element("a", { href: `#/${to}` }, words);
      this.links.set(to, made);
      return made;
    };
    const help = element("button", { type: "button", title: "Keys (?)", "aria-label": "Keys" }, "?");
    help.addEventListener("click", () => this.keys.showModal());
    this.main.id = "main";
    this.main.tabIndex = -1;
    this.keys.append(make("h2", "", "Keys"), make("dl", "numbers", ...KEYS.flatMap(([keys, what]) => [make("dt", "", make("kbd", "", keys)), make("dd", "", what)])), element("form", { method: "dialog" }, element("button", {}, "Close")));
    const messages = make("div", "messages");
    document.body.replaceChildren(
      element("a", { href: "#main", class: "skip" }, "To the content"),
      make("header", "", make("nav", "", make("strong", "brand", "berm desk"), link("", "Start"), link("runs", "Runs"), element("span", { class: "quiet where", title: about.folder }, about.folder.split("/").pop()!), help)), this.main, this.keys, messages);
    document.querySelector(".skip")!.addEventListener("click", (event) => {
      event.preventDefault();
      this.main.focus();
    });
    follow_theme();
    addEventListener("hashchange", () => void this.go());
    addEventListener("beforeunload", (event) => {
      if (this.place instanceof CaseView && this.place.element.querySelector(".bar button:first-child:not(:disabled)")) event.preventDefault();
    });
    addEventListener("keydown", (event) => this.key(event));
    void this.go();
  }

  private async go(): Promise<void> {
    const hash = location.hash || "#/";
    if (hash === this.shown) return;
    if (this.place?.may_leave && !this.place.may_leave()) {
      history.replaceState(null, "", this.shown);
      return;
    }
    this.shown = hash;
    this.place?.leave?.();
    this.place = null;
    this.main.replaceChildren(make("p", "quiet", "…"));
    try {
      const place = await this.place_at(hash);
      if (this.shown !== hash) return place.leave?.();
      this.place = place;
      this.main.replaceChildren(place.element);
      document.title = `${place.title} – berm desk`;
    } catch (error) {
      this.main.replaceChildren(make("p", "bad", (error as Error).message));
    }
    const [word] = hash.slice(2).split("?");
    for (const [to, link] of this.links) {
      if (to === word) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    }
    scrollTo(0, 0);
    this.main.focus({ preventScroll: true }); // the next Tab goes to the first control of what is shown
  }

  private async place_at(hash: string): Promise<Place> {
    const [word, query = ""] = hash.slice(2).split("?"), asked = new URLSearchParams(query), path = asked.get("path") ?? "";
    if (word === "case") {
      const read = await api.read(path), kind = kind_of(read.text), schema = this.schemas.get(kind) ?? ((await api.schema(kind)) as Schema);
      this.schemas.set(kind, schema);
      return new CaseView(path, read, kind, schema, this.about.cores);
    }
    if (word === "runs") return new RunsView();
    if (word === "run") return new RunView(path);
    if (word === "vary") return new VaryView(path);
    if (word === "compare") return new CompareView(asked.getAll("path"));
    if (word === "export") return new ExportView(asked.getAll("path"));
    if (word === "page") return new PageView(path);
    if (word === "job") return new JobView(asked.get("job") ?? "");
    return new StartView(this.about.folder.split("/").pop()!);
  }

  private key(event: KeyboardEvent): void {
    if (this.place?.keys?.(event)) return event.preventDefault();
    const target = event.target as HTMLElement;
    if (target.closest("input, select, textarea, [contenteditable=true]") || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "?") this.keys.showModal();
    if (this.before === "g" && event.key === "s") location.hash = "#/";
    if (this.before === "g" && event.key === "r") location.hash = "#/runs";
    this.before = event.key;
  }
}

const token = take_token();
if (token === null) {
  document.body.replaceChildren(make("main", "", make("h1", "", "berm desk"), make("p", "", "This address lacks its token. Open the one that berm desk printed in its terminal.")));
} else {
  use_token(token);
  api.about().then((about) => new Desk(about)).catch((error: Error) => document.body.replaceChildren(make("main", "", make("h1", "", "berm desk"), make("p", "bad", error.message))));
}
