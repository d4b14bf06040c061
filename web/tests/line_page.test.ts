// SPDX-License-Identifier: BSD-3-Clause
// The moving line of a pipeline, its slices, and the film of the soil that goes with it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { is_line_run, type LineRun } from "../src/line_shapes";
import { launch_browser, open_report, type OpenReport, report_data, take_screenshot } from "./browser";
import { panel } from "./film_page";

const file = process.env.BERM_LINE_REPORT!;
const run = report_data(file).runs.find(is_line_run) as LineRun, last = run.line.frames.length - 1;
let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

/** The page with its line drawn, in which nothing went wrong. */
async function with_page(use: (page: Page, report: OpenReport) => Promise<void>, width = 1280): Promise<void> {
  const report = await open_report(browser, { file, viewport: { width, height: 900 } });
  try {
    await report.page.locator("#line[data-state=ready]").waitFor({ state: "attached" });
    await report.page.locator("#line").scrollIntoViewIfNeeded();
    await use(report.page, report);
    assert.deepEqual(report.errors, []);
    assert.deepEqual(report.requests, []);
  } finally {
    await report.context.close();
  }
}

const frame_of = async (page: Page) => Number(await page.locator("#line").getAttribute("data-frame"));

/** Does something and waits until the line has been drawn because of it. */
async function after_drawn(page: Page, action: () => Promise<unknown>): Promise<void> {
  const before_it = await page.locator("#line").getAttribute("data-frames-drawn");
  await action();
  await page.waitForFunction((drawn) => document.querySelector<HTMLElement>("#line")!.dataset.framesDrawn !== drawn, before_it);
}

/** The highest point of the moving line in plan, px from the top of the picture. */
const top_of_line = (page: Page) =>
  page.locator(".line_stage .line_chart_y .line_now").evaluate((path) => Math.min(...(path.getAttribute("d")!.match(/[\d.]+ [\d.]+/g) ?? []).map((point) => Number(point.split(" ")[1]))));

test("line_begins_at_the_end_of_the_run_with_the_numbers_of_its_history", () =>
  with_page(async (page) => {
    assert.equal(await frame_of(page), last);
    const shown = await page.locator("#line .film-readings").innerText();
    const end = (column: string) => run.columns[column].at(-1)!;
    for (const words of ["heat_2", `${end("line_T_K").toFixed(1)} K`, `${(end("line_P_N") / 1e3).toFixed(0)} kN`, `${end("line_y_m").toFixed(2)} m`, `${(end("line_M_Nm") / 1e3).toFixed(0)} kN m`])
      assert.ok(shown.includes(words), `${words} in ${shown}`);
    await take_screenshot(page, "line");
  }));

test("keys_and_slider_move_the_line_and_the_soil_goes_along", () =>
  with_page(async (page) => {
    const stage = page.locator(".line_stage");
    await stage.focus();
    const crown = await top_of_line(page);
    await after_drawn(page, () => page.keyboard.press("Home"));
    assert.equal(await frame_of(page), 0);
    assert.ok((await top_of_line(page)) > crown + 20, "the line is flatter before it is heated");
    await after_drawn(page, () => page.keyboard.press("ArrowRight"));
    assert.equal(await frame_of(page), 1);
    const middle = run.line.ends[0].frame;
    await after_drawn(page, () => page.locator("#line .film-frame").evaluate((slider: HTMLInputElement, value) => {
      slider.value = String(value);
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    }, middle));
    assert.equal(await frame_of(page), middle);
    await page.locator("#soil .film-stage").scrollIntoViewIfNeeded();
    const same = run.film!.frames.findIndex((frame) => Math.abs(frame.time - run.line.frames[middle].time) < 1e-6);
    await page.waitForFunction((frame) => Number(document.querySelector<HTMLElement>("#soil .film-panel")!.dataset.frame) === frame, same);
    await after_drawn(page, () => panel(page, 0).locator(".film-back").click());
    assert.ok((await frame_of(page)) < middle, "and the line goes along with the soil");
  }));

test("line_plays_to_its_end", () =>
  with_page(async (page) => {
    await page.locator(".line-speed").selectOption("40");
    await page.locator("#line .film-play").click();
    await page.waitForFunction((end) => Number(document.querySelector<HTMLElement>("#line")!.dataset.frame) === end, last);
    await page.locator("#line .film-play[aria-label=Play]").waitFor();
  }));

test("each_stage_has_a_button_to_its_end_and_a_thin_line_once_it_is_over", () =>
  with_page(async (page) => {
    const buttons = page.locator(".line_to_end"), trails = page.locator(".line_stage .line_chart_y .line_end");
    assert.equal(await buttons.count(), run.line.ends.length);
    for (const [k, end] of run.line.ends.entries()) {
      await after_drawn(page, () => buttons.nth(k).click());
      assert.equal(await frame_of(page), end.frame);
      assert.equal(await trails.count(), k, "those that are over");
    }
    assert.match(await trails.first().getAttribute("class") ?? "", /hot/);
    assert.match(await trails.nth(1).getAttribute("class") ?? "", /cold/);
  }));

test("exaggeration_is_told_and_true", () =>
  with_page(async (page) => {
    const plan = page.locator(".line_stage .line_chart_y");
    const told = Number((await plan.locator(".line_words").innerText()).match(/drawn (\d+) times larger/)![1]);
    const marks = await plan.locator(".line_mark").evaluateAll((all) => all.map((mark) => Number(mark.getAttribute("transform")!.match(/[\d.]+/)![0])));
    const per_metre = (marks[1] - marks[0]) / (run.line.slices[1] - run.line.slices[0]);
    const grid = await plan.locator(".line_grid").getAttribute("d");
    const rows = [...grid!.matchAll(/M[\d.]+ ([\d.]+)h/g)].map((row) => Number(row[1]));
    const labels = (await plan.locator("text[text-anchor=end]").allTextContents()).map((text) => Number(text.replace("\u2212", "-")));
    const per_metre_of_y = (rows[0] - rows[1]) / (labels[1] - labels[0]);
    assert.ok(Math.abs(per_metre_of_y / per_metre - told) < 0.02 * told, `${per_metre_of_y} and ${per_metre} px/m`);
  }));

test("slices_and_their_cards_point_at_each_other", () =>
  with_page(async (page) => {
    const cards = page.locator(".line_card"), marks = page.locator(".line_stage .line_mark");
    assert.equal(await cards.count(), run.line.slices.length);
    assert.equal(await marks.count(), run.line.slices.length);
    await marks.nth(2).focus();
    assert.match(await cards.nth(2).getAttribute("class") ?? "", /picked/);
    await page.keyboard.press("Enter");
    assert.equal(await page.evaluate(() => document.querySelector(".line_card:target h4")!.textContent), `Slice 2, x = ${run.line.slices[2]} m`);
    await cards.nth(1).hover();
    assert.match(await marks.nth(1).getAttribute("class") ?? "", /picked/);
  }));

test("cards_have_one_scale_and_mark_the_largest_of_all_slices", () =>
  with_page(async (page) => {
    const cards = page.locator(".line_card");
    const axes = await cards.evaluateAll((all) => all.map((card) => [...card.querySelectorAll("text")].map((text) => text.textContent).join(" ")));
    assert.equal(new Set(axes).size, 1, axes.join("\n"));
    const loading = new Set(run.line.ends.map((end) => end.name));
    const largest = (column: string) => run.line.slices.map((_, k) =>
      Math.max(...run.columns[k === 0 ? column : `slice_${k}_${column}`].map((value, row) => (loading.has(run.stage[row]) ? Math.abs(value ?? 0) : 0))));
    for (const [i, column] of ["H_N_m", "V_N_m", "w_m"].entries()) {
      const of_slices = largest(column), marked = of_slices.indexOf(Math.max(...of_slices));
      const bold = await cards.evaluateAll((all, row) => all.map((card) => card.querySelectorAll("dd")[row].className === "line_largest"), i);
      assert.deepEqual(bold, of_slices.map((_, k) => k === marked), column);
    }
    assert.equal(await page.locator(".line_ring").count(), 3);
  }));

test("first_look_and_paper_have_the_ends_of_all_stages", () =>
  with_page(async (page) => {
    assert.equal(await page.locator("#first-look .line_chart_y .line_end").count(), run.line.ends.length);
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    const curves = (chart: string) => page.locator(`.line_stage .line_chart_${chart}`);
    for (const [chart, each] of [["y", 1], ["M", 1], ["strain", 2], ["P", 1]] as const) {
      assert.equal(await curves(chart).locator(".line_end").count(), each * run.line.ends.length, chart);
      assert.equal(await curves(chart).locator(".line_now").count(), 0, chart);
    }
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.equal(await curves("y").locator(".line_now").count(), 1);
  }));

test("nothing_is_wider_than_a_small_window_and_letters_keep_their_size", () =>
  with_page(async (page) => {
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 400);
    const heights = await page.locator(".line_stage .line_drawing text").evaluateAll((all) => all.map((text) => text.getBoundingClientRect().height).filter((height) => height > 0));
    assert.ok(heights.length > 20 && heights.every((height) => height > 9 && height < 20));
    await take_screenshot(page, "line_narrow");
  }, 400));

test("numbers_of_axes_do_not_lie_on_each_other", async () => {
  for (const width of [400, 1400])
    await with_page(async (page) => {
      const over = await page.locator("#line svg").evaluateAll((drawings) => drawings.flatMap((drawing) => {
        const boxes = [...drawing.querySelectorAll(":scope > g > text")].map((text) => ({ words: text.textContent, box: text.getBoundingClientRect() }));
        return boxes.flatMap((a, i) => boxes.slice(i + 1).flatMap((b) =>
          a.box.left < b.box.right - 1 && b.box.left < a.box.right - 1 && a.box.top < b.box.bottom - 3 && b.box.top < a.box.bottom - 3 ? [`${a.words} and ${b.words}`] : []));
      }));
      assert.deepEqual(over, [], `${width} px`);
    }, width);
});

test("a_run_without_a_line_has_no_section_for_it", () => {
  const other = readFileSync(process.env.BERM_REPORT!, "utf8");
  assert.ok(!other.includes('id="line"') && !other.includes('"line":'));
});
