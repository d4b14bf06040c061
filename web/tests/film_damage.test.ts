// SPDX-License-Identifier: BSD-3-Clause
// A film that cannot be shown says why.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch_browser, open_report, report_file, scratch_folder } from "./browser";
import { block_text, panel } from "./film_page";
import { runs } from "./film_runs";

let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

test("a_damaged_block_is_told_in_words", async () => {
  const run = runs.find((one) => one.method === "mpm") ?? runs[0];
  const text = readFileSync(report_file(), "utf8");
  const { text: good, at } = block_text(text, run.film!.position);
  const middle = Math.floor(good.length / 8) * 4;
  const file = join(scratch_folder(), "damaged.html");
  writeFileSync(file, text.slice(0, at + middle) + "AAAAAAAAAAAA" + text.slice(at + middle + 12));
  const { page, context, errors } = await open_report(browser, { file });
  const message = panel(page, 0).locator(".film-message");
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".film-panel")!.dataset.state === "damaged");
  assert.match((await message.textContent())!, new RegExp(`damaged.*${run.film!.position}.*berm report`));
  assert.deepEqual(errors, []);
  await context.close();
});

test("a_browser_without_unpacking_is_told_which_to_take", async () => {
  const { page, context, errors } = await open_report(browser);
  await page.addInitScript(() => Reflect.deleteProperty(window, "DecompressionStream"));
  await page.reload();
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".film-panel")!.dataset.state === "damaged");
  assert.match((await panel(page, 0).locator(".film-message").textContent())!, /Firefox 113/);
  assert.deepEqual(errors, []);
  await context.close();
});
