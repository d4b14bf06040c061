// SPDX-License-Identifier: BSD-3-Clause
// The soil and the bodies are drawn where the data says, by either painter, on the page and in a file.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { RIGID_FILL } from "../src/film_axes";
import { decode_outline, decode_places, decode_sizes } from "../src/film_decode";
import { launch_browser } from "./browser";
import { after_drawing, block, difference, panel, pixel, type Pixels, pixels, set_frame, with_film_page } from "./film_page";
import { region_of, run_of, runs, view_of } from "./film_runs";

let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const with_page = with_film_page(() => browser);

for (const painter of ["2d", "webgl"] as const) {
  test(`particles_are_drawn_where_the_data_says_${painter}`, { skip: !runs.some((run) => run.method === "mpm") && "no MPM run" }, () =>
    with_page(painter, async (page) => {
      const left = panel(page, 0);
      const film = (await run_of(page, 0)).film!;
      const frame = film.frames.length - 1;
      await set_frame(left, frame);
      const picture = await pixels(left);
      const view = view_of(await region_of(page, 0), picture);
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
        const outline = decode_outline(block(rigid.block), film.frames.length, rigid.points, film.lower)[frame];
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
        const { at, inside } = view_of(await region_of(page, place), picture);
        for (const rigid of film.rigids) {
          const outline = decode_outline(block(rigid.block), film.frames.length, rigid.points, film.lower)[frame];
          const xs = outline.filter((_, i) => i % 2 === 0);
          const ys = outline.filter((_, i) => i % 2 === 1);
          const mean = (values: Float64Array) => values.reduce((a, b) => a + b) / values.length;
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
