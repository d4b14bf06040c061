// SPDX-License-Identifier: BSD-3-Clause
// The systems of units: which are offered, and what they show.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { PageData, RunData } from "../src/data";
import { changed_report, launch_browser, open_report, take_screenshot } from "./browser";
import { cells_of, chart_of, charts_of_report, point_at, range_of, unit_in } from "./charts";

let browser: Browser;
before(async () => void (browser = await launch_browser()));
after(() => browser.close());

const { data, main_chart, main_column } = charts_of_report();

test("units_are_switched_for_all_charts", async (t) => {
  if (main_chart === "any") return t.skip("no pipe in these runs");
  const { page, context } = await open_report(browser);
  const chart = chart_of(page, main_chart);
  const select = page.locator(".chart_units");
  const offered = await select.locator("option").evaluateAll((all) => all.map((each) => (each as HTMLOptionElement).value));
  assert.equal(offered.includes("prototype"), data.runs.some((run) => run.prototype !== null));
  for (const system of offered) {
    await select.selectOption(system);
    await point_at(page, chart, 0.4, 0.4);
    const cells = await cells_of(chart);
    for (const cell of cells.filter((each) => each.column === main_column)) {
      const run = data.runs.find((each) => each.name === cell.run)!;
      const expected = cell.value! * { model: 1, prototype: run.prototype!, dimensionless: 1 / run.measure!.size }[system]!;
      const shown = Number(cell.text) * unit_in(cell.head);
      assert.ok(Math.abs(shown - expected) <= 0.6e-4 * Math.abs(expected), `${system}: ${cell.text} ${cell.head} is not ${expected}`);
    }
    const label = (await chart.locator("canvas").getAttribute("aria-label"))!;
    assert.match(label, { model: /mm\)/, prototype: /\(m\).*\(kN\/m\)|\(kN\/m\).*\(m\)/, dimensionless: /\/D/ }[system]!);
    await take_screenshot(page, `units_${system}`);
  }
  await context.close();
});

const sand = { size: 1e4, stress: "\u03b3\u2032 D", force: "\u03b3\u2032 D\u00b2", energy: "\u03b3\u2032 D\u00b3" };
const clay = { size: 100, stress: "s_u", force: "D s_u", energy: "D\u00b2 s_u" };

test("units_offered_are_those_that_the_runs_have", async (t) => {
  if (main_chart === "any") return t.skip("no pipe in these runs");
  const offered = async (change: (run: RunData) => void) => {
    const file = changed_report((changed) => (changed.runs = changed.runs.filter((run) => run.diameter !== null)).forEach(change));
    const { page, context } = await open_report(browser, { file });
    const options = await page.locator(".chart_units option").allTextContents();
    await context.close();
    return options;
  };
  assert.deepEqual(await offered((run) => Object.assign(run, { measure: clay, prototype: null })), ["model (mm, N/m)", "dimensionless (w/D, V/(D s_u))"]);
  assert.deepEqual(
    await offered((run) => Object.assign(run, { measure: sand, prototype: 50 })),
    ["model (mm, N/m)", "dimensionless (w/D, V/(\u03b3\u2032 D\u00b2))", "prototype (m, kN/m)"]);
  assert.deepEqual(await offered((run) => Object.assign(run, { measure: null, prototype: null })), []);
});

/** The report with one run more, that has neither a measure nor a prototype. */
function with_a_run_without(): string {
  return changed_report((changed) => {
    const run = changed.runs.find((each) => each.diameter !== null)!;
    changed.runs = [run, { ...run, name: "lacking", measure: null, prototype: null, film: null }];
    Object.assign(run, { measure: sand, prototype: 50 });
  });
}

test("a_run_without_prototype_is_left_out_and_named", async (t) => {
  if (main_chart === "any") return t.skip("no pipe in these runs");
  const { page, context, errors } = await open_report(browser, { file: with_a_run_without() });
  const names = async (id: string) => chart_of(page, id).locator(".chart_readout tbody th span").allTextContents();
  const chart = (await chart_of(page, "H_u").count()) > 0 ? "H_u" : "V_w";
  const select = page.locator(".chart_units");
  assert.ok((await names(chart)).includes("lacking"));
  for (const system of ["prototype", "dimensionless"]) {
    await select.selectOption(system);
    assert.match((await select.locator("option:checked").textContent())!, /; leaves out 1 of 2 runs\)$/);
    assert.ok(!(await names(chart)).includes("lacking"), `${system} still shows the run that has none`);
    assert.match((await page.locator(".chart_note").textContent())!, /left out.*: lacking\.$/);
    assert.ok((await cells_of(chart_of(page, chart))).every((cell) => cell.value === null || Number.isFinite(Number(cell.text.replace("\u2013", "0")))));
  }
  await select.selectOption("model");
  assert.ok((await names(chart)).includes("lacking"));
  assert.equal(await page.locator(".chart_note").textContent(), "");
  assert.deepEqual(errors, []);
  await context.close();
});

test("the_published_numbers_are_scaled_as_the_runs_of_its_test", async (t) => {
  if (main_chart === "any") return t.skip("no pipe in these runs");
  const axis_end = async (change: (changed: PageData) => void) => {
    const file = changed_report((changed) => {
      const run = changed.runs.find((each) => each.diameter !== null)!;
      changed.runs = [{ ...run, name: "other", measure: clay, prototype: null, film: null, of_test: false }, run];
      Object.assign(run, { measure: sand, prototype: 50, of_test: true });
      changed.published = [{ chart: main_chart as "H_u" | "V_w", x: null, y: 1e6, label: "far beyond" }];
      change(changed);
    });
    const { page, context } = await open_report(browser, { file });
    await page.locator(".chart_units").selectOption("prototype");
    const [, end] = await range_of(chart_of(page, main_chart), main_chart === "H_u" ? "y" : "x");
    await context.close();
    return end;
  };
  const end = await axis_end(() => {});
  assert.ok(end > 5e4 && end < 6e4, `50 times 1000 kN/m, and the axis ends at ${end}`);
  assert.ok((await axis_end((changed) => changed.runs.forEach((run) => (run.of_test = false)))) < 5e4, "no number of a run without prototype");
});
