// SPDX-License-Identifier: BSD-3-Clause
// The soil in space and both halves around an axis as the page shows them.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Locator, Page } from "playwright-core";
import { launch_browser, report_data, take_screenshot } from "./browser";
import { after_drawing, difference, number_of, panel, pixels, quiet, set_frame, with_film_page } from "./film_page";

const file = process.env.BERM_SPACE_REPORT!;
let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const with_page = (painter: "" | "2d", use: (page: Page) => Promise<void>) => with_film_page(() => browser)(painter, use, file);
const space = (page: Page): Locator => panel(page, 0);
const whole_film = () => report_data(file).runs.find((run) => run.film?.space)!.film!.space!;

async function key(page: Page, name: string): Promise<void> {
  await space(page).locator(".space-stage").focus();
  await after_drawing(space(page), () => page.keyboard.press(name));
}

/** Pixels that are not the ground, of all. */
async function covered(page: Page): Promise<number> {
  const { data } = await pixels(space(page), 120, 70);
  let count = 0;
  for (let i = 0; i < data.length; i += 4) if (data[i] + data[i + 1] + data[i + 2] < 600) count++;
  return count / (data.length / 4);
}

test("film_in_space_begins_at_the_end_of_the_run_and_says_so", () =>
  with_page("", async (page) => {
    const film = whole_film();
    assert.equal(await number_of(space(page), "frame"), film.frames.length - 1);
    assert.equal(await space(page).getAttribute("data-painter"), "webgl");
    const label = await space(page).locator("canvas[role=img]").first().getAttribute("aria-label");
    assert.match(label!, /In space: .*stage drag.* N; seen from the direction \(0\.58, 0\.58, 0\.58\)/);
    assert.ok((await covered(page)) > 0.1);  // the block stands in the middle of a wide stage
    await take_screenshot(page, "space");
  }));

test("each_standard_view_is_another_picture_by_key_and_by_button", () =>
  with_page("", async (page) => {
    await key(page, "f");
    const front = await pixels(space(page));
    for (const [name, letter] of [["side", "r"], ["above", "t"], ["iso", "i"]] as const) {
      await key(page, letter);
      const by_key = await pixels(space(page));
      assert.ok(difference(by_key, front) > 0.05, name);
      await key(page, "f");
      await after_drawing(space(page), () => space(page).locator(`.space-${name}`).click());
      await space(page).locator(".space-stage").focus();
      assert.ok(difference(await pixels(space(page)), by_key) < 0.001, name);
    }
  }));

test("a_drag_turns_with_shift_moves_and_zero_goes_back", () =>
  with_page("", async (page) => {
    await key(page, "0");
    const begin = await pixels(space(page));
    const box = (await space(page).locator(".space-stage").boundingBox())!;
    const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    const label = () => space(page).locator("canvas[role=img]").first().getAttribute("aria-label");
    const direction = await label();
    for (const shift of [true, false]) {
      if (shift) await page.keyboard.down("Shift");
      await page.mouse.move(middle.x, middle.y);
      await page.mouse.down();
      await after_drawing(space(page), () => page.mouse.move(middle.x + 80, middle.y - 40, { steps: 3 }));
      await page.mouse.up();
      if (shift) await page.keyboard.up("Shift");
      assert.equal((await label()) === direction, shift);  // moving does not turn
      assert.ok(difference(await pixels(space(page)), begin) > 0.02);
      await key(page, "0");
      assert.ok(difference(await pixels(space(page)), begin) < 0.001);
    }
  }));

test("cuts_the_surface_and_hidden_bodies_leave_less_to_see", () =>
  with_page("", async (page) => {
    const whole = await covered(page);
    const side = space(page).locator(".space-cut-side").nth(0);
    await after_drawing(space(page), () => side.selectOption("above"));
    const cut = await covered(page);
    assert.ok(cut < whole * 0.9, `${cut} of ${whole}`);
    await after_drawing(space(page), () => side.selectOption("slice"));
    assert.ok((await covered(page)) < whole * 0.8);
    await after_drawing(space(page), () => side.selectOption("off"));
    await after_drawing(space(page), () => space(page).locator(".space-surface").check());
    assert.ok((await covered(page)) < whole * 0.8);
    const with_body = await pixels(space(page));
    await after_drawing(space(page), () => space(page).locator(".space-bodies").selectOption("hidden"));
    assert.ok(difference(await pixels(space(page)), with_body) > 0.01);
  }));

test("frames_and_fields_change_the_picture_and_the_player_runs_to_the_end", () =>
  with_page("", async (page) => {
    const film = whole_film();
    const end = await pixels(space(page));
    await set_frame(space(page), 0);
    assert.ok(difference(await pixels(space(page)), end) > 0.01);
    await after_drawing(space(page), () => space(page).locator(".film-field").selectOption(film.fields[1].name));
    assert.equal(await space(page).getAttribute("data-field"), film.fields[1].name);
    await space(page).locator(".film-play").click();
    await page.waitForFunction((last) => document.querySelector<HTMLElement>(".film-panel")!.dataset.frame === last, String(film.frames.length - 1));
    await quiet(page);
    assert.equal(await space(page).locator(".film-play").getAttribute("aria-label"), "Play");
  }));

test("picture_can_be_saved_and_printed", () =>
  with_page("", async (page) => {
    const download = page.waitForEvent("download");
    await space(page).locator(".film-save").click();
    assert.match((await download).suggestedFilename(), /^sphere_in_space_.*_frame_\d+\.png$/);
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.equal(await space(page).locator("canvas.film-print").count(), 1);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.equal(await space(page).locator("canvas.film-print").count(), 0);
  }));

test("without_webgl_there_is_a_picture_and_a_sentence", () =>
  with_page("2d", async (page) => {
    assert.equal(await space(page).getAttribute("data-painter"), "2d");
    assert.match((await space(page).locator(".film-note").textContent())!, /no WebGL/);
    assert.ok((await covered(page)) > 0.1);  // the block stands in the middle of a wide stage
    await take_screenshot(page, "space_2d");
  }));

test("every_control_in_space_has_a_name", () =>
  with_page("", async (page) => {
    const nameless = await space(page).locator(".space-tools").evaluate((tools) =>
      [...tools.querySelectorAll("button, select, input")].filter((one) =>
        !(one.textContent?.trim() && one.tagName === "BUTTON") && !one.getAttribute("aria-label") && !(one.closest("label")?.textContent?.trim())).map((one) => one.className));
    assert.deepEqual(nameless, []);
  }));

test("both_halves_around_an_axis_have_whole_forces_and_can_be_put_away", () =>
  with_page("", async (page) => {
    const index = report_data(file).runs.filter((run) => run.film !== null).findIndex((run) => run.film!.around_axis);
    assert.ok(index >= 0);
    const one = panel(page, 1);
    await one.locator(".film-run").selectOption(String(index));
    await quiet(page);
    await one.scrollIntoViewIfNeeded();
    const both = await pixels(one);
    assert.match((await one.locator(".film-readings").textContent())!, /V[\d.]+ k?N$/);
    await take_screenshot(page, "both_halves");
    await page.locator(".film-both").uncheck();
    await quiet(page);
    assert.ok(difference(await pixels(one), both) > 0.05);
  }));
