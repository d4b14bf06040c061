// SPDX-License-Identifier: BSD-3-Clause
// A case as a text of TOML: what stands where, and the text with one value changed. Comments, order and spelling of all else stay.
import { type AST, getStaticTOMLValue, parseTOML } from "toml-eslint-parser";

/** From the root: "material", "clay", "cohesion"; numbers are items of arrays. */
export type Path = readonly (string | number)[];
type Range = readonly [begin: number, end: number];

interface Entry {
  value: Range;
  /** Key and value. */
  whole: Range;
  /** In braces, not on a line of its own. */
  inline: boolean;
}
/** A table with a header, or the root; or one in braces. */
interface Table {
  header: Range;
  /** Behind what stands last in it. */
  end: number;
  inline: boolean;
  empty: boolean;
}

const name_of = (path: Path) => JSON.stringify(path);
const bare = /^[A-Za-z0-9_-]+$/;
const written = (key: string | number) => (typeof key === "number" || bare.test(key) ? String(key) : JSON.stringify(key));

export class CaseText {
  /** null where the text is no TOML. */
  readonly value: Record<string, unknown> | null = null;
  private readonly entries = new Map<string, Entry>();
  private readonly tables = new Map<string, Table>();

  constructor(readonly text: string) {
    try {
      const ast = parseTOML(text);
      this.value = getStaticTOMLValue(ast) as Record<string, unknown>;
      this.read(ast);
    } catch {
      this.value = null;
    }
  }

  /** What stands at a path; undefined where nothing does. */
  at(path: Path): unknown {
    let found: unknown = this.value ?? undefined;
    for (const key of path) found = found === null || typeof found !== "object" ? undefined : (found as Record<string | number, unknown>)[key];
    return found;
  }

  /** As it is spelled: "20 mm" with its quotes. */
  spelled(path: Path): string | null {
    const entry = this.entries.get(name_of(path));
    return entry ? this.text.slice(...entry.value) : null;
  }

  /** The comment behind a value on its line; "" where there is none. */
  comment(path: Path): string {
    const entry = this.entries.get(name_of(path));
    if (!entry) return "";
    return /^[^\n]*?#\s*(.*)/.exec(this.text.slice(entry.whole[1], this.end_of_line(entry.whole[1])))?.[1].trim() ?? "";
  }

  /** The line of a path, from 1; of the nearest table where nothing stands there. */
  line(path: Path): number {
    for (let length = path.length; length > 0; length--) {
      const part = name_of(path.slice(0, length)), place = this.entries.get(part)?.whole ?? this.tables.get(part)?.header;
      if (place) return this.text.slice(0, place[0]).split("\n").length;
    }
    return 1;
  }

  /** The text with this value, as TOML spells it, at the path. */
  with(path: Path, literal: string): string {
    const entry = this.entries.get(name_of(path));
    if (entry) return this.text.slice(0, entry.value[0]) + literal + this.text.slice(entry.value[1]);
    for (let length = path.length - 1; length >= 0; length--) {
      const table = this.tables.get(name_of(path.slice(0, length)));
      if (!table || (length === 0 && path.length > 1)) continue;
      const line = `${path.slice(length).map(written).join(".")} = ${literal}`;
      if (table.inline) return this.insert(table.end, `${table.empty ? "" : ", "}${line}`);
      return this.insert(table.end, table.end === 0 ? `${line}\n` : `\n${line}`);
    }
    const header = path.slice(0, -1).map(written).join(".");
    return `${this.text.replace(/\n*$/, "\n")}\n[${header}]\n${written(path[path.length - 1])} = ${literal}\n`;
  }

  /** The text without the key. */
  without(path: Path): string {
    const entry = this.entries.get(name_of(path));
    if (!entry) return this.text;
    let [begin, end] = entry.whole;
    if (entry.inline) {
      const after = /^\s*,\s*/.exec(this.text.slice(end)), before = /,\s*$/.exec(this.text.slice(0, begin));
      if (after) end += after[0].length;
      else if (before) begin -= before[0].length;
    } else {
      begin = this.text.lastIndexOf("\n", begin - 1) + 1;
      const line = this.text.indexOf("\n", end);
      end = line < 0 ? this.text.length : line + 1;
    }
    return this.text.slice(0, begin) + this.text.slice(end);
  }

  private insert(at: number, words: string): string {
    return this.text.slice(0, at) + words + this.text.slice(at);
  }

  private read(ast: AST.TOMLProgram): void {
    const [root] = ast.body;
    const first = root.body.find((node) => node.type === "TOMLTable");
    const own = root.body.filter((node): node is AST.TOMLKeyValue => node.type === "TOMLKeyValue");
    const end = own.length > 0 ? this.end_of_line(own[own.length - 1].range[1]) : first ? this.before(first.range[0]) : this.text.replace(/\s*$/, "").length;
    this.tables.set(name_of([]), { header: [0, 0], end, inline: false, empty: own.length === 0 });
    for (const node of root.body)
      if (node.type === "TOMLKeyValue") this.read_pair(node, []);
      else this.read_table(node);
  }

  private read_table(table: AST.TOMLTable): void {
    const path = table.resolvedKey, last = table.body[table.body.length - 1];
    const end = this.end_of_line(last ? last.range[1] : table.key.range[1]);
    this.tables.set(name_of(path), { header: table.range, end, inline: false, empty: !last });
    for (const pair of table.body) this.read_pair(pair, path);
  }

  private read_pair(pair: AST.TOMLKeyValue, within: Path, inline = false): void {
    const path = [...within, ...pair.key.keys.map((key) => (key.type === "TOMLBare" ? key.name : key.value))], { value } = pair;
    this.entries.set(name_of(path), { value: value.range, whole: pair.range, inline });
    if (value.type === "TOMLInlineTable") {
      const last = value.body[value.body.length - 1];
      this.tables.set(name_of(path), { header: pair.range, end: last ? last.range[1] : value.range[0] + 1, inline: true, empty: !last });
      for (const each of value.body) this.read_pair(each, path, true);
    }
  }

  /** Where the line ends on which this stands: behind its comment. */
  private end_of_line(at: number): number {
    const end = this.text.indexOf("\n", at);
    return end < 0 ? this.text.length : end;
  }

  /** In front of the blank lines and comments above a header. */
  private before(at: number): number {
    let begin = this.text.lastIndexOf("\n", at - 1) + 1;
    for (;;) {
      const above = this.text.lastIndexOf("\n", begin - 2) + 1, line = this.text.slice(above, begin).trim();
      if (begin === 0 || (line !== "" && !line.startsWith("#"))) return begin;
      begin = above;
    }
  }
}
