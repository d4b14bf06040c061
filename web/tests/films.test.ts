// SPDX-License-Identifier: BSD-3-Clause
// The panels of the soil: how they begin, together and alone, in words.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { RunData } from "../src/data";
import { changed_report, launch_browser, open_report, take_screenshot } from "./browser";
import { after_drawing, difference, number_of, panel, panels_ready, pixels, quiet, set_frame, with_film_page } from "./film_page";
import { type FilmedRun, joins_of, partner, travels } from "../src/film_together";
import { frame_of_drag, last_of, one_film, region_of, run_of, runs } from "./film_runs";

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
    if (left.diameter !== null && right.diameter !== null) {
      const frame = await number_of(panel(page, 0), "frame");
      assert.equal(frame, frame_of_drag(left, right.film!.frames[last_of(right)].w!));
      assert.equal(await page.locator(".film-together").inputValue(), joins_of(left as FilmedRun, right as FilmedRun)[0]);
      assert.ok(Math.abs((await number_of(panel(page, 1), "frame")) - partner("travel", left as FilmedRun, frame, right as FilmedRun)) < 1e-3);
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

test("a_step_on_the_left_takes_the_right_as_far", { skip: one_film }, () =>
  with_page("", async (page) => {
    const [left, right] = [(await run_of(page, 0)) as FilmedRun, (await run_of(page, 1)) as FilmedRun];
    if (left.diameter === null || right.diameter === null) return;
    const gone = async (place: number, run: FilmedRun) => {
      const at = await number_of(panel(page, place), "frame"), way = travels(run), frame = Math.floor(at);
      return way[frame] + (at - frame) * ((way[frame + 1] ?? way[frame]) - way[frame]);
    };
    const farthest = Math.min(travels(left).at(-1)!, travels(right).at(-1)!);
    await set_frame(panel(page, 0), travels(left).findIndex((way) => way > 0));
    for (let step = 0; step < 3; step++) {
      const before_step = [await gone(0, left), await gone(1, right)];
      await panel(page, 0).locator(".film-forward").click();
      await quiet(page);
      const after_step = [await gone(0, left), await gone(1, right)];
      assert.ok(after_step[0] >= before_step[0] && after_step[1] >= before_step[1], "nobody goes back");
      assert.ok(Math.abs(Math.min(after_step[0], farthest) - Math.min(after_step[1], farthest)) < 2e-3, `${after_step}`);
    }
  }),
);

test("films_are_joined_by_what_is_chosen", { skip: one_film }, () =>
  with_page("", async (page) => {
    const [left, right] = [(await run_of(page, 0)) as FilmedRun, (await run_of(page, 1)) as FilmedRun];
    const offered = await page.locator(".film-together option").evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value));
    assert.deepEqual(offered, joins_of(left, right));
    const middle = Math.floor(last_of(left) / 2);
    for (const by of joins_of(left, right)) {
      await page.locator(".film-together").selectOption(by);
      await set_frame(panel(page, 0), middle);
      assert.ok(Math.abs((await number_of(panel(page, 1), "frame")) - partner(by, left, middle, right)) < 1e-3, by);
    }
  }),
);

test("both_panels_have_one_scale", { skip: one_film }, () =>
  with_page("", async (page) => {
    const [left, right] = [await run_of(page, 0), await run_of(page, 1)];
    if (left.diameter === null || left.diameter !== right.diameter) return;
    const shapes = await page.locator(".film-stage").evaluateAll((stages) => stages.map((stage) => `${stage.clientWidth} ${stage.clientHeight}`));
    assert.equal(shapes[0], shapes[1]);
    const widths = await Promise.all([0, 1].map(async (place) => ((box) => box.upper[0] - box.lower[0])(await region_of(page, place))));
    assert.ok(Math.abs(widths[0] - widths[1]) < 1e-9 * widths[0]);
  }),
);

test("marks_on_the_curves_go_with_the_film", () =>
  with_page("", async (page) => {
    const run = await run_of(page, 0);
    if (run.drag.rows.length === 0) return;
    const mark = page.locator('.film-curves [data-chart="film_H_u"] .chart_moment').first();
    const place = async () => Number.parseFloat(await mark.evaluate((dot) => (dot as HTMLElement).style.left));
    const dragged = travels(run as FilmedRun).findIndex((way) => way > 0);
    await set_frame(panel(page, 0), dragged);
    const early = await place();
    await set_frame(panel(page, 0), last_of(run));
    assert.ok((await place()) > early + 20, `${early} to ${await place()} px`);
    const width = await page.locator('.film-curves [data-chart="film_H_u"] .u-over').evaluate((over) => over.clientWidth);
    assert.ok((await place()) <= width + 1);
    await set_frame(panel(page, 0), 0);
    assert.equal(await page.locator('#curves [data-chart="H_u"] .chart_moment').count(), 0, "before the drag H(u) has no mark");
  }),
);

test("a_film_is_saved_as_a_gif_with_all_frames", () =>
  with_page("", async (page) => {
    const run = await run_of(page, 0);
    const shown = await number_of(panel(page, 0), "frame");
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator(".film-gif").click()]);
    assert.ok(download.suggestedFilename().endsWith(".gif") && download.suggestedFilename().includes(run.name.replaceAll(/[^\p{L}\p{N}._-]+/gu, "_")));
    const gif = readFileSync(await download.path());
    assert.equal(gif.subarray(0, 6).toString("latin1"), "GIF89a");
    const stages = await page.locator(".film-stage").evaluateAll((all) => all.map((stage) => stage.clientWidth));
    assert.equal(gif.readUInt16LE(6), stages.reduce((sum, width) => sum + width, 0), "the panels stand side by side");
    assert.equal(frames_of_gif(gif), run.film!.frames.length);
    await page.locator(".film-gif", { hasText: "Save film" }).waitFor();
    assert.equal(await number_of(panel(page, 0), "frame"), shown, "the page shows what it showed");
    if (process.env.BERM_SCREENSHOTS) writeFileSync(join(process.env.BERM_SCREENSHOTS, "film.gif"), gif);
  }),
);

/** In this page the second picture of a film cannot be made. */
function break_second_picture(): void {
  const { getImageData } = CanvasRenderingContext2D.prototype;
  let left = Infinity;
  addEventListener("click", (event) => (event.target as Element).matches(".film-gif") && (left = 1), true);
  CanvasRenderingContext2D.prototype.getImageData = function (this: CanvasRenderingContext2D, ...place: [number, number, number, number]) {
    if (left-- <= 0) throw new Error("no memory for the picture");
    return getImageData.apply(this, place);
  };
}

test("a_film_that_cannot_be_saved_leaves_the_button_as_it_was", async () => {
  const { page, context, errors } = await open_report(browser, { script: break_second_picture });
  try {
    await panels_ready(page);
    const error = page.waitForEvent("pageerror");
    await page.locator(".film-gif").click();
    assert.match(String(await error), /no memory for the picture/);
    assert.equal(errors.length, 1);
    await page.locator(".film-gif:enabled", { hasText: "Save film (GIF)" }).waitFor();
  } finally {
    await context.close();
  }
});

/** How many pictures a GIF holds, by its blocks. */
function frames_of_gif(gif: Buffer): number {
  const table = (flags: number) => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  let at = 13 + table(gif[10]), frames = 0;
  const skip_blocks = () => {
    while (gif[at] !== 0) at += gif[at] + 1;
    at++;
  };
  for (;;) {
    const kind = gif[at++];
    if (kind === 0x3b) return frames;
    if (kind === 0x21) at++, skip_blocks();
    else if (kind === 0x2c) {
      frames++;
      at += 9 + table(gif[at + 8]) + 1;
      skip_blocks();
    } else throw new Error(`byte ${at} is no block of a GIF`);
  }
}

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
