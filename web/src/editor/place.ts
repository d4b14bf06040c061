// SPDX-License-Identifier: BSD-3-Clause
// Where a cursor stands in a text of TOML that need not be whole: editors ask while one types.
import { below, type Schema, type Words } from "./schema";

export interface Place {
  /** The table that the cursor is in, by the schema; undefined where that has no such table. */
  table: Schema | undefined;
  words: Words;
  /** The key of the line, without the tables that it goes through; "" where there is none yet. */
  key: string;
  /** Whether the cursor is behind the key's equals sign. */
  in_value: boolean;
}

const header = /^\s*(\[\[?)\s*([^\]#]*?)\s*\]/;
const setting = /^\s*([\w.\-"]+)\s*=\s*(.*)$/;
const word = /^"([^"]*)"/;

function parts(path: string): string[] {
  return path.split(".").map((part) => part.trim().replace(/^"(.*)"$/, "$1"));
}

/** The words of each table, by its path; a [[table]] begins anew, with all below it. */
class Tables {
  private readonly all = new Map<string, Map<string, string>>();

  begin(path: string): void {
    for (const other of [...this.all.keys()]) if (other === path || other.startsWith(`${path}.`)) this.all.delete(other);
  }
  words(path: string): Map<string, string> {
    let found = this.all.get(path);
    if (!found) this.all.set(path, (found = new Map<string, string>()));
    return found;
  }
  set(section: string, key: string, value: string): void {
    const all = parts(key);
    const last = all.pop() as string;
    const text = word.exec(value);
    if (text) this.words([...(section ? [section] : []), ...all].join(".")).set(last, text[1]);
  }
}

/** The keys before the cursor that open an inline table which is not closed yet: ["until"] of `until = {embedment = `. */
function open_tables(value: string): { keys: string[]; rest: string } {
  const keys: string[] = [];
  let rest = value;
  for (let at = 0; at < value.length; ++at) {
    if (value[at] === '"') at = Math.max(at, value.indexOf('"', at + 1));
    else if (value[at] === "{") keys.push(/([\w.\-]+)\s*=\s*$/.exec(value.slice(0, at))?.[1] ?? "");
    else if (value[at] === "}") keys.pop();
    if (value[at] === "{" || (value[at] === "," && keys.length > 0)) rest = value.slice(at + 1);
  }
  return { keys, rest };
}

/** The place of the cursor in column `column` of line `line`, both from 0. */
export function place_at(schema: Schema, lines: readonly string[], line: number, column: number): Place {
  const tables = new Tables();
  let section = "";
  for (let k = 0; k < lines.length; ++k) {
    const found = header.exec(lines[k]);
    if (found && k > line) break;
    if (found) {
      section = parts(found[2]).join(".");
      if (found[1] === "[[") tables.begin(section);
    }
    const set = setting.exec(lines[k]);
    if (set && !found) tables.set(section, set[1], set[2]);
  }
  const { keys, rest } = open_tables(lines[line].slice(0, column));
  const equals = rest.indexOf("=");
  const whole = /[\w.\-"]*/.exec(lines[line].slice(column))?.[0] ?? "";
  const path = [...(section ? section.split(".") : []), ...keys.flatMap(parts)];
  const typed = parts(equals < 0 ? rest + whole : rest.slice(0, equals));
  const key = typed.pop() as string;
  path.push(...typed);

  let table: Schema | undefined = schema;
  let at: string[] = [];
  for (const part of path) {
    table = table && below(table, tables.words(at.join(".")), part);
    at = [...at, part];
  }
  return { table, words: tables.words(path.join(".")), key, in_value: equals >= 0 };
}
