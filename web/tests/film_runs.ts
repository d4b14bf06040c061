// SPDX-License-Identifier: BSD-3-Clause
// The films of the report under test, and where their pictures show what.
import type { Page } from "playwright-core";
import type { FilmData, RunData } from "../src/data";
import { MARGIN } from "../src/film_axes";
import { REGION, window_of } from "../src/film_camera";
import { common_region, type FilmedRun } from "../src/film_together";
import { report_data } from "./browser";
import { panel, type Pixels } from "./film_page";

export const runs = report_data().runs.filter((run) => run.film !== null);
export const one_film = runs.length < 2 && "the report has one film only";

/** The run that a panel shows. */
export async function run_of(page: Page, place: number): Promise<RunData> {
  const name = await panel(page, place).getAttribute("data-run");
  return runs.find((run) => run.name === name)!;
}

export function last_of(run: RunData): number {
  return run.film!.frames.length - 1;
}

/** The frame of the drag whose w is nearest, by the words of the page's button. */
export function frame_of_drag(run: RunData, w: number): number {
  const names = new Set(run.drag.rows.map((row) => run.stage[row]));
  const frames = run.film!.frames.map((frame, i) => ({ i, away: Math.abs(frame.w! - w), drag: names.has(frame.stage) }));
  const drag = frames.filter((frame) => frame.drag);
  return (drag.length > 0 ? drag : frames).sort((a, b) => a.away - b.away || a.i - b.i)[0].i;
}

/** What the panels show where they are not moved: of the run in one of them, beside those in the others. */
export async function region_of(page: Page, place: number): Promise<FilmData["view"]> {
  const shown = [];
  for (let i = 0; i < (await page.locator(".film-panel").count()); i++) shown.push((await run_of(page, i)) as FilmedRun);
  return common_region(shown[place], shown);
}

/** Where the picture that shows a region has a point of the model. */
export function view_of(region: FilmData["view"], picture: Pixels) {
  const plot = { width: picture.width - MARGIN.left - MARGIN.right, height: picture.height - MARGIN.top - MARGIN.bottom };
  const window = window_of(REGION, region, plot.width / plot.height);
  const scale = plot.width / window.width;
  type Place = readonly [number, number];
  const at = (x: number, y: number): Place => [
    MARGIN.left + plot.width / 2 + (x - window.x) * scale, MARGIN.top + plot.height / 2 - (y - window.y) * scale];
  const inside = ([x, y]: Place) =>
    x > MARGIN.left + 2 && x < picture.width - MARGIN.right - 2 && y > MARGIN.top + 2 && y < picture.height - MARGIN.bottom - 2;
  return { scale, at, inside };
}
