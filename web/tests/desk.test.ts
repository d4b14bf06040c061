// SPDX-License-Identifier: BSD-3-Clause
// A job at the desk, from a case to springs, in a browser: a form that changes the text, a run that grows, stops and goes on, two runs compared, springs, a printed page.
import assert from "node:assert/strict";
import { type ChildProcess, spawn } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { from_environment, launch_browser, take_screenshot } from "./browser";

const scratch = mkdtempSync(join(tmpdir(), "berm desk ")), folder = join(scratch, "site a"), downloads = mkdtempSync(join(tmpdir(), "berm downloads ")), program = from_environment("BERM_PROGRAM");
let browser: Browser, desk: ChildProcess, address = "", page: Page;
const errors: string[] = [];

before(async () => {
  browser = await launch_browser(downloads);
  mkdirSync(folder);
  copyFileSync(from_environment("BERM_CASE"), join(folder, "pipe.toml"));
  desk = spawn(program, ["desk", folder, "--no-browser", "--threads", "2"], { stdio: ["ignore", "pipe", "inherit"] });
  address = await new Promise((found) => {
    let text = "";
    desk.stdout!.on("data", (part) => {
      text += String(part);
      const line = /http:\/\/\S+/.exec(text);
      if (line) found(line[0]);
    });
  });
  const context = await browser.newContext({ viewport: { width: 1280, height: 860 }, acceptDownloads: true });
  context.setDefaultTimeout(240_000);
  page = await context.newPage();
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("dialog", (dialog) => void dialog.accept());
});
after(async () => {
  await browser?.close();
  if (desk) {
    const ended = new Promise((end) => desk.once("exit", end));
    desk.kill("SIGINT");
    await ended;
  }
  rmSync(downloads, { recursive: true, force: true });
  rmSync(scratch, { recursive: true, force: true });
});

const go = (hash: string) => page.goto(`${address.split("#")[0]}#${hash}`);
const badge = (word: string) => page.locator(`.run_head .badge.${word}`);

/** What a click downloads: the next file in the folder of downloads, once it no longer grows. Firefox tells nobody of downloads of what a page made itself. */
async function downloaded(click: () => Promise<unknown>): Promise<Buffer> {
  const before_it = new Set(readdirSync(downloads));
  await click();
  for (let waited = 0, size = -1; waited < 120_000; waited += 250) {
    await page.waitForTimeout(250);
    const found = readdirSync(downloads).find((name) => !before_it.has(name) && !name.endsWith(".part")), bytes = found ? readFileSync(join(downloads, found)) : Buffer.alloc(0);
    if (bytes.length > 0 && bytes.length === size) return bytes;
    size = bytes.length;
  }
  throw new Error("nothing was downloaded");
}

/** Presses Tab until the focus is on something of that name, which must show it. */
async function tab_to(name: RegExp): Promise<void> {
  for (let pressed = 0; pressed < 120; ++pressed) {
    await page.keyboard.press("Tab");
    const [here, outline] = await page.evaluate(() => {
      const face = document.activeElement as HTMLElement, labels = (face as HTMLInputElement).labels;
      return [face.getAttribute("aria-label") ?? labels?.[0]?.textContent ?? face.textContent ?? "", getComputedStyle(face).outlineStyle];
    });
    if (!name.test(here)) continue;
    assert.notEqual(outline, "none", `the focus on ${here} is in sight`);
    return;
  }
  throw new Error(`Tab does not reach ${name}`);
}

const rows = async () => (existsSync(join(folder, "out/pipe/history.csv")) ? readFileSync(join(folder, "out/pipe/history.csv"), "utf8").split("\n").length : 0);

test("the_token_leaves_the_address_and_a_page_without_it_shows_nothing", async () => {
  await page.goto(address);
  await page.locator(".folder_list a", { hasText: "pipe.toml" }).waitFor();
  assert.ok(!page.url().includes(address.split("#")[1]));
  const stranger = await (await browser.newContext()).newPage();
  await stranger.goto(address.split("#")[0]);
  await stranger.getByText("lacks its token").waitFor();
  await stranger.close();
});

test("a_field_changes_the_text_and_the_text_the_field", async () => {
  await go("/case?path=pipe.toml");
  await page.locator(".findings li").first().waitFor();
  await page.locator(".model img").waitFor();
  await page.locator('[data-path="stage.drag"] > summary').click();
  const field = page.locator('[data-key="stage.drag.until.displacement"]');
  await field.locator("input").fill("20");
  await field.locator("input").blur();
  await page.waitForFunction(() => document.querySelector(".cm-content")!.textContent!.includes('until.displacement = "20 mm"'));
  await field.locator("select").selectOption("m");
  await page.waitForFunction(() => document.querySelector(".cm-content")!.textContent!.includes('until.displacement = "0.02 m"'));
  // Some ten seconds of a fast processor: it must not end before it is stopped.
  await page.locator('[data-key="stage.drag.velocity"] input').fill("0.05");
  await page.locator('[data-key="stage.drag.velocity"] input').blur();
  await page.keyboard.press("Control+s");
  await page.getByText("saved", { exact: true }).waitFor();
  assert.match(readFileSync(join(folder, "pipe.toml"), "utf8"), /# A pipe on sand/, "comments stay");
});

test("a_wrong_value_is_found_and_a_click_goes_to_its_field", async () => {
  const field = page.locator('[data-key="material.sand.poisson_ratio"]');
  await field.locator("input").fill("0.7");
  await field.locator("input").blur();
  const finding = page.locator(".finding.error", { hasText: "poisson_ratio" });
  await finding.waitFor();
  assert.ok(await page.getByRole("button", { name: "Run", exact: true }).isDisabled());
  await finding.click();
  assert.equal(await page.evaluate(() => document.activeElement!.closest<HTMLElement>("[data-key]")?.dataset.key), "material.sand.poisson_ratio");
  await field.locator("input").fill("0.25");
  await field.locator("input").blur();
  await page.locator(".finding.error").waitFor({ state: "detached" });
});

test("a_run_grows_stops_and_goes_on", async () => {
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await badge("running").waitFor();
  await page.locator(".live_chart canvas").first().waitFor();
  const before_it = await rows();
  for (let waited = 0; (await rows()) <= before_it; waited += 100) {
    assert.ok(waited < 60_000, "the history grows");
    await page.waitForTimeout(100);
  }
  await page.getByRole("button", { name: "Stop" }).click();
  await badge("stopped").waitFor();
  const stopped = await rows();
  await page.getByRole("button", { name: "Resume" }).click();
  await badge("finished").waitFor();
  assert.ok((await rows()) > stopped);
  await page.locator(".answer td.number").first().waitFor();
  await page.locator(".soil_picture figcaption", { hasText: "frame" }).waitFor();
  await take_screenshot(page, "desk_run");
});

/** A run as the server could have it, in place of its answer. */
async function shows(run: Record<string, unknown>): Promise<void> {
  const answer = { path: "out/pipe", case: "", progress: 0.1, time_left_s: 10, began_here: true, can_resume: false, of: "1", from_row: 0, rows: [], more: false, log_tail: "", ...run };
  await page.unroute("**/api/run?*");
  await page.route("**/api/run?*", (route) => route.fulfill({ json: answer }));
  await go("/runs");
  await go("/run?path=out%2Fpipe");
}

const columns = [["time_s", "time", "s"], ["stage", "stage", null], ["u_m", "u", "m"], ["w_m", "w", "m"], ["H_N_m", "H", "N/m"], ["V_N_m", "V", "N/m"]].map(([name, label, unit]) => ({ name, label, unit, meaning: "" }));

test("curves_are_drawn_while_a_body_does_not_move_yet", async () => {
  const seen = errors.length, w = -0.025;
  const rows_of_w = (values: number[]) => values.map((value, k) => [0.01 * k, "rest", 0, value, 0, 0]);
  for (const values of [[w], [w, w, w], [w, w + 4e-18, w], [0, 0]]) {
    await shows({ status: "running", columns, rows: rows_of_w(values) });
    await page.waitForFunction(() => document.querySelectorAll(".live_chart canvas").length === 3);
    await page.waitForTimeout(300);
    assert.deepEqual(errors.slice(seen), [], `w ${values}`);
  }
  await page.unroute("**/api/run?*");
});

test("a_run_that_died_says_why_and_offers_no_more_than_makes_sense", async () => {
  const quantity = (value: number, of: string) => ({ value, unit: "N/m", meaning: "a force", kind: "answer", of });
  const summary = { quantities: { V_lay: quantity(1, "lay"), H_drag: quantity(2, "drag") } }, rows = [[0, "lay", 0, 0, 0, 0], [1, "drag", 0.1, 0, 0, 0]];
  await shows({ status: "failed", columns, rows, summary, why: "the pipe leaves the mesh" });
  await page.getByText("the pipe leaves the mesh").waitFor();
  await page.locator("tr.cut", { hasText: "H_drag" }).getByText("drag did not end").waitFor();
  assert.equal(await page.locator("tr.cut").count(), 1);
  assert.equal(await page.getByRole("button", { name: "Resume" }).count(), 0);
  await shows({ status: "stopped", columns, rows, summary, why: "stopped at t = 1 s", can_resume: true });
  await page.getByRole("button", { name: "Resume" }).waitFor();
  await page.unroute("**/api/run?*");
});

test("what_a_template_marks_comes_first_and_in_words", async () => {
  await go("/");
  await page.locator(".card", { hasText: "Pipe in clay" }).click();
  await page.locator("#new-file").fill("marked.toml");
  await page.getByRole("button", { name: "Create" }).click();
  const first = page.locator(".form > section.to_set").nth(1);
  await first.getByText("Site and soil").waitFor();
  const field = first.locator('[data-key="material.clay.undrained_strength"]');
  assert.equal(await field.locator("label").textContent(), "Undrained strengths_u at the seabed");
  assert.equal(await page.locator('[data-key="material.clay.undrained_strength"]').count(), 1, "it stands once");
  await field.locator("input").fill("3");
  await field.locator("input").blur();
  await page.waitForFunction(() => document.querySelector(".cm-content")!.textContent!.includes('undrained_strength = "3 kPa"'));
  await page.locator(".findings li").first().waitFor();
  await page.locator(".model img").waitFor();
  await take_screenshot(page, "desk_case");
  const groups = await page.locator(".form > details.group").evaluateAll((all) => all.map((each) => (each as HTMLElement).dataset.path));
  assert.ok(groups.indexOf("mesh") > groups.indexOf("material.clay") && groups.indexOf("mesh") > groups.indexOf("stage.lay"), groups.join(" "));
  await page.keyboard.press("Control+s");
  await page.getByText("saved", { exact: true }).waitFor();
});

test("a_field_that_is_cleared_stays_and_low_and_high_go_to_the_study", async () => {
  const line = (words: string) => page.waitForFunction((wanted) => [...document.querySelectorAll(".cm-line")].some((each) => each.textContent!.replaceAll(/ +/g, " ").includes(wanted)), words);
  const field = page.locator('.to_set [data-key="material.clay.undrained_strength_gradient"]');
  for (const [typed, wanted] of [["", '# undrained_strength_gradient = "1.5 kPa/m" # <- and'], ["1.2", 'undrained_strength_gradient = "1.2 kPa/m" # <- and']]) {
    await field.locator("input").first().fill(typed);
    await field.locator("input").first().blur();
    await line(wanted);
    assert.equal(await field.count(), 1);
  }
  await page.getByRole("button", { name: "low and high of Undrained strength", exact: true }).click();
  for (const [side, value] of [["low", "2"], ["high", "4,5"]]) {
    await page.getByLabel(`${side} Undrained strength`, { exact: true }).fill(value);
    await page.getByLabel(`${side} Undrained strength`, { exact: true }).blur();
  }
  await line("low 2 kPa, high 4.5 kPa");
  await page.keyboard.press("Control+s");
  await page.getByText("saved", { exact: true }).waitFor();
  const now = { path: "out/marked", case: "marked.toml", status: "finished", answer: { name: "H_max", value: 1, unit: "N/m" }, summary: { quantities: Object.fromEntries(["w_end", "H_max"].map((name) => [name, { value: 1, unit: "N/m", meaning: "", kind: "answer" }])) } };
  await page.route("**/api/run?*", (route) => route.fulfill({ json: now }));
  await go("/vary?path=out%2Fmarked");
  assert.equal(await page.getByLabel("high of material.clay.undrained_strength", { exact: true }).inputValue(), "4.5 kPa");
  assert.deepEqual(await page.locator(".vary input:checked").evaluateAll((all) => all.map((each) => each.getAttribute("aria-label") ?? each.closest("label")!.textContent!.trim().split(" ")[0])), ["vary material.clay.undrained_strength", "H_max"]);
  await page.unroute("**/api/run?*");
});

test("a_sounding_gives_a_new_case_its_strength", async () => {
  await go("/");
  await page.locator(".card", { hasText: "Pipe in clay" }).click();
  await page.locator("#new-file").fill("sounding.toml");
  let table = "depth_m,q_t_MPa\n";
  for (let z = 0.1; z < 4; z += 0.1) table += `${z.toFixed(2)},${((16 * z + 14 * (3 + 1.5 * z)) / 1000).toFixed(5)}\n`;
  await page.locator("#new-cpt").setInputFiles({ name: "kp12.csv", mimeType: "text/csv", buffer: Buffer.from("depth_m,q_t_MPa\n1,two\n") });
  await page.getByRole("button", { name: "Create" }).click();
  await page.locator("dialog .bad", { hasText: "kp12.csv" }).waitFor();
  await page.locator("#new-cpt").setInputFiles({ name: "kp12.csv", mimeType: "text/csv", buffer: Buffer.from(table) });
  await page.getByRole("button", { name: "Create" }).click();
  await page.locator(".findings li").first().waitFor();
  assert.match(readFileSync(join(folder, "sounding.toml"), "utf8"), /kp12\.csv/);
});

test("a_run_has_a_sentence_another_name_and_notes", async () => {
  const path = "out/pipe";
  await go(`/run?path=${encodeURIComponent(path)}`);
  await page.locator(".sentence", { hasText: "the pipe" }).waitFor();
  await go("/runs");
  for (const [name, notes, shown] of [["named", "cells too coarse", "out/named"], ["pipe", "", path]]) {
    const before = name === "named" ? path : "out/named";
    await page.getByRole("button", { name: `name and notes of ${before}`, exact: true }).click();
    await page.locator("#run-name").fill(name);
    await page.locator("#run-notes").fill(notes);
    await page.getByRole("button", { name: "Save", exact: true }).click();
    await page.locator(".runs_view a", { hasText: shown }).first().waitFor();
    assert.equal(await page.locator(".runs_view .notes:not(.quiet)").count(), notes ? 1 : 0);
    assert.equal(existsSync(join(folder, shown, "notes.txt")), notes !== "");
  }
});

test("an_invalid_run_has_no_sentence", async () => {
  const file = join(folder, "out/pipe/summary.json"), valid = readFileSync(file, "utf8");
  writeFileSync(file, JSON.stringify({ ...JSON.parse(valid), invalid: ["the soil at the pipe lost its strength"] }));
  await go("/run?path=out%2Fpipe");
  await page.locator(".bad", { hasText: "Do not use the results of this run: the soil at the pipe lost its strength." }).waitFor();
  assert.equal(await page.locator(".sentence").isVisible(), false);
  writeFileSync(file, valid);
});

test("two_runs_are_compared_and_springs_are_written", async () => {
  await go("/case?path=pipe.toml");
  await page.locator('[data-path="material.sand"] > summary').waitFor();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await badge("finished").waitFor();
  await go("/runs");
  for (const path of ["out/pipe", "out/pipe_2"]) await page.getByRole("checkbox", { name: `choose ${path}`, exact: true }).check();
  await page.getByRole("button", { name: "Compare" }).click();
  const frame = page.frameLocator("iframe.page_frame");
  await frame.locator("#answer").waitFor({ state: "attached" });
  await go("/export?path=out%2Fpipe");
  await page.getByRole("button", { name: "Export" }).click();
  const file = page.locator("button.file").first();
  await file.waitFor();
  assert.ok((await downloaded(() => file.click())).length > 0);
});

test("warnings_of_an_export_are_shown", async () => {
  await page.route("**/api/export", (route) => route.fulfill({ json: { files: ["out/pipe/export/springs.csv", "out/pipe/export/plots/springs.gp"], warnings: ["pipe: there is no lateral spring"] } }));
  await page.getByRole("button", { name: "Export", exact: true }).click();
  await page.locator("p.fair", { hasText: "there is no lateral spring" }).waitFor();
  assert.equal(await page.locator("button.file").count(), 1, "files of gnuplot are not offered");
  await page.unroute("**/api/export");
});

test("a_study_of_low_and_high_values_shows_its_table_and_tornado", async () => {
  await go("/run?path=out%2Fpipe_2");
  await page.getByRole("button", { name: "Low, best, high …" }).click();
  await page.getByLabel("vary material.sand.friction_angle").check();
  await page.locator("#sample").fill("3");
  await page.getByText("6 runs of the case.").waitFor();
  await page.getByRole("button", { name: "Run the study" }).click();
  await page.locator("h3", { hasText: "All runs" }).waitFor();
  for (const words of ["Low, best and high estimate", "Sensitivity"]) await page.locator("h3", { hasText: words }).waitFor();
  await page.locator(".picture img[alt^=Tornado]").first().waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll<HTMLImageElement>(".picture img")].every((image) => image.naturalWidth > 100));
  await go("/case?path=pipe_study.toml");
  await page.getByRole("button", { name: "Run the study" }).waitFor();
  await page.locator('[data-key="sample.size"] input').waitFor({ state: "attached" });
});

// Firefox without a screen draws no ring around what has the focus, and gives a PDF that a page fetched to nobody.
const in_chromium = { skip: process.env.BERM_BROWSER === "firefox" };

test("the_keyboard_is_enough", in_chromium, async () => {
  await page.bringToFront(); // no other window has the focus
  await go("/");
  await page.locator(".card").first().waitFor();
  await tab_to(/^Pipe in sand/);
  await page.keyboard.press("Enter");
  await page.locator("#new-file").waitFor();
  await page.keyboard.type("typed");
  await tab_to(/^Create$/);
  await page.keyboard.press("Enter");
  await page.locator(".finding, .findings .good").first().waitFor();
  await tab_to(/^Title$/);
  await page.keyboard.press("Control+a");
  await page.keyboard.type("Typed");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".cm-content")!.textContent!.includes('"Typed"'));
  await page.keyboard.press("Control+Enter");
  await badge("running").waitFor();
  await tab_to(/^Stop$/);
  await page.keyboard.press("Enter");
  await badge("stopped").waitFor();
  await tab_to(/^Report$/);
  await page.keyboard.press("Escape");
  await page.keyboard.press("g");
  await page.keyboard.press("r");
  await page.locator(".runs_view a", { hasText: "out/typed" }).waitFor();
  await tab_to(/^out\/typed$/);
  await page.keyboard.press("Enter");
  await page.locator(".run_view").waitFor();
});

test("a_tablet_shows_form_or_text_and_cuts_nothing_off", async () => {
  await page.setViewportSize({ width: 820, height: 1180 });
  for (const place of ["/", "/case?path=pipe.toml", "/run?path=out%2Fpipe", "/runs", "/vary?path=out%2Fpipe_2"]) {
    await go(place);
    await page.locator("main :is(.files, .finding, .badge, .vary)").first().waitFor();
    const beyond = await page.evaluate(() => [...document.querySelectorAll<HTMLElement>("header *, main :is(button, input, select, canvas, img, p, h2, h3)")].filter((face) => face.getBoundingClientRect().right > innerWidth + 1 && !face.closest(".cm-editor, .scrolls")).map((face) => face.outerHTML.slice(0, 80)));
    assert.deepEqual(beyond, [], place);
  }
  await go("/case?path=pipe.toml");
  await page.locator(".form_pane").waitFor();
  assert.ok(!(await page.locator(".text_pane").isVisible()));
  await page.getByRole("button", { name: "Text", exact: true }).click();
  await page.locator(".text_pane").waitFor();
  assert.ok(!(await page.locator(".form_pane").isVisible()));
  await page.setViewportSize({ width: 1280, height: 860 });
});

test("a_page_is_printed", in_chromium, async () => {
  await go("/run?path=out%2Fpipe");
  await badge("finished").waitFor();
  const pdf = await downloaded(() => page.getByRole("button", { name: "PDF" }).click());
  assert.equal(pdf.subarray(0, 5).toString(), "%PDF-");
  assert.deepEqual(errors, []);
});

test("a_run_is_deleted_once_that_is_confirmed_and_two_pages_of_runs_stand_side_by_side", in_chromium, async () => {
  assert.ok(existsSync(join(folder, "out/compared.html")));
  await go("/compare?path=out%2Fpipe&path=out%2Fpipe_2");
  await page.frameLocator("iframe.page_frame").locator("#answer").waitFor({ state: "attached" });
  assert.ok(existsSync(join(folder, "out/compared_2.html")));
  await go("/runs");
  await page.getByRole("button", { name: "delete out/typed", exact: true }).click();
  await page.locator(".runs_view a", { hasText: "out/typed" }).waitFor({ state: "detached" });
  assert.ok(!existsSync(join(folder, "out/typed")));
});
