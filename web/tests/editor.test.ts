// SPDX-License-Identifier: BSD-3-Clause
// The editor of cases in a browser: what it offers, explains and underlines.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import type { Browser, Page } from "playwright-core";
import type { Editor, EditorOptions, Finding } from "../src/editor/editor";
import { place_at } from "../src/editor/place";
import { keys_of, type Schema } from "../src/editor/schema";
import { from_environment, launch_browser } from "./browser";

declare global {
  interface Window {
    berm_editor: { createEditor(parent: HTMLElement, options: EditorOptions): Editor };
    editor: Editor;
    check(text: string): Promise<Finding[]>;
  }
}

const program = from_environment("BERM_PROGRAM");
const schema = JSON.parse(execFileSync(program, ["params", "--json-schema", "case"], { encoding: "utf8" })) as Schema;
const template = `title = "a pipe"
geometry = "plane_strain"
gravity = [0, "-1 gravity"]

[mesh]
kind = "box"
size = ["2 m", "1 m"]
cells = [20, 10]

[material.sand]
law = "mohr_coulomb"
density = "1800 kg/m^3"

[[stage]]
name = "push"
until = {embedment = "80 mm"}
`;

function keys_at(text: string): string[] {
  const lines = text.split("\n");
  const { table, words } = place_at(schema, lines, lines.length - 1, lines[lines.length - 1].length);
  return Object.keys(keys_of(table ?? {}, words));
}

test("keys_are_those_of_the_table_and_of_the_words_in_it", () => {
  assert.ok(keys_at("").includes("geometry"));
  const sand = keys_at(`${template}[material.clay]\nlaw = "clay"\n`);
  assert.ok(sand.includes("undrained_strength") && !sand.includes("friction_angle"), sand.join(" "));
  assert.ok(keys_at(`${template}[material.rock]\nlaw = "mohr_coulomb"\n`).includes("friction_angle"));
  assert.deepEqual(keys_at("[material.rock]\n"), ["law"]);
  assert.ok(keys_at(`${template}until = {`).includes("displacement"));
  assert.ok(keys_at(`${template}until.`).includes("displacement"));
  assert.ok(keys_at(`${template}[stage.until]\n`).includes("displacement"));
  assert.deepEqual(keys_at("[nothing]\n"), []);
});

let browser: Browser;
let page: Page;
const errors: string[] = [];

before(async () => {
  const web = dirname(dirname(fileURLToPath(import.meta.url)));
  const { outputFiles } = await build({
    entryPoints: [join(web, "src", "editor", "editor.ts")],
    bundle: true,
    write: false,
    format: "iife",
    globalName: "berm_editor",
    target: "es2022",
  });
  browser = await launch_browser();
  page = await browser.newPage();
  page.on("pageerror", (error) => errors.push(String(error)));
  await page.setContent('<!doctype html><div id="place"></div>');
  await page.addScriptTag({ content: outputFiles[0].text });
  await page.exposeFunction("check", (text: string) => {
    const { stdout } = spawnSync(program, ["check", "case.toml", "--json", "--stdin", "--threads", "1"], { input: text, encoding: "utf8" });
    return JSON.parse(stdout)[0].findings;
  });
});
after(async () => {
  await browser?.close();
  assert.deepEqual(errors, []);
});

/** The editor with this text and the cursor at its end. */
async function open(text: string): Promise<void> {
  await page.evaluate(
    ({ schema, text }) => {
      document.getElementById("place")?.replaceChildren();
      window.editor = window.berm_editor.createEditor(document.getElementById("place") as HTMLElement, { schema, text, check: window.check });
      window.editor.view.dispatch({ selection: { anchor: text.length } });
      window.editor.view.focus();
    },
    { schema, text },
  );
}

const text = () => page.evaluate(() => window.editor.text());

test("a_key_is_completed_with_its_default_and_a_word_from_its_list", async () => {
  await open(`${template}[material.clay]\nlaw = "clay"\n`);
  await page.keyboard.type("poiss");
  await page.locator(".cm-tooltip-autocomplete li", { hasText: "poisson_ratio" }).waitFor();
  await page.waitForTimeout(100); // CodeMirror takes no key that comes as the list opens
  await page.keyboard.press("Enter");
  assert.match(await text(), /\npoisson_ratio = $/);
  await open(template.replace('"mohr_coulomb"\n', '"linear_elastic"\n') + '[material.rock]\nlaw = "moh');
  await page.keyboard.type("r");
  await page.locator(".cm-tooltip-autocomplete li", { hasText: "mohr_coulomb" }).waitFor();
  await page.waitForTimeout(100);
  await page.keyboard.press("Enter");
  assert.match(await text(), /law = "mohr_coulomb"$/);
});

test("a_key_is_explained_under_the_pointer", async () => {
  await open(template);
  await page.locator(".cm-line", { hasText: "density" }).hover({ position: { x: 20, y: 5 } });
  const explained = await page.locator(".explanation").innerText();
  assert.match(explained, /mass per volume/);
  assert.match(explained, /unit: kg\/m\^3/);
});

test("what_check_finds_is_underlined", async () => {
  await open(template.replace("density =", "densty ="));
  const wrong = page.locator(".cm-lintRange-error");
  await wrong.waitFor();
  assert.equal(await wrong.innerText(), "densty");
});
