// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { RunData } from "../src/data";
import { changed_report, launch_browser, open_report, read_history, take_screenshot } from "./browser";
import { assert_as_in_history, cells_of, chart_of, charts_of_report, drag, history_numbers, history_rows, pixels, point_at, range_of, unfolded_charts, unit_in } from "./charts";

let browser: Browser;
before(async () => void (browser = await launch_browser()));
after(() => browser.close());

const { data, pushed, dragged, main_chart, main_column } = charts_of_report();

test("hover_reads_rows_of_history_in_every_chart", async () => {
  const { page, context, errors } = await open_report(browser);
  const charts = await (await unfolded_charts(page)).all();
  assert.ok(charts.length > 0);
  for (const chart of charts) {
    const id = await chart.getAttribute("data-chart");
    const seen = new Set<string>();
    for (const [across, down] of [[0.2, 0.3], [0.5, 0.6], [0.8, 0.5]]) {
      await point_at(page, chart, across, down);
      const cells = await cells_of(chart);
      assert.ok(assert_as_in_history(cells) > 0, `${id} shows no column of history.csv`);
      seen.add(cells.map((cell) => cell.row).join());
      for (const { run, row } of cells) {
        const time = cells.find((cell) => cell.run === run && cell.row === row && cell.column === "time_s")!;
        assert.equal(time.value, history_numbers(run, "time_s")[row]);
      }
    }
    assert.ok(seen.size > 1, `the readout of ${id} does not follow the mouse`);
  }
  assert.deepEqual(errors, []);
  await context.close();
});

/** Of rows the one whose argument is nearest to a number: its distance from that. */
function least_distance(arguments_: (number | null)[], rows: number[], to: number): number {
  return Math.min(...rows.map((row) => Math.abs((arguments_[row] ?? Infinity) - to)));
}

test("hover_reads_the_row_nearest_the_cursor", async (t) => {
  if (dragged.length === 0 && pushed.length === 0) return t.skip("no pipe in these runs");
  const { page, context } = await open_report(browser);
  const charts: [string, RunData[], "push" | "drag"][] = [["V_w", pushed, "push"], ["H_u", dragged, "drag"]];
  for (const [id, runs, path] of charts) {
    if (runs.length === 0) continue;
    const chart = chart_of(page, id);
    // V(w) is upright: its argument runs down the y axis.
    const axis = path === "push" ? "y" : "x";
    const [low, high] = await range_of(chart, axis);
    for (const part of [0.15, 0.45, 0.7]) {
      const place = await point_at(page, chart, part, part);
      const cells = await cells_of(chart);
      const head = cells.find((cell) => (path === "push" ? cell.column === "w_m" : cell.column.startsWith("u_m -")))!.head;
      const wanted = (low + (high - low) * place[axis === "x" ? 0 : 1]) * unit_in(head);
      const pixel = ((high - low) / 300) * unit_in(head);
      for (const run of runs) {
        const arguments_ = history_numbers(run.name, path === "push" ? "w_m" : "u_m").map((value) =>
          value === null ? null : path === "push" ? value : value - run.drag.u_begin);
        const rows = history_rows(run, path);
        const { row } = cells.find((cell) => cell.run === run.name)!;
        assert.ok(rows.includes(row), `${id} of ${run.name}: row ${row} is not of the ${path}`);
        const distance = Math.abs(arguments_[row]! - wanted);
        assert.ok(distance <= least_distance(arguments_, rows, wanted) + pixel, `${id} of ${run.name}: row ${row} is not the nearest`);
      }
    }
  }
  await context.close();
});

test("mean_of_the_readout_is_what_the_program_made", async (t) => {
  if (dragged.length === 0) return t.skip("no drag in these runs");
  const { page, context } = await open_report(browser);
  const chart = chart_of(page, "H_u");
  await point_at(page, chart, 0.4, 0.5);
  for (const cell of (await cells_of(chart)).filter((each) => each.column === "H_N_m mean")) {
    const run = data.runs.find((each) => each.name === cell.run)!;
    assert.equal(cell.value, run.drag.H_mean[history_rows(run, "drag").indexOf(cell.row)]);
  }
  await context.close();
});

test("run_checkbox_turns_the_run_off_in_all_charts", async () => {
  const { page, context } = await open_report(browser);
  const run = (dragged[0] ?? pushed[0] ?? data.runs[0]).name;
  const chart = chart_of(page, main_chart);
  const [lines, drawn] = [Number(await chart.getAttribute("data-lines")), await pixels(chart)];
  const box = page.locator(".chart_runs input").nth(data.runs.findIndex((each) => each.name === run));
  await box.click();
  assert.ok(Number(await chart.getAttribute("data-lines")) < lines);
  assert.ok((await pixels(chart)) !== drawn, "the picture has not changed");
  for (const each of await (await unfolded_charts(page)).and(page.locator(":not(.chart_own_key)")).all())
    assert.ok(!(await cells_of(each)).some((cell) => cell.run === run), `${await each.getAttribute("data-chart")} still shows ${run}`);
  await box.press("Space");
  assert.ok((await pixels(chart)) === drawn, "the picture is not what it was");
  await context.close();
});

test("raw_rows_and_the_published_numbers_can_be_turned_off", async (t) => {
  if (main_chart === "any") return t.skip("no pipe in these runs");
  const { page, context } = await open_report(browser);
  const chart = chart_of(page, main_chart);
  const [lines, drawn] = [Number(await chart.getAttribute("data-lines")), await pixels(chart)];
  await page.locator(".chart_raw").uncheck();
  assert.equal(Number(await chart.getAttribute("data-lines")), lines / 2, "of raw and mean lines the means are left");
  await page.locator(".chart_raw").check();
  assert.ok((await pixels(chart)) === drawn, "the picture is not what it was");
  assert.equal(await page.locator(".chart_published").count(), data.published.length > 0 ? 1 : 0);
  await context.close();

  const level = Math.max(...data.runs.filter((run) => main_column in run.columns).flatMap((run) => history_numbers(run.name, main_column).map((each) => each ?? 0)));
  const file = changed_report((changed) => {
    changed.published = [{ chart: main_chart === "H_u" ? "H_u" : "V_w", x: null, y: 3 * level, label: "three times as much" }];
  });
  const { page: with_published, context: its_context } = await open_report(browser, { file });
  const marked = chart_of(with_published, main_chart);
  const seen = await pixels(marked);
  const axis = main_chart === "H_u" ? "y" : "x";
  const [, top] = await range_of(marked, axis);
  await with_published.locator(".chart_published").uncheck();
  assert.ok((await pixels(marked)) !== seen, "the picture has not changed");
  assert.ok((await range_of(marked, axis))[1] < 0.7 * top, "the axis no longer reaches up to the paper's level");
  await its_context.close();
});

test("drag_zooms_and_reset_shows_all_again", async () => {
  const { page, context } = await open_report(browser);
  const chart = chart_of(page, main_chart);
  const drawn = await pixels(chart);
  const [x, y] = [await range_of(chart, "x"), await range_of(chart, "y")];
  const reset = chart.locator(".chart_reset");
  assert.ok(await reset.isDisabled());
  const zoom = async () => {
    await drag(page, chart, [0.25, 0.25], [0.75, 0.75]);
    for (const [axis, full] of [["x", x], ["y", y]] as const) {
      const [low, high] = await range_of(chart, axis);
      const part = (high - low) / (full[1] - full[0]);
      assert.ok(part > 0.48 && part < 0.52, `${axis}: half of the axis was chosen, ${part} of it is seen`);
      assert.ok(low > full[0] && high < full[1]);
    }
    assert.ok((await pixels(chart)) !== drawn, "the picture has not changed");
  };
  const all_seen = async () => {
    assert.deepEqual([await range_of(chart, "x"), await range_of(chart, "y")], [x, y]);
    assert.ok((await pixels(chart)) === drawn, "the picture is not what it was");
  };
  await zoom();
  await reset.click();
  await all_seen();
  await zoom();
  await chart.locator(".u-over").dblclick({ position: { x: 60, y: 60 } });
  await all_seen();
  await context.close();
});

test("arrow_keys_move_the_cursor_from_row_to_row", async () => {
  const { page, context, errors } = await open_report(browser);
  const chart = chart_of(page, main_chart);
  await chart.locator(".chart_plot").focus();
  const first_row = async () => (await cells_of(chart))[0].row;
  await page.keyboard.press("Home");
  const begin = await first_row();
  const rows: number[] = [];
  for (const key of ["ArrowRight", "ArrowRight", "ArrowDown", "ArrowLeft", "PageDown", "PageUp", "End"]) {
    await page.keyboard.press(key);
    assert.ok(assert_as_in_history(await cells_of(chart)) > 0);
    rows.push(await first_row());
  }
  assert.deepEqual(rows.slice(0, 4), [begin + 1, begin + 2, begin + 3, begin + 2]);
  assert.ok(rows[4] > rows[3] && rows[5] < rows[4]);
  assert.ok(rows[6] >= Math.max(...rows));
  assert.ok((await chart.locator(".chart_told").textContent())!.includes(String(rows[6])));
  assert.deepEqual(errors, []);
  await context.close();
});

test("a_finger_reads_rows_too", async () => {
  const { page, context } = await open_report(browser, { viewport: { width: 400, height: 800 }, hasTouch: true, isMobile: true });
  const chart = chart_of(page, main_chart);
  const over = chart.locator(".u-over");
  await over.scrollIntoViewIfNeeded();
  const rows = new Set<number>();
  for (const part of [0.2, 0.6]) {
    const box = (await over.boundingBox())!;
    await over.tap({ position: { x: part * box.width, y: part * box.height } });
    assert.ok(assert_as_in_history(await cells_of(chart)) > 0);
    rows.add((await cells_of(chart))[0].row);
  }
  assert.equal(rows.size, 2);

  // The finger moves without leaving the glass.
  const touch = await context.newCDPSession(page);
  const box = (await over.boundingBox())!;
  const at = (part: number) => [{ x: box.x + part * box.width, y: box.y + part * box.height }];
  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: at(0.1) });
  const begin = (await cells_of(chart))[0].row;
  for (const part of [0.2, 0.3, 0.4]) await touch.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: at(part) });
  assert.notEqual((await cells_of(chart))[0].row, begin);
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  await context.close();
});

test("any_column_is_shown_over_any_other", async () => {
  const { page, context } = await open_report(browser);
  assert.equal(await chart_of(page, "any").isVisible(), false, "it is folded");
  await unfolded_charts(page);
  const chart = chart_of(page, "any");
  const columns = Object.keys(data.runs[0].columns);
  const [value, argument] = [columns.at(-1)!, columns.find((name) => name !== "time_s" && name !== columns.at(-1))!];
  await chart.locator(".chart_value").selectOption(value);
  await chart.locator(".chart_argument").selectOption(argument);
  await point_at(page, chart, 0.5, 0.5);
  const cells = await cells_of(chart);
  assert.deepEqual([...new Set(cells.map((cell) => cell.column))].sort(), [...new Set(["time_s", argument, value])].sort());
  for (const cell of cells.filter((each) => read_history(each.run).has(each.column))) assert.equal(cell.value, history_numbers(cell.run, cell.column)[cell.row]);
  await context.close();
});

test("charts_of_energy_contact_and_noise_are_folded_below_trust", async () => {
  const { page, context } = await open_report(browser);
  const ids = (place: string) => page.locator(`${place} .chart`).evaluateAll((all) => all.map((each) => (each as HTMLElement).dataset.chart!));
  const of_trust = await ids("#trust .chart_fold"), of_curves = await ids("#curves");
  for (const id of ["energies", "kinetic_over_internal", "out_of_balance"]) assert.ok(of_trust.includes(id), of_trust.join());
  if (dragged.length > 0) for (const id of ["gap", "H_noise"]) assert.ok(of_trust.includes(id), of_trust.join());
  assert.ok(of_curves.every((id) => /^(V_w|H_u|w_u|H_over_V|H_V|R_lift|p_y|water_|any)/.test(id)), of_curves.join());
  assert.equal(await page.locator("#trust .chart").first().isVisible(), false);
  await unfolded_charts(page);
  assert.equal(await page.locator("#trust .chart").first().isVisible(), true);
  await context.close();
});

test("charts_without_data_do_not_appear", async () => {
  const file = changed_report((changed) => {
    for (const run of changed.runs) {
      run.diameter = null;
      run.push = { rows: [], u_begin: 0, V_mean: [], H_mean: [] };
      run.drag = { rows: [], u_begin: 0, V_mean: [], H_mean: [] };
      for (const name of ["u_m", "w_m", "H_N_m", "V_N_m", "gap_m", "overlap_m", "second_impulse_N_m"]) delete run.columns[name];
      run.columns.out_of_balance = run.columns.out_of_balance.map(() => null);
    }
    changed.published = [];
  });
  const { page, context, errors } = await open_report(browser, { file });
  const ids = await page.locator(".chart").evaluateAll((all) => all.map((each) => (each as HTMLElement).dataset.chart!));
  const without_pipe = ["energies", "kinetic_over_internal", "any"];
  assert.ok(ids.includes("any"));
  assert.ok(ids.every((id) => without_pipe.includes(id)), ids.join());
  assert.deepEqual(errors, []);
  await take_screenshot(page, "without_pipe", true);
  await context.close();
});

test("runs_keep_their_colour_in_all_charts", async () => {
  const { page, context } = await open_report(browser);
  await unfolded_charts(page);
  const look = (sample: string) => page.locator(sample).evaluateAll((all) =>
    all.map((each) => [each.parentElement!.textContent!.trim(), `${getComputedStyle(each).stroke} ${each.querySelector("line")!.getAttribute("stroke-dasharray")}`]));
  const legend = new Map((await look(".chart_runs .line_sample")) as [string, string][]);
  const looks = [...legend.values()].slice(0, 6);
  for (const what of [/^.*\) /, /[^)]*$/]) assert.equal(new Set(looks.map((each) => what.exec(each)![0])).size, looks.length, "no two runs have the same colour, or the same dashes");
  for (const [name, style] of await look(".chart:not(.chart_own_key) .line_sample")) assert.equal(style, legend.get(name));
  await context.close();
});
