// SPDX-License-Identifier: BSD-3-Clause
// A job at the desk, from a case to springs, in a browser: a form that changes the text, a run that grows, stops and goes on, two runs compared, springs, a printed page.
import assert from "node:assert/strict";
import { type ChildProcess, spawn } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { from_environment, launch_browser, take_screenshot } from "./browser";

const folder = mkdtempSync(join(tmpdir(), "berm desk ")), program = from_environment("BERM_PROGRAM");
let browser: Browser, desk: ChildProcess, address = "", page: Page;
const errors: string[] = [];

before(async () => {
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
  browser = await launch_browser();
  const context = await browser.newContext({ viewport: { width: 1280, height: 860 }, acceptDownloads: true });
  context.setDefaultTimeout(240_000);
  page = await context.newPage();
  page.on("pageerror", (error) => errors.push(String(error)));
  page.on("dialog", (dialog) => void dialog.accept());
});
after(async () => {
  await browser.close();
  desk.kill("SIGINT");
  await new Promise((ended) => desk.once("exit", ended));
  rmSync(folder, { recursive: true, force: true });
});

const go = (hash: string) => page.goto(`${address.split("#")[0]}#${hash}`);
const badge = (word: string) => page.locator(`.run_head .badge.${word}`);
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
  // Some ten seconds.
  await page.locator('[data-key="stage.drag.velocity"] input').fill("0.1");
  await page.locator('[data-key="stage.drag.velocity"] input').blur();
  assert.match(await page.locator(".cm-content").innerText(), /# A pipe on sand/, "comments stay");
  await take_screenshot(page, "desk_case");
});

test("a_wrong_value_is_found_and_a_click_goes_to_its_field", async () => {
  const field = page.locator('[data-key="material.sand.poisson_ratio"]');
  await page.locator('[data-path="material.sand"] > summary').click();
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

test("two_runs_are_compared_and_springs_are_written", async () => {
  await go("/case?path=pipe.toml");
  await page.locator('[data-path="material.sand"] > summary').waitFor();
  await page.locator('[data-key="mesh.cells"] input').waitFor();
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
  const [download] = await Promise.all([page.waitForEvent("download"), file.click()]);
  assert.ok(readFileSync(await download.path(), "utf8").length > 0);
});

test("a_page_is_printed", async () => {
  await go("/run?path=out%2Fpipe");
  await badge("finished").waitFor();
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "PDF" }).click()]);
  assert.equal(readFileSync(await download.path()).subarray(0, 5).toString(), "%PDF-");
  assert.deepEqual(errors, []);
});
