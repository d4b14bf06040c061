// SPDX-License-Identifier: BSD-3-Clause
// The files that charts are saved as.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { RunData } from "../src/data";
import { changed_report, launch_browser, open_report, read_history } from "./browser";
import { assert_as_in_history, cells_of, chart_of, charts_of_report, csv_rows, downloaded, drag, history_numbers, point_at, unfolded_charts, unit_in } from "./charts";

let browser: Browser;
before(async () => void (browser = await launch_browser()));
after(() => browser.close());

const { main_chart } = charts_of_report();

test("csv_holds_the_rows_of_history", async () => {
  const { page, context } = await open_report(browser);
  let compared = 0;
  for (const chart of await (await unfolded_charts(page)).all()) {
    const [time, ...cells] = await cells_of(chart);
    const column = cells.find((cell) => read_history(time.run).has(cell.column) && cell.column !== "time_s" && cell.row === time.row);
    if (column === undefined) continue;
    const file = await downloaded(page, chart, ".chart_csv");
    const [heads, ...rows] = csv_rows(file.text);
    const held = new Set(rows.map((row) => row[0]));
    const what = held.size > 1 ? `${held.size} runs` : time.run;
    assert.equal(file.name, `${await chart.getAttribute("data-chart")}_${what.replace(/[^A-Za-z0-9]+/g, "_")}.csv`, "named by what it holds");
    const numbers = rows.filter((row) => row[heads.indexOf("run")] === time.run);
    const at = heads.findIndex((head) => head.endsWith(column.head));
    assert.ok(at > 0, `${heads} has no ${column.head}`);
    const history = history_numbers(time.run, column.column);
    for (const row of numbers) {
      if (heads[1] === "of" && row[1] !== numbers[0][1]) continue;
      const line = Number(row[heads.indexOf("row")]);
      assert.equal(row[heads.indexOf("stage")], read_history(time.run).get("stage")![line]);
      assert.equal(Number(row[heads.indexOf("time (s)")]), history_numbers(time.run, "time_s")[line]);
      const expected = history[line], written = row[at] === "" ? null : Number(row[at]) * unit_in(heads[at]);
      if (expected === null || written === null || unit_in(heads[at]) === 1) assert.equal(written, expected);
      else assert.ok(Math.abs(written - expected) <= 1e-14 * Math.abs(expected));
      ++compared;
    }
  }
  assert.ok(compared > 0);
  await context.close();
});

test("svg_stands_alone_with_titles_units_and_legend", async () => {
  const label = `<b onload="x">"quoted" & 'odd'`;
  const file = changed_report((changed) => (changed.runs[0].name = label));
  const { page, context, errors } = await open_report(browser, { file });
  for (const chart of await (await unfolded_charts(page)).all()) {
    const id = (await chart.getAttribute("data-chart"))!;
    const svg = await downloaded(page, chart, ".chart_svg");
    assert.match(svg.name, /^[A-Za-z0-9_]+\.svg$/);
    const read = await page.evaluate((text) => {
      const document_ = new DOMParser().parseFromString(text, "image/svg+xml");
      return {
        broken: document_.querySelector("parsererror") !== null,
        titles: [...document_.querySelectorAll("text.title")].map((each) => each.textContent!),
        legend: [...document_.querySelectorAll(".legend text")].map((each) => each.textContent!),
        paths: document_.querySelectorAll("path[stroke-linejoin]").length,
        foreign: document_.querySelectorAll("b, script, foreignObject, image").length,
        size: [document_.documentElement.getAttribute("width"), document_.documentElement.getAttribute("height")],
      };
    }, svg.text);
    assert.equal(read.broken, false, id);
    assert.equal(read.foreign, 0, id);
    const described = (await chart.locator("canvas").getAttribute("aria-label"))!;
    assert.equal(read.titles.length, 2, id);
    for (const title of read.titles) assert.ok(title !== "" && described.includes(title), `${id}: ${title}`);
    if (["V_w", "H_u", "w_u", "gap"].includes(id)) for (const title of read.titles) assert.match(title, /\((mm|m|s|N\/m|kN\/m)\)$/);
    assert.equal(read.paths, Number(await chart.getAttribute("data-lines")), id);
    assert.deepEqual(read.legend, await chart.locator(".chart_readout tbody th span").allTextContents(), id);
    assert.ok(read.size.every((each) => Number(each) > 100));
  }
  assert.deepEqual(errors, []);
  await context.close();
});

test("remeshings_are_ticks_with_one_key", async (t) => {
  if (main_chart === "any") return t.skip("no pipe in these runs");
  const { page: without, context: its_context } = await open_report(browser);
  assert.equal(await without.locator(".chart_key").count(), 0);
  await its_context.close();
  const file = changed_report((changed) => changed.runs.forEach((run) => (run.columns.remeshings = run.stage.map((_, row) => Math.floor(row / 10)))));
  const { page, context, errors } = await open_report(browser, { file });
  assert.deepEqual(await page.locator(".chart_key").allTextContents(), ["remeshing"]);
  const svg = await downloaded(page, chart_of(page, main_chart), ".chart_svg");
  const [ticks, keys] = await page.evaluate((text) => {
    const read = new DOMParser().parseFromString(text, "image/svg+xml");
    return [read.querySelectorAll(".remeshings line").length, [...read.querySelectorAll(".remeshings_key text")].map((each) => each.textContent)] as const;
  }, svg.text);
  assert.ok(ticks > 0);
  assert.deepEqual(keys, ["remeshing"]);
  assert.deepEqual(errors, []);
  await context.close();
});

test("svg_shows_the_zoom", async () => {
  const { page, context } = await open_report(browser);
  const chart = chart_of(page, main_chart);
  const ticks = async () => page.evaluate(
    (text) => [...new DOMParser().parseFromString(text, "image/svg+xml").querySelectorAll(".axis")].map((axis) => {
      const ends = [...axis.querySelectorAll("text:not(.title)")].map((label) => `${label.textContent} at ${label.getAttribute("x")} ${label.getAttribute("y")}`);
      return ends.join(" ; ");
    }),
    (await downloaded(page, chart, ".chart_svg")).text);
  const all = await ticks();
  await drag(page, chart, [0.25, 0.25], [0.75, 0.75]);
  const zoomed = await ticks();
  assert.equal(all.length, 2);
  for (const axis of [0, 1]) {
    assert.notEqual(zoomed[axis], all[axis]);
    // Labels fill the axis: steps of at most a quarter of it leave more than half between the first and the last.
    const places = [...zoomed[axis].matchAll(/ at (\S+) (\S+)/g)].map((place) => Number(place[axis + 1]));
    const spread = Math.max(...places) - Math.min(...places), length = [520, 340][axis];
    assert.ok(spread > 0.51 * length && spread <= length, `labels spread over ${spread} of ${length} px`);
  }
  await chart.locator(".chart_reset").click();
  assert.deepEqual(await ticks(), all);
  await context.close();
});

test("files_are_named_after_the_chart_and_the_run_that_they_hold_or_how_many", async () => {
  const long = "a run whose folder has a very long name, longer than sixty letters and a half";
  const file = changed_report((changed) => (changed.runs[0].name = long));
  const { page, context } = await open_report(browser, { file });
  await unfolded_charts(page);
  const any = chart_of(page, "any"), names = (await cells_of(any)).map((cell) => cell.run);
  const shown = new Set(names).size;
  if (shown > 1) assert.equal((await downloaded(page, any, ".chart_svg")).name, `any_${shown}_runs.svg`);
  for (const box of (await page.locator(".chart_runs input").all()).slice(1)) await box.uncheck();
  assert.equal((await downloaded(page, any, ".chart_csv")).name, `any_${long.replace(/[^a-z]+/g, "_")}.csv`);
  await context.close();
});

test("rows_of_a_thinned_history_are_told_as_in_history_csv", async () => {
  const file = changed_report((changed) => changed.runs.forEach(thin));
  const { page, context, errors } = await open_report(browser, { file });
  assert.match((await page.locator("#curves").textContent())!, /Not all rows of history\.csv are in this page: .*\(\d+ of \d+\)/);
  const chart = chart_of(page, main_chart);
  assert.ok(assert_as_in_history(await cells_of(chart)) > 0);
  await point_at(page, chart, 0.4, 0.4);
  assert.ok(assert_as_in_history(await cells_of(chart)) > 0);
  const [heads, ...rows] = csv_rows((await downloaded(page, chart, ".chart_csv")).text);
  for (const row of rows) {
    const line = Number(row[heads.indexOf("row")]);
    assert.equal(Number(row[heads.indexOf("time (s)")]), history_numbers(row[0], "time_s")[line]);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

/** Leaves every third row of a run, and the last. */
function thin(run: RunData): void {
  const kept = run.stage.map((_, row) => row).filter((row) => row % 3 === 0 || row === run.stage.length - 1);
  run.row = kept;
  run.stage = kept.map((row) => run.stage[row]);
  for (const name of Object.keys(run.columns)) run.columns[name] = kept.map((row) => run.columns[name][row]);
  for (const path of [run.push, run.drag]) {
    const on_page = path.rows.flatMap((row, i) => (kept.includes(row) ? [{ row: kept.indexOf(row), V: path.V_mean[i], H: path.H_mean[i] }] : []));
    Object.assign(path, { rows: on_page.map((each) => each.row), V_mean: on_page.map((each) => each.V), H_mean: on_page.map((each) => each.H) });
  }
}
