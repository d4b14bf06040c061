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

/** A line that is commented out, with a comment of its own: a key that was cleared. */
interface Cleared {
  line: Range;
  comment: string;
  /** As it was spelled. */
  value: string;
  /** Of its comment, on the line of the key that is set. */
  column: number;
}
const cleared_line = /^[ \t]*#[ \t]*([A-Za-z0-9_-]+(?:\.[A-Za-z0-9_-]+)*)[ \t]*=[ \t]*([^#\n]+)#[ \t]*(.+)$/;

const name_of = (path: Path) => JSON.stringify(path);
const bare = /^[A-Za-z0-9_-]+$/;
const written = (key: string | number) => (typeof key === "number" || bare.test(key) ? String(key) : JSON.stringify(key));

export class CaseText {
  /** null where the text is no TOML. */
  readonly value: Record<string, unknown> | null = null;
  private readonly entries = new Map<string, Entry>();
  private readonly tables = new Map<string, Table>();
  private readonly cleared = new Map<string, Cleared>();

  constructor(readonly text: string) {
    try {
      const ast = parseTOML(text);
      this.value = getStaticTOMLValue(ast) as Record<string, unknown>;
      this.read(ast);
      this.read_cleared(ast);
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

  /** As a key that was cleared was spelled. */
  former(path: Path): string | null {
    return this.cleared.get(name_of(path))?.value ?? null;
  }

  /** The comment behind a value on its line, or behind the line of a key that was cleared; "" where there is none. */
  comment(path: Path): string {
    const entry = this.entries.get(name_of(path));
    if (!entry) return this.cleared.get(name_of(path))?.comment ?? "";
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
    const cleared = this.cleared.get(name_of(path));
    if (cleared) {
      const key = /^[ \t]*#[ \t]*([^=]*=)/.exec(this.text.slice(...cleared.line))![1], value = `${key} ${literal}`.padEnd(cleared.column - 1);
      return `${this.text.slice(0, cleared.line[0])}${value} # ${cleared.comment}${this.text.slice(cleared.line[1])}`;
    }
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

  /** The text with this comment behind the value of a key, "": with none. */
  with_comment(path: Path, comment: string): string {
    const entry = this.entries.get(name_of(path));
    if (!entry || entry.inline) return this.text;
    const end = this.end_of_line(entry.whole[1]), gap = /^[ \t]*/.exec(this.text.slice(entry.whole[1], end))![0];
    return this.text.slice(0, entry.whole[1]) + (comment === "" ? "" : `${gap || "  "}# ${comment}`) + this.text.slice(end);
  }

  /** The text without the key. One with a comment is commented out with it, so that it can be set again. */
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
      const whole = this.text.slice(begin, this.end_of_line(end));
      if (!whole.includes("\n") && cleared_line.test(`# ${whole}`)) return `${this.text.slice(0, begin)}# ${this.text.slice(begin)}`;
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

  /** Lines are those of the table whose header stands above them. */
  private read_cleared(ast: AST.TOMLProgram): void {
    const headers = ast.body[0].body.filter((node): node is AST.TOMLTable => node.type === "TOMLTable"), comments = ast.comments;
    for (const { range } of comments) {
      const begin = this.text.lastIndexOf("\n", range[0] - 1) + 1, end = this.end_of_line(range[0]), found = cleared_line.exec(this.text.slice(begin, end));
      if (!found) continue;
      const table = headers.filter((each) => each.range[0] < begin).pop();
      const path = name_of([...(table?.resolvedKey ?? []), ...found[1].split(".")]);
      if (!this.entries.has(path)) this.cleared.set(path, { line: [begin, end], value: found[2].trim(), comment: found[3].trim(), column: found[0].length - found[3].length - "# ".length - "# ".length });
    }
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
