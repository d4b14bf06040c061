// SPDX-License-Identifier: BSD-3-Clause
// Numbers and labels on canvases can be read: none is cut, none lies over another.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import type { PageData, RunData } from "../src/data";
import { changed_report, launch_browser, open_report, take_screenshot } from "./browser";
import { beyond, overlapping, remember_texts, texts_on, write_anew } from "./canvas_text";
import { chart_of, charts_of_report, downloaded } from "./charts";
import { panels_ready, quiet } from "./film_page";

let browser: Browser;
before(async () => void (browser = await launch_browser()));
after(() => browser.close());

const { main_chart, dragged, pushed } = charts_of_report();

async function with_changed(change: (data: PageData) => void, width: number, use: (page: Page) => Promise<void>): Promise<void> {
  const { page, context, errors } = await open_report(browser, { file: changed_report(change), script: remember_texts, viewport: { width, height: 900 } });
  await use(page);
  assert.deepEqual(errors, []);
  await context.close();
}

for (const width of [1280, 400])
  test(`numbers_of_the_colour_bar_are_not_cut_${width}_px`, () =>
    with_changed((data) => {
      for (const run of data.runs) for (const field of run.film?.fields ?? []) Object.assign(field, { low: 0, high: 0.0004, unit: "1" });
    }, width, async (page) => {
      await panels_ready(page);
      await write_anew(page);
      await quiet(page);
      for (const bar of await page.locator(".film-bar").all()) {
        const { texts, width: wide, height } = await texts_on(bar);
        assert.ok(texts.some((each) => /^0\.000+$/.test(each.text)) && texts.some((each) => /^0\.00040?$/.test(each.text)), texts.map((each) => each.text).join());
        assert.deepEqual(beyond(texts, { left: 0, top: 0, right: wide, bottom: height }), []);
        assert.deepEqual(overlapping(texts), []);
      }
    }));

/** Puts the soil of a film at another place, or makes it larger. */
function moved(run: RunData, factor: number, shift: number): void {
  if (run.film === null) return;
  const there = (place: [number, number]): [number, number] => [place[0] * factor + shift, place[1] * factor + shift];
  run.film.lower = there(run.film.lower);
  run.film.step *= factor;
  run.film.view = { lower: there(run.film.view.lower), upper: there(run.film.view.upper) };
}

for (const [words, factor, shift, unit] of [["as_they_are", 1, 0, "mm"], ["long", 1, -8, "mm"], ["of_a_large_bed", 1000, -2000, "m"]] as const)
  test(`numbers_and_titles_of_the_soils_axes_are_apart_${words}`, () =>
    with_changed((data) => data.runs.forEach((run) => moved(run, factor, shift)), 1280, async (page) => {
      await panels_ready(page);
      for (const zoom of [0, 12]) {
        for (let i = 0; i < zoom; ++i) await page.locator(".film-closer").first().click();
        await write_anew(page);
        await quiet(page);
        await take_screenshot(page, `axes_${words}_${zoom}`);
        for (const canvas of await page.locator(".film-over").all()) {
          const { texts, width, height } = await texts_on(canvas);
          // Near by, a bed far away counts from a round number.
          const title = zoom > 0 && unit === "m" ? /^y [+−] \d+ m \((m|mm)\)$/ : new RegExp(`^y \\(${unit}\\)$`);
          assert.ok(texts.some((each) => title.test(each.text)), texts.map((each) => each.text).join());
          assert.deepEqual(beyond(texts, { left: 0, top: 0, right: width, bottom: height }), []);
          assert.deepEqual(overlapping(texts), []);
        }
      }
    }));

/** The paper's numbers where labels are hard to place: at the corners of what the run covers, on its curve, and one over the other. */
function hard_places(data: PageData): void {
  const chart = main_chart as "H_u" | "V_w";
  const run = data.runs.find((each) => each.name === (chart === "H_u" ? dragged : pushed)[0].name)!;
  const path = chart === "H_u" ? run.drag : run.push;
  const along = path.rows.map((row) => (chart === "H_u" ? run.columns.u_m[row]! - run.drag.u_begin : run.columns.w_m[row]!));
  const values = path.rows.map((row) => run.columns[chart === "H_u" ? "H_N_m" : "V_N_m"][row] ?? 0);
  const [x, y] = [Math.max(...along), Math.max(...values)];
  const middle = Math.floor(along.length / 2);
  const places: [number | null, number][] = [[0, 0], [x, y], [0, y], [x, 0], [along[middle], values[middle]], [null, 0.8 * y], [null, 0.81 * y]];
  data.published = places.map(([at, value], i) => ({ chart, x: at, y: value, label: `paper: number ${i + 1} of some` }));
}

for (const width of [1280, 400])
  test(`labels_of_the_published_numbers_are_within_the_chart_and_apart_${width}_px`, { skip: main_chart === "any" && "no pipe in these runs" }, () =>
    with_changed(hard_places, width, async (page) => {
      await write_anew(page);
      const chart = chart_of(page, main_chart);
      const area = await chart.locator(".u-over").evaluate((over: HTMLElement) => ({
        left: over.offsetLeft, top: over.offsetTop, right: over.offsetLeft + over.offsetWidth, bottom: over.offsetTop + over.offsetHeight }));
      const labels = (await texts_on(chart.locator("canvas"))).texts.filter((each) => each.text.startsWith("paper"));
      assert.equal(labels.length, 7);
      assert.deepEqual(beyond(labels, area), []);
      assert.deepEqual(overlapping(labels), []);
      await chart.scrollIntoViewIfNeeded();
      await take_screenshot(page, `labels_${width}`);
    }));

test("labels_of_the_published_numbers_in_a_figure_are_within_it_and_apart", { skip: main_chart === "any" && "no pipe in these runs" }, () =>
  with_changed(hard_places, 1280, async (page) => {
    const svg = await downloaded(page, chart_of(page, main_chart), ".chart_svg");
    const { labels, area } = await page.evaluate((text) => {
      const holder = document.createElement("div");
      holder.innerHTML = text.slice(text.indexOf("<svg"));
      document.body.append(holder);
      const box = (each: SVGGraphicsElement) => {
        const { x, y, width: wide, height } = each.getBBox();
        // Half of a line above and below the letters is air.
        const air = each.textContent === "" ? 0 : 0.15 * height;
        return { text: each.textContent!, left: x, top: y + air, right: x + wide, bottom: y + height - air };
      };
      const labels = [...holder.querySelectorAll<SVGGraphicsElement>(".marks text")].map(box);
      return { labels, area: box(holder.querySelector<SVGGraphicsElement>("clipPath rect")!) };
    }, svg.text);
    assert.equal(labels.length, 7);
    assert.deepEqual(beyond(labels, area), []);
    assert.deepEqual(overlapping(labels), []);
  }));
