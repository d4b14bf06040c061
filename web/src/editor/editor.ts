// SPDX-License-Identifier: BSD-3-Clause
// An editor of cases: keys and words are completed and explained by the schema, and what `berm check --json` finds is underlined.
import { autocompletion, type Completion, type CompletionContext, type CompletionResult } from "@codemirror/autocomplete";
import { StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { toml } from "@codemirror/legacy-modes/mode/toml";
import { type Diagnostic, linter, lintGutter } from "@codemirror/lint";
import type { EditorState, Text } from "@codemirror/state";
import { EditorView, hoverTooltip } from "@codemirror/view";
import { classHighlighter } from "@lezer/highlight";
import { basicSetup } from "codemirror";
import { type Place, place_at } from "./place";
import { header_of, is_table, keys_of, type Schema, value_of } from "./schema";

/** What berm check finds, as its JSON has it. */
export interface Finding {
  level: "error" | "warning" | "note";
  /** From 1. */
  line: number | null;
  key: string | null;
  message: string;
  expected?: string[];
  nearest?: string;
}

export interface EditorOptions {
  /** `berm params --json-schema case`. */
  schema: Schema;
  text: string;
  onChange?: (text: string) => void;
  /** The findings of `berm check --json --stdin` of a text. */
  check?: (text: string) => Promise<Finding[]>;
}

export interface Editor {
  view: EditorView;
  text(): string;
  set_text(text: string): void;
  destroy(): void;
}

function place_of(schema: Schema, state: EditorState, position: number): Place {
  const line = state.doc.lineAt(position);
  return place_at(schema, state.doc.toJSON(), line.number - 1, position - line.from);
}

function completions_of_keys({ table, words }: Place): Completion[] {
  return Object.entries(keys_of(table ?? {}, words)).map(([key, schema]) => ({
    label: key,
    apply: `${key} = ${value_of(schema)}`,
    type: is_table(schema) ? "namespace" : "property",
    info: schema.description,
  }));
}

function completions_of_headers(schema: Schema): Completion[] {
  return Object.entries(keys_of(schema, new Map<string, string>()))
    .filter(([, table]) => is_table(table))
    .map(([key, table]) => ({ label: header_of(key, table), type: "namespace", info: table.description }));
}

function complete(schema: Schema, context: CompletionContext): CompletionResult | null {
  const begun = context.matchBefore(/[\w"\[]*/);
  if (!begun || (begun.from === begun.to && !context.explicit)) return null;
  if (begun.text.startsWith("[")) return { from: begun.from, options: completions_of_headers(schema) };
  const place = place_of(schema, context.state, context.pos);
  if (!place.in_value) return { from: begun.from, options: completions_of_keys(place) };
  const of_key = keys_of(place.table ?? {}, place.words)[place.key];
  const closes = context.state.sliceDoc(context.pos, context.pos + 1) === '"';
  const values = of_key?.enum?.map((word) => `"${word}"`) ?? (of_key?.type === "boolean" ? ["true", "false"] : []);
  const options = values.map((label) => ({ label, apply: closes ? label.slice(0, -1) : label, type: "enum" }));
  return { from: begun.from, options };
}

/** Meaning, unit, range and default of the key under the pointer. */
function explanation(schema: Schema) {
  return hoverTooltip((view, position) => {
    const line = view.state.doc.lineAt(position);
    const equals = line.text.indexOf("=");
    const at = equals < 0 || /^\s*\[/.test(line.text) ? position : Math.min(position, line.from + equals);
    const { table, words, key } = place_of(schema, view.state, at);
    const text = keys_of(table ?? {}, words)[key]?.description;
    if (!text) return null;
    const dom = document.createElement("div");
    dom.className = "explanation";
    dom.style.whiteSpace = "pre-line";
    dom.textContent = text;
    return { pos: position, create: () => ({ dom }) };
  });
}

/** The line of a finding, or the key in it. */
function diagnostic(doc: Text, { level, line, key, message }: Finding): Diagnostic {
  const found = doc.line(Math.min(Math.max(line ?? 1, 1), doc.lines));
  const last = key?.split(".").pop() ?? "";
  const at = last ? found.text.indexOf(last) : -1;
  const from = at < 0 ? found.from : found.from + at;
  return { from, to: at < 0 ? found.to : from + last.length, severity: level === "note" ? "info" : level, message: key ? `${key}: ${message}` : message };
}

export function createEditor(parent: HTMLElement, { schema, text, onChange, check }: EditorOptions): Editor {
  const findings = async (view: EditorView): Promise<Diagnostic[]> => {
    const { doc } = view.state;
    const found = check ? await check(doc.toString()) : [];
    return found.filter(({ level }) => level !== "note").map((finding) => diagnostic(doc, finding));
  };
  const view = new EditorView({
    parent,
    doc: text,
    extensions: [
      basicSetup,
      // Of a page that allows no other styles.
      EditorView.cspNonce.of(document.querySelector<HTMLElement>("[nonce]")?.nonce ?? ""),
      StreamLanguage.define(toml),
      syntaxHighlighting(classHighlighter),
      autocompletion({ override: [(context) => complete(schema, context)] }),
      explanation(schema),
      lintGutter(),
      linter(findings, { delay: 500 }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) onChange?.(update.state.doc.toString());
      }),
    ],
  });
  return {
    view,
    text: () => view.state.doc.toString(),
    set_text: (new_text) => view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: new_text } }),
    destroy: () => view.destroy(),
  };
}
