// SPDX-License-Identifier: BSD-3-Clause
// The soil moves: frames, play, keys, zoom.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch_browser } from "./browser";
import { after_drawing, difference, number_of, panel, pixels, quiet, set_frame, with_film_page } from "./film_page";
import { last_of, run_of, runs } from "./film_runs";

let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const with_page = with_film_page(() => browser);

for (const painter of ["2d", "webgl"] as const) {
  test(`slider_moves_the_soil_${painter}`, () =>
    with_page(painter, async (page) => {
      const left = panel(page, 0);
      assert.equal(await left.getAttribute("data-painter"), painter);
      const run = await run_of(page, 0);
      await set_frame(left, 0);
      const first = await pixels(left);
      await set_frame(left, last_of(run));
      assert.equal(await number_of(left, "frame"), last_of(run));
      assert.ok(difference(first, await pixels(left)) > 0.002);
      await set_frame(left, 0);
      assert.equal(difference(first, await pixels(left)), 0);
    }));

  test(`zoom_changes_the_picture_and_region_brings_it_back_${painter}`, () =>
    with_page(painter, async (page) => {
      const left = panel(page, 0);
      const before_zoom = await pixels(left);
      await after_drawing(left, () => left.locator(".film-closer").click());
      assert.ok(difference(before_zoom, await pixels(left)) > 0.01);
      await after_drawing(left, () => left.locator(".film-whole").click());
      assert.ok(difference(before_zoom, await pixels(left)) > 0.01);
      await after_drawing(left, () => left.locator(".film-region").click());
      assert.equal(difference(before_zoom, await pixels(left)), 0);

      await left.locator(".film-stage").hover();
      await left.locator(".film-stage").focus();
      await after_drawing(left, () => page.mouse.wheel(0, -300));
      const wheeled = await pixels(left);
      assert.ok(difference(before_zoom, wheeled) > 0.01);
      await page.mouse.down();
      await after_drawing(left, () => page.mouse.move(400, 500, { steps: 3 }));
      await page.mouse.up();
      assert.ok(difference(wheeled, await pixels(left)) > 0.01);
    }));
}

test("play_goes_on_and_pause_stops", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const last = last_of(await run_of(page, 0));
    await page.locator(".film-speed").selectOption("1");
    await set_frame(left, 0);
    await left.locator(".film-play").click();
    await page.waitForFunction(() => Number(document.querySelector<HTMLElement>(".film-panel")!.dataset.frame) > 0.2);
    assert.equal(await left.locator(".film-play").getAttribute("aria-label"), "Pause");
    await left.locator(".film-play").click();
    await quiet(page);
    const stopped = await number_of(left, "frame");
    await quiet(page);
    assert.equal(await number_of(left, "frame"), stopped);
    assert.ok(stopped > 0 && stopped < last);
    if (runs.length > 1) {
      const part = (await number_of(panel(page, 1), "frame")) / last_of(await run_of(page, 1));
      if ((await page.locator(".film-together").inputValue()) === "part") assert.ok(Math.abs(part - stopped / last) < 1e-3);
    }
    await page.locator(".film-speed").selectOption("40");
    await left.locator(".film-play").click();
    await page.waitForFunction((end) => Number(document.querySelector<HTMLElement>(".film-panel")!.dataset.frame) === end, last);
    assert.equal(await left.locator(".film-play").getAttribute("aria-label"), "Play");
  }));

test("out_of_sight_nothing_is_done", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    await page.locator(".film-speed").selectOption("1");
    await set_frame(left, 0);
    await left.locator(".film-play").click();
    const asked = await page.evaluate(async () => {
      const native = window.requestAnimationFrame.bind(window);
      let count = 0;
      window.requestAnimationFrame = (callback) => {
        count++;
        return native(callback);
      };
      const tall = document.createElement("div");
      tall.style.height = "5000px";
      document.querySelector("main")!.prepend(tall);
      window.scrollTo(0, 0);
      // A while after the page has seen that the section is gone it asks for no more pictures: ten in a row without a question.
      for (let still = 0, passed = 0; still < 10; passed++) {
        if (passed > 200) return count;
        const before = count;
        await new Promise(native);
        still = count === before ? still + 1 : 0;
      }
      window.requestAnimationFrame = native;
      return 0;
    });
    assert.equal(asked, 0);
    assert.equal(await left.locator(".film-play").getAttribute("aria-label"), "Pause");
    const held = await number_of(left, "frame");
    await left.locator(".film-stage").scrollIntoViewIfNeeded();
    await page.waitForFunction((from) => Number(document.querySelector<HTMLElement>(".film-panel")!.dataset.frame) > from, held);
  }));

test("keys_step_play_zoom_and_pan", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const last = last_of(await run_of(page, 0));
    await left.locator(".film-stage").focus();
    const press = (key: string) => after_drawing(left, () => page.keyboard.press(key));
    await press(last === (await number_of(left, "frame")) ? "Home" : "End");
    await page.keyboard.press("Home");
    await quiet(page);
    assert.equal(await number_of(left, "frame"), 0);
    await press("ArrowRight");
    assert.equal(await number_of(left, "frame"), 1);
    await press("ArrowLeft");
    assert.equal(await number_of(left, "frame"), 0);
    const region = await pixels(left);
    await press("+");
    const near = await pixels(left);
    assert.ok(difference(region, near) > 0.01);
    await press("Shift+ArrowRight");
    assert.ok(difference(near, await pixels(left)) > 0.01);
    await press("0");
    assert.equal(difference(region, await pixels(left)), 0);
    await press("Space");
    await page.waitForFunction(() => Number(document.querySelector<HTMLElement>(".film-panel")!.dataset.frame) > 0.1);
    await page.keyboard.press("Space");
    await quiet(page);
    assert.equal(await left.locator(".film-play").getAttribute("aria-label"), "Play");
  }));
