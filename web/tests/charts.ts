// SPDX-License-Identifier: BSD-3-Clause
// How the tests read and move a chart of the page.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import type { Locator, Page } from "playwright-core";
import { column_of_label } from "../src/charts/quantity";
import { history_row, type PageData, type RunData } from "../src/data";
import { read_history, report_data } from "./browser";

/** A number in a chart's readout. */
export interface Cell {
  run: string;
  row: number;
  column: string;
  /** SI; null where there is none. */
  value: number | null;
  text: string;
  /** Of its column in the readout. */
  head: string;
}

/** What the report under test has charts of. */
export interface ChartsOfReport {
  data: PageData;
  pushed: RunData[];
  dragged: RunData[];
  /** A chart that it has, of a path where there is one, and the column of history.csv that this shows. */
  main_chart: "H_u" | "V_w" | "any";
  main_column: string;
}

export function charts_of_report(): ChartsOfReport {
  const data = report_data();
  const with_path = (path: "push" | "drag") => data.runs.filter((run) => run.diameter !== null && run[path].rows.length > 1);
  const [pushed, dragged] = [with_path("push"), with_path("drag")];
  const main_chart = dragged.length > 0 ? "H_u" : pushed.length > 0 ? "V_w" : "any";
  const column = (label: string) => data.runs.map((run) => column_of_label(run, label)).find((name) => name !== undefined) ?? "";
  return { data, pushed, dragged, main_chart, main_column: { H_u: column("H"), V_w: column("V"), any: "" }[main_chart] };
}

export function chart_of(page: Page, id: string): Locator {
  return page.locator(`.chart[data-chart="${id}"]`);
}

/** All charts of the sections on curves and trust, unfolded and drawn. */
export async function unfolded_charts(page: Page): Promise<Locator> {
  await page.evaluate(() => document.querySelectorAll<HTMLDetailsElement>("details.chart_fold").forEach((each) => (each.open = true)));
  await page.waitForFunction(() => [...document.querySelectorAll<HTMLElement>("#curves .chart, #trust .chart")].every((each) => each.dataset.x !== undefined));
  return page.locator("#curves .chart, #trust .chart");
}

export async function cells_of(chart: Locator): Promise<Cell[]> {
  return chart.locator(".chart_readout").evaluate((table: HTMLTableElement) => {
    const heads = [...table.rows[0].cells].map((cell) => cell.textContent!);
    return [...table.querySelectorAll<HTMLTableCellElement>("td[data-column]")].map((cell) => ({
      run: cell.dataset.run!, row: Number(cell.dataset.row), column: cell.dataset.column!,
      value: cell.dataset.value === undefined ? null : Number(cell.dataset.value), text: cell.textContent!, head: heads[cell.cellIndex],
    }));
  });
}

/** The range of an axis that is seen. */
export async function range_of(chart: Locator, axis: "x" | "y"): Promise<[number, number]> {
  const [low, high] = (await chart.getAttribute(`data-${axis}`))!.split(" ").map(Number);
  return [low, high];
}

/** Moves the mouse to parts of the plotting area's width and height; gives what parts they are to the pixel. */
export async function point_at(page: Page, chart: Locator, across: number, down: number): Promise<[number, number]> {
  const over = chart.locator(".u-over");
  // Out from under what sticks to the top of the window. At once: a chart is drawn anew where its size or its columns change.
  await over.evaluate((each) => each.scrollIntoView({ block: "center" }));
  const box = (await over.boundingBox())!;
  const x = Math.round(box.x + across * box.width), y = Math.round(box.y + down * box.height);
  await page.mouse.move(x, y);
  return [(x - box.x) / box.width, (y - box.y) / box.height];
}

/** Draws a zoom's rectangle with the mouse. */
export async function drag(page: Page, chart: Locator, from: [number, number], to: [number, number]): Promise<void> {
  await point_at(page, chart, ...from);
  await page.mouse.down();
  const box = (await chart.locator(".u-over").boundingBox())!;
  await page.mouse.move(box.x + to[0] * box.width, box.y + to[1] * box.height, { steps: 4 });
  await page.mouse.up();
}

export async function pixels(chart: Locator): Promise<string> {
  return chart.locator("canvas").evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
}

/** Clicks a button that downloads, and reads the file. */
export async function downloaded(page: Page, chart: Locator, button: string): Promise<{ name: string; text: string }> {
  const [file] = await Promise.all([page.waitForEvent("download"), chart.locator(button).click()]);
  // Chromium drops what a page wants to save beyond ten files a second.
  await page.waitForTimeout(120);
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
}

/** Fields of a file of comma-separated values, with quotes taken off. */
export function csv_rows(text: string): string[][] {
  return text.trimEnd().split("\n").map((line) => [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,]*))/g)].map((found) => (found[1] ?? found[2]).replaceAll('""', '"')));
}

/** How much of SI the unit in an axis title is. */
export function unit_in(title: string): number {
  const units: Record<string, number> = { mm: 1e-3, m: 1, s: 1, "N/m": 1, "kN/m": 1e3, "J/m": 1, "kJ/m": 1e3 };
  const found = / \(([^()]*)\)(, (?:mean|freed from noise))?$/.exec(title);
  return found === null ? 1 : units[found[1]];
}

/** Numbers of history.csv, nan as null. */
export function history_numbers(run: string, column: string): (number | null)[] {
  return read_history(run).get(column)!.map((text) => (Number.isFinite(Number(text)) ? Number(text) : null));
}

/** That cells of columns of history.csv hold its numbers, and show them to five digits in the unit of their head; gives how many there were. */
export function assert_as_in_history(cells: Cell[]): number {
  const compared = cells.filter((cell) => read_history(cell.run).has(cell.column));
  for (const cell of compared) {
    const expected = history_numbers(cell.run, cell.column)[cell.row];
    const where = `${cell.column} of ${cell.run}, row ${cell.row}`;
    assert.equal(cell.value, expected, where);
    if (expected === null) continue;
    const shown = Number(cell.text) * unit_in(cell.head);
    assert.ok(Math.abs(shown - expected) <= 0.6e-4 * Math.abs(expected), `${where}: shown ${cell.text} ${cell.head}, is ${expected}`);
  }
  return compared.length;
}

/** Rows of history.csv that a path of the run has. */
export function history_rows(run: RunData, path: "push" | "drag"): number[] {
  return run[path].rows.map((row) => history_row(run, row));
}
