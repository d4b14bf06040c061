// SPDX-License-Identifier: BSD-3-Clause
// The schemas that `berm params --json-schema` prints: the examples fit them, for a validator and for the program that editors check TOML with; wrong inputs do not.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import Ajv from "ajv-draft-04";
import { getStaticTOMLValue, parseTOML } from "toml-eslint-parser";
import { from_environment } from "./browser";

const program = from_environment("BERM_PROGRAM");
const source = from_environment("BERM_SOURCE");
const folder = mkdtempSync(join(tmpdir(), "berm-schema-"));
after(() => rmSync(folder, { recursive: true, force: true }));

const kinds = ["case", "element", "fit", "cyclic", "sea", "route", "study", "expected"] as const;
type Kind = (typeof kinds)[number];
const at_least: Record<Kind, number> = { case: 100, element: 2, fit: 2, cyclic: 2, sea: 1, route: 1, study: 3, expected: 50 };

const schema_files = Object.fromEntries(
  kinds.map((kind) => {
    const file = join(folder, `${kind}.schema.json`);
    writeFileSync(file, execFileSync(program, ["params", "--json-schema", kind]));
    return [kind, file];
  }),
) as Record<Kind, string>;

function validator(kind: Kind) {
  const ajv = new Ajv({ allErrors: true, strict: true, strictTypes: false, allowUnionTypes: true, keywords: ["x-unit"] });
  return ajv.compile(JSON.parse(readFileSync(schema_files[kind], "utf8")));
}

const value_of = (text: string): unknown => getStaticTOMLValue(parseTOML(text));

/** The inputs among the examples. */
function examples(): Record<Kind, string[]> {
  const found: Record<Kind, string[]> = { case: [], element: [], fit: [], cyclic: [], sea: [], route: [], study: [], expected: [] };
  for (const name of readdirSync(join(source, "examples"), { recursive: true }) as string[]) {
    if (!name.endsWith(".toml")) continue;
    const file = join(source, "examples", name), text = readFileSync(file, "utf8");
    const has = (table: string) => text.includes(`\n${table}`);
    found[name.endsWith("expected.toml") ? "expected" : has("[[test]]") ? "element" : has("[[measured]]") ? "fit" : has("[storm]") ? "cyclic" : has("[sea]") ? "sea" : has("[[section]]") ? "route" : has("[[case]]") ? "study" : "case"].push(file);
  }
  return found;
}

for (const kind of kinds) {
  test(`the_examples_fit_the_schema_of_${kind}`, () => {
    const fits = validator(kind);
    const files = examples()[kind];
    assert.ok(files.length >= at_least[kind], `${files.length} examples`);
    const wrong = files.filter((file) => !fits(value_of(readFileSync(file, "utf8")))).map((file) => `${file}: ${JSON.stringify(fits.errors?.slice(0, 3))}`);
    assert.deepEqual(wrong, []);
  });
}

const taplo = join(dirname(dirname(fileURLToPath(import.meta.url))), "node_modules", "@taplo", "cli", "dist", "cli.js");

/** Of the program that editors check TOML with, which takes ten seconds of processor time to start. */
function lint(files: string[], rules = "") {
  const config = join(folder, "taplo.toml");
  writeFileSync(config, rules);
  const arguments_ = ["lint", ...(rules ? ["--config", config] : ["--no-auto-config"]), ...files];
  return spawnSync(process.execPath, [taplo, ...arguments_], { cwd: folder, encoding: "utf8" });
}

test("taplo_takes_the_examples_by_the_schema", () => {
  const found = examples();
  const rule = (kind: Kind, files: string[]) => `[[rule]]\ninclude = ${JSON.stringify(files)}\nschema = { url = "${pathToFileURL(schema_files[kind]).href}" }\n`;
  const { status, stderr } = lint(kinds.flatMap((kind) => found[kind]), kinds.map((kind) => rule(kind, found[kind])).join(""));
  assert.equal(status, 0, stderr.slice(0, 2000));
});

test("new_cases_of_all_kinds_fit_the_schema_and_taplo_finds_it_by_their_first_line", () => {
  const fits = validator("case");
  const new_kinds = (JSON.parse(execFileSync(program, ["new", "--json"], { encoding: "utf8" })) as { kind: string }[]).map(({ kind }) => kind);
  assert.ok(new_kinds.length >= 10, `${new_kinds.length} kinds`);
  const files = new_kinds.map((kind) => {
    const file = join(folder, `${kind}.toml`);
    execFileSync(program, ["new", kind, file], { stdio: "ignore" });
    const text = readFileSync(file, "utf8");
    assert.match(text, /^#:schema file:\/\/.*\/berm\/case\.schema\.json\n/);
    assert.ok(fits(value_of(text)), `${kind}: ${JSON.stringify(fits.errors?.slice(0, 3))}`);
    return file;
  });
  const taken = lint(files);
  assert.equal(taken.status, 0, taken.stderr.slice(0, 2000));
  writeFileSync(files[0], readFileSync(files[0], "utf8").replace(/^gravity\b/m, "gravty"));
  const refused = lint([files[0]]);
  assert.notEqual(refused.status, 0);
  assert.match(refused.stderr, /gravty/);
});

// What a schema cannot see: units of another dimension, numbers in texts that are out of range, names that nothing has, and keys that depend on values or on other tables.
test("the_schema_refuses_wrong_keys_words_and_types", () => {
  const fits = validator("case");
  const all = JSON.parse(execFileSync(from_environment("BERM_WRONG_INPUTS"), { encoding: "utf8" })) as Record<string, string>;
  const passed = Object.keys(all).filter((name) => {
    try {
      return fits(value_of(all[name]));
    } catch {
      return false; // no TOML
    }
  });
  const seen = Object.keys(all).filter((name) => !passed.includes(name));
  assert.deepEqual(passed.filter((name) => /misspelt|unknown_(word|law)|key_(without|of|twice)|(truth|number|text|date|list)_for_a/.test(name)), []);
  assert.ok(seen.length >= 46, `not: ${passed.join(", ")}`);
});
