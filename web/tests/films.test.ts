// SPDX-License-Identifier: BSD-3-Clause
// The animation of the soil, as a reader sees and uses it.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import type { Browser, Page } from "playwright-core";
import type { FilmData, RunData } from "../src/data";
import { MARGIN, RIGID_FILL } from "../src/film_axes";
import { REGION, window_of } from "../src/film_camera";
import { decode_outline, decode_places, decode_sizes } from "../src/film_decode";
import { changed_report, launch_browser, open_report, type OpenReport, report_data, report_file, scratch_folder, take_screenshot } from "./browser";
import { after_drawing, block, block_text, difference, number_of, panel, panels_ready, pixel, type Pixels, pixels, quiet, set_frame } from "./film_page";

let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const runs = report_data().runs.filter((run) => run.film !== null);
const run_named = (name: string | null) => runs.find((run) => run.name === name)!;
const one_film = runs.length < 2 && "the report has one film only";

/** Opens the report with its panels drawn, tests it, and sees that nothing went wrong in the console. */
async function with_page(painter: "" | "webgl" | "2d", use: (page: Page, report: OpenReport) => Promise<void>, file = report_file()): Promise<void> {
  const report = await open_report(browser, { file });
  try {
    if (painter !== "") await report.page.goto(`${pathToFileURL(file).href}?painter=${painter}`);
    await panels_ready(report.page);
    await use(report.page, report);
    assert.deepEqual(report.errors, []);
  } finally {
    await report.context.close();
  }
}

async function run_of(page: Page, place: number): Promise<RunData> {
  return run_named(await panel(page, place).getAttribute("data-run"));
}

/** The frame of the drag whose w is nearest, by the words of the page's button. */
function frame_of_drag(run: RunData, w: number): number {
  const names = new Set(run.drag.rows.map((row) => run.stage[row]));
  const frames = run.film!.frames.map((frame, i) => ({ i, away: Math.abs(frame.w! - w), drag: names.has(frame.stage) }));
  const drag = frames.filter((frame) => frame.drag);
  return (drag.length > 0 ? drag : frames).sort((a, b) => a.away - b.away || a.i - b.i)[0].i;
}

/** Where the picture that shows the region of interest has a point of the model. */
function view_of(film: FilmData, picture: Pixels) {
  const plot = { width: picture.width - MARGIN.left - MARGIN.right, height: picture.height - MARGIN.top - MARGIN.bottom };
  const window = window_of(REGION, film.view, plot.width / plot.height);
  const scale = plot.width / window.width;
  type Place = readonly [number, number];
  const at = (x: number, y: number): Place => [
    MARGIN.left + plot.width / 2 + (x - window.x) * scale, MARGIN.top + plot.height / 2 - (y - window.y) * scale];
  const inside = ([x, y]: Place) =>
    x > MARGIN.left + 2 && x < picture.width - MARGIN.right - 2 && y > MARGIN.top + 2 && y < picture.height - MARGIN.bottom - 2;
  return { scale, at, inside };
}

const last_of = (run: RunData) => run.film!.frames.length - 1;

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

  test(`particles_are_drawn_where_the_data_says_${painter}`, { skip: !runs.some((run) => run.method === "mpm") && "no MPM run" }, () =>
    with_page(painter, async (page) => {
      const left = panel(page, 0);
      const film = (await run_of(page, 0)).film!;
      const frame = film.frames.length - 1;
      await set_frame(left, frame);
      const picture = await pixels(left);
      const view = view_of(film, picture);
      const codes = decode_places(block(film.position), film.frames.length, film.count)[frame];
      const sizes = decode_sizes(block(film.size!), film.count);
      const may_be_soil = new Uint8Array(picture.width * picture.height);
      let seen = 0;
      for (let p = 0; p < film.count; p++) {
        const [x, y] = view.at(film.lower[0] + film.step * codes[2 * p], film.lower[1] + film.step * codes[2 * p + 1]);
        if (view.inside([x, y])) {
          seen++;
          // The page may lie between two pixels of the screen: a single small square is then a pixel beside its place.
          const around = [-1, 0, 1].flatMap((right) => [-1, 0, 1].map((down) => pixel(picture, x + right, y + down)));
          assert.ok(around.some((colour) => colour.some((part) => part !== 255)), `particle ${p} at ${x}, ${y}`);
        }
        const reach = film.step * sizes[p] * view.scale + 2;
        for (let row = Math.max(0, Math.floor(y - reach)); row <= Math.min(picture.height - 1, y + reach); row++) {
          for (let column = Math.max(0, Math.floor(x - reach)); column <= Math.min(picture.width - 1, x + reach); column++) may_be_soil[row * picture.width + column] = 1;
        }
      }
      assert.ok(seen > 10);
      const bodies = film.rigids.map((rigid) => {
        const outline = decode_outline(block(rigid.block), film.frames.length, rigid.points)[frame];
        const corners = Array.from({ length: rigid.points }, (_, i) => view.at(outline[2 * i], outline[2 * i + 1]));
        const ends = (axis: 0 | 1) => [Math.min(...corners.map((c) => c[axis])) - 3, Math.max(...corners.map((c) => c[axis])) + 3];
        return { x: ends(0), y: ends(1) };
      });
      const surface = film.surface === null ? -10 : view.at(0, film.surface)[1];
      for (let y = 0; y < picture.height; y++) {
        for (let x = 0; x < picture.width; x++) {
          if (may_be_soil[y * picture.width + x] || !view.inside([x, y]) || Math.abs(y - surface) < 3) continue;
          if (bodies.some((body) => x > body.x[0] && x < body.x[1] && y > body.y[0] && y < body.y[1])) continue;
          assert.deepEqual(pixel(picture, x, y), [255, 255, 255], `no soil at ${x}, ${y}`);
        }
      }
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

test("both_painters_draw_the_same_picture", async () => {
  const seen: Record<string, Pixels[]> = {};
  for (const painter of ["2d", "webgl"] as const) {
    await with_page(painter, async (page) => {
      seen[painter] = [];
      for (let place = 0; place < (await page.locator(".film-panel").count()); place++) seen[painter].push(await pixels(panel(page, place), 40, 25));
    });
  }
  // A square that begins a pixel earlier changes the mean of a cell of some 180 pixels a little; another colour or another place changes it a lot.
  seen["2d"].forEach((picture, place) => {
    const away = Array.from(picture.data, (value, i) => Math.abs(value - seen.webgl[place].data[i]));
    assert.ok(away.reduce((a, b) => a + b) / away.length < 2, `mean difference in panel ${place}`);
    assert.ok(Math.max(...away) < 40, `largest difference in panel ${place}: ${Math.max(...away)}`);
  });
});

test("bodies_are_drawn_where_the_data_says", () =>
  with_page("", async (page) => {
    const fill = [1, 3, 5].map((at) => parseInt(RIGID_FILL.slice(at, at + 2), 16));
    let seen = 0;
    for (let place = 0; place < (await page.locator(".film-panel").count()); place++) {
      const one = panel(page, place);
      const film = (await run_of(page, place)).film!;
      for (const frame of [0, film.frames.length - 1]) {
        await set_frame(one, frame);
        const picture = await pixels(one);
        const { at, inside } = view_of(film, picture);
        for (const rigid of film.rigids) {
          const outline = decode_outline(block(rigid.block), film.frames.length, rigid.points)[frame];
          const xs = outline.filter((_, i) => i % 2 === 0);
          const ys = outline.filter((_, i) => i % 2 === 1);
          const mean = (values: Float32Array) => values.reduce((a, b) => a + b) / values.length;
          const half = (Math.max(...xs) - Math.min(...xs)) / 2;
          const high = (Math.max(...ys) - Math.min(...ys)) / 2;
          if (inside(at(mean(xs), mean(ys)))) {
            seen++;
            // The surface is dashed over the bodies: so a little to the side of the middle, both above and below it.
            for (const part of [-0.3, 0.3]) assert.deepEqual(pixel(picture, ...at(mean(xs), mean(ys) + part * high)), fill, `${rigid.name}, frame ${frame}`);
          }
          for (const side of [-1.08, 1.08]) {
            const beside = at(mean(xs) + side * half, mean(ys));
            if (inside(beside)) assert.notDeepEqual(pixel(picture, ...beside), fill, `beside ${rigid.name}, frame ${frame}`);
          }
        }
      }
    }
    assert.ok(seen > 0);
  }));

test("another_field_changes_colours_and_unit", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const run = await run_of(page, 0);
    const now = await left.getAttribute("data-field");
    const unit = run.film!.fields.find((field) => field.name === now)!.unit;
    const other = run.film!.fields.find((field) => field.unit !== unit)!;
    const before_change = await pixels(left);
    const shown = await left.locator(".film-bar-title").textContent();
    await after_drawing(left, () => left.locator(".film-field").selectOption(other.name));
    assert.equal(await left.getAttribute("data-field"), other.name);
    assert.ok(difference(before_change, await pixels(left)) > 0.05);
    const title = await left.locator(".film-bar-title").textContent();
    assert.notEqual(title, shown);
    assert.ok(title!.startsWith(other.label));
    assert.match(title!, other.unit === "1" ? /\(–\)$/ : new RegExp(`\\([kMm]?${other.unit}\\)$`));
    if (runs.length > 1) {
      assert.equal(await panel(page, 1).locator(".film-field").inputValue(), other.name);
      await page.locator(".film-linked").uncheck();
      await quiet(page);
    }
    // Alone, the panel spans its own field: numbers times the unit's prefix are the data's ends.
    const own_title = (await left.locator(".film-bar-title").textContent())!;
    const prefix = own_title.slice(own_title.lastIndexOf("(") + 1, -1).slice(0, -other.unit.length);
    const factor = other.unit === "1" ? 1 : { "": 1, k: 1e3, M: 1e6, m: 1e-3 }[prefix]!;
    for (const [end, value] of [["from", other.low], ["to", other.high]] as const) {
      const written = Number(await left.locator(`.film-${end}`).inputValue()) * factor;
      assert.ok(Math.abs(written - value) <= 1e-3 * (other.high - other.low), `${end} ${written} instead of ${value}`);
    }
  }));

test("a_narrower_range_changes_colours_and_default_brings_them_back", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const usual = await pixels(left);
    const end = await left.locator(".film-to").inputValue();
    const quarter = String(Number((Number(end) / 4).toPrecision(3)));
    await after_drawing(left, () => left.locator(".film-to").fill(quarter).then(() => left.locator(".film-to").blur()));
    assert.ok(difference(usual, await pixels(left)) > 0.001);
    if (runs.length > 1) assert.equal(await panel(page, 1).locator(".film-to").inputValue(), quarter);
    await after_drawing(left, () => left.locator(".film-range-back").click());
    assert.equal(await left.locator(".film-to").inputValue(), end);
    assert.equal(difference(usual, await pixels(left)), 0);
  }));

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

test("a_lost_context_goes_on_without_webgl", () =>
  with_page("webgl", async (page) => {
    const left = panel(page, 0);
    const drawn = await pixels(left, 40, 25);
    await after_drawing(left, () =>
      left.locator(".film-soil").evaluate((canvas: HTMLCanvasElement) => canvas.getContext("webgl2")!.getExtension("WEBGL_lose_context")!.loseContext()));
    assert.equal(await left.getAttribute("data-painter"), "2d");
    const again = await pixels(left, 40, 25);
    assert.ok(difference(drawn, again) < 0.1);
    assert.match((await left.locator(".film-note").textContent())!, /without WebGL/);
  }));

test("a_saved_picture_is_a_png_with_the_run_s_name", () =>
  with_page("", async (page) => {
    const run = await run_of(page, 0);
    const [download] = await Promise.all([page.waitForEvent("download"), panel(page, 0).locator(".film-save").click()]);
    assert.ok(download.suggestedFilename().endsWith(".png"));
    const png = readFileSync(await download.path());
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    const stage = (await panel(page, 0).locator(".film-stage").boundingBox())!;
    assert.ok(png.readUInt32BE(16) >= 2 * stage.width && png.readUInt32BE(20) > 2 * stage.height);
    assert.ok(download.suggestedFilename().includes(run.name.replaceAll(/[^\p{L}\p{N}._-]+/gu, "_")));
    if (process.env.BERM_SCREENSHOTS) writeFileSync(join(process.env.BERM_SCREENSHOTS, "film_saved.png"), png);
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
