// SPDX-License-Identifier: BSD-3-Clause
// The panels of the soil: how they begin, together and alone, in words.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { RunData } from "../src/data";
import { changed_report, launch_browser, take_screenshot } from "./browser";
import { after_drawing, difference, number_of, panel, pixels, quiet, set_frame, with_film_page } from "./film_page";
import { frame_of_drag, last_of, one_film, run_of, runs } from "./film_runs";

let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const with_page = with_film_page(() => browser);

test("two_panels_begin_with_the_mechanisms_at_the_same_embedment", { skip: one_film }, () =>
  with_page("", async (page) => {
    const [left, right] = [await run_of(page, 0), await run_of(page, 1)];
    const fem = runs.filter((run) => run.method === "fem");
    const deepest = (run: RunData) => Math.max(...run.film!.frames.map((frame) => frame.w ?? -Infinity));
    assert.equal(left, runs.find((run) => run.method === "mpm") ?? runs[0]);
    if (fem.length > 0 && left.method === "mpm") assert.equal(deepest(right), Math.max(...fem.map(deepest)));
    assert.equal(await number_of(panel(page, 1), "frame"), last_of(right));
    if (left.diameter !== null && right.diameter !== null) {
      assert.equal(await number_of(panel(page, 0), "frame"), frame_of_drag(left, right.film!.frames[last_of(right)].w!));
    }
    if (left.film!.fields.some((field) => field.name === "incremental_deviatoric_strain")) {
      assert.equal(await panel(page, 0).getAttribute("data-field"), "incremental_deviatoric_strain");
    }
    await page.locator("#soil").scrollIntoViewIfNeeded();
    await take_screenshot(page, "films");
  }),
);

test("same_embedment_puts_the_left_panel_where_the_right_one_is", { skip: one_film }, () =>
  with_page("", async (page) => {
    const [left, right] = [panel(page, 0), panel(page, 1)];
    const of_right = await run_of(page, 1);
    for (const frame of [Math.floor(last_of(of_right) / 2), last_of(of_right)]) {
      await set_frame(right, frame);
      await set_frame(left, 0);
      await page.locator(".film-linked").uncheck();
      await set_frame(right, frame);
      await page.locator(".film-same").click();
      await quiet(page);
      assert.equal(await number_of(left, "frame"), frame_of_drag(await run_of(page, 0), of_right.film!.frames[frame].w!));
      assert.equal(await number_of(right, "frame"), frame);
      await page.locator(".film-linked").check();
    }
  }),
);

test("panels_that_are_not_linked_go_alone", { skip: one_film }, () =>
  with_page("", async (page) => {
    const [left, right] = [panel(page, 0), panel(page, 1)];
    await after_drawing(right, () => left.locator(".film-closer").click());
    await page.locator(".film-linked").uncheck();
    const frame = await number_of(right, "frame");
    const picture = await pixels(right);
    await after_drawing(left, () => left.locator(".film-region").click());
    await set_frame(left, 0);
    assert.equal(await number_of(right, "frame"), frame);
    assert.equal(difference(picture, await pixels(right)), 0);
  }),
);

test("the_picture_is_told_in_words", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const run = await run_of(page, 0);
    await set_frame(left, 1);
    const frame = run.film!.frames[1];
    const label = (await left.locator("canvas[role=img]").first().getAttribute("aria-label"))!;
    const field = run.film!.fields.find((one) => label.includes(one.label));
    assert.equal(field?.name, await left.getAttribute("data-field"));
    for (const words of [run.name, "frame 1 of", `stage ${frame.stage}`]) assert.ok(label.includes(words), `${words} in ${label}`);
    if (run.diameter !== null) assert.ok(label.includes(`w/D = ${(frame.w! / run.diameter).toFixed(3).replace("-", "−")}`), label);
  }));

test("names_and_labels_are_text_and_never_markup", () =>
  with_page("", async (page) => {
    assert.equal(await page.evaluate(() => "caught" in window), false);
    assert.equal(await page.locator("#soil img, #soil b").count(), 0);
  }, changed_report((data) => {
    for (const run of data.runs) {
      run.title = `<b>bold</b><img src=x onerror="window.caught=1">`;
      for (const field of run.film?.fields ?? []) field.label += "<img src=x onerror='window.caught=1'>";
      for (const frame of run.film?.frames ?? []) frame.stage += "<b>x</b>";
    }
  })));

test("nothing_is_asked_of_the_network", () => with_page("", async (_, report) => assert.deepEqual(report.requests, [])));
