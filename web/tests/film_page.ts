// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the animation do with a page: wait for its panels, read pixels.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { inflateSync } from "node:zlib";
import type { Browser, Locator, Page } from "playwright-core";
import { open_report, type OpenReport, report_file } from "./browser";

type Use = (page: Page, report: OpenReport) => Promise<void>;

/** A function that opens the report with its panels drawn, tests it, and sees that nothing went wrong in the console. */
export function with_film_page(browser: () => Browser): (painter: "" | "webgl" | "2d", use: Use, file?: string) => Promise<void> {
  return async (painter, use, file = report_file()) => {
    const report = await open_report(browser(), { file });
    try {
      if (painter !== "") await report.page.goto(`${pathToFileURL(file).href}?painter=${painter}`);
      await panels_ready(report.page);
      await use(report.page, report);
      assert.deepEqual(report.errors, []);
    } finally {
      await report.context.close();
    }
  };
}

export function panel(page: Page, place: number): Locator {
  return page.locator(".film-panel").nth(place);
}

/** Waits until all panels have drawn; the first is in sight then. */
export async function panels_ready(page: Page): Promise<void> {
  await page.locator(".film-stage").first().scrollIntoViewIfNeeded();
  await page.waitForFunction(() => {
    const panels = [...document.querySelectorAll<HTMLElement>(".film-panel")];
    return panels.length > 0 && panels.every((one) => one.dataset.state === "ready" && Number(one.dataset.framesDrawn) > 0);
  });
}

export async function number_of(one: Locator, name: "frame" | "frames-drawn"): Promise<number> {
  return Number(await one.getAttribute(`data-${name}`));
}

/** Does something to the page and waits until the panel has drawn because of it. */
export async function after_drawing(one: Locator, action: () => Promise<unknown>): Promise<void> {
  const before = await number_of(one, "frames-drawn");
  await action();
  const handle = await one.elementHandle();
  await one.page().waitForFunction(([element, drawn]) => Number((element as HTMLElement).dataset.framesDrawn) > (drawn as number), [handle, before] as const);
  await quiet(one.page());
}

/** Waits until the panels have nothing left to draw. */
export async function quiet(page: Page): Promise<void> {
  await page.evaluate(async () => {
    const drawn = () => [...document.querySelectorAll<HTMLElement>(".film-panel")].map((one) => `${one.dataset.framesDrawn} ${one.dataset.state}`).join();
    for (let still = 0, before = drawn(); still < 4; ) {
      await new Promise(requestAnimationFrame);
      still = drawn() === before && !before.includes("loading") ? still + 1 : 0;
      before = drawn();
    }
  });
}

export async function set_frame(one: Locator, frame: number): Promise<void> {
  await one.locator(".film-frame").evaluate((slider: HTMLInputElement, value) => {
    slider.value = String(value);
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, frame);
  await quiet(one.page());
}

/** The picture of a panel as it is on the screen. */
export interface Pixels {
  width: number;
  height: number;
  /** r, g, b, a */
  data: ArrayLike<number>;
}

/** Pixels of the picture; `columns` by `rows` of them where that is given, each the mean of what it covers. */
export async function pixels(one: Locator, columns = 0, rows = 0): Promise<Pixels> {
  const png = (await one.locator(".film-stage").screenshot()).toString("base64");
  const { width, height, text, means } = await one.page().evaluate(
    async ([text, wide, high]) => {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d")!;
      context.drawImage(image, 0, 0);
      const { width, height } = image;
      const data = context.getImageData(0, 0, width, height).data;
      if (wide === 0) {
        let letters = "";
        for (let i = 0; i < data.length; i += 8192) letters += String.fromCharCode(...data.subarray(i, i + 8192));
        return { width, height, text: btoa(letters), means: null };
      }
      const sums = new Float64Array(wide * high * 4);
      const counts = new Float64Array(wide * high);
      for (let y = 0; y < height; y++) {
        for (let x = 0; x < width; x++) {
          const cell = Math.floor((y * high) / height) * wide + Math.floor((x * wide) / width);
          counts[cell]++;
          for (let c = 0; c < 4; c++) sums[4 * cell + c] += data[4 * (y * width + x) + c];
        }
      }
      return { width: wide, height: high, text: "", means: [...sums].map((sum, i) => sum / counts[i >> 2]) };
    },
    [png, columns, rows] as const,
  );
  return { width, height, data: means ?? Buffer.from(text, "base64") };
}

/** Part of the pixels that differ visibly. */
export function difference(a: Pixels, b: Pixels): number {
  let different = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    const away = (c: number) => Math.abs(a.data[i + c] - b.data[i + c]);
    if (away(0) > 8 || away(1) > 8 || away(2) > 8) different++;
  }
  return different / (a.data.length / 4);
}

export function pixel(picture: Pixels, x: number, y: number): number[] {
  const at = 4 * (Math.floor(y) * picture.width + Math.floor(x));
  return [picture.data[at], picture.data[at + 1], picture.data[at + 2]];
}

/** The bytes of a block of the report's file. */
export function block(id: string): Uint8Array {
  const { text } = block_text(readFileSync(report_file(), "utf8"), id);
  return inflateSync(Buffer.from(text, "base64"));
}

/** Where a block stands in the page. */
export function block_text(page: string, id: string): { text: string; at: number } {
  const opened = new RegExp(`<script[^>]*\\bid="?${id}"?[^>]*>`).exec(page);
  if (opened === null) throw new Error(`the report has no block ${id}`);
  const at = opened.index + opened[0].length;
  return { text: page.slice(at, page.indexOf("</script", at)), at };
}
