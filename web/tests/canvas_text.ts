// SPDX-License-Identifier: BSD-3-Clause
// What the page writes on its canvases, and where.
import type { Locator, Page } from "playwright-core";

/** A text as it was last drawn; the box in px of the page from the canvas's left top corner. */
export interface Written {
  text: string;
  left: number;
  top: number;
  right: number;
  bottom: number;
}

declare global {
  interface Window {
    written_on: WeakMap<HTMLCanvasElement, Written[]>;
  }
}

/** To be run in the page before its own script: remembers the texts of each canvas. */
export function remember_texts(): void {
  window.written_on = new WeakMap();
  const { prototype } = CanvasRenderingContext2D;
  const fillText = prototype.fillText;
  prototype.fillText = function (text: string, x: number, y: number) {
    const size = this.measureText(text), { a, b, c, d, e, f } = this.getTransform();
    const xs = [x - size.actualBoundingBoxLeft, x + size.actualBoundingBoxRight], ys = [y - size.actualBoundingBoxAscent, y + size.actualBoundingBoxDescent];
    const corners = xs.flatMap((px) => ys.map((py) => [(a * px + c * py + e) / devicePixelRatio, (b * px + d * py + f) / devicePixelRatio]));
    const ends = (axis: number) => corners.map((corner) => corner[axis]);
    const list = window.written_on.get(this.canvas) ?? [];
    window.written_on.set(this.canvas, list);
    list.push({ text, left: Math.min(...ends(0)), right: Math.max(...ends(0)), top: Math.min(...ends(1)), bottom: Math.max(...ends(1)) });
    fillText.call(this, text, x, y);
  };
}

/** Lets all canvases be drawn anew, for what stands on them now to be known. */
export async function write_anew(page: Page): Promise<void> {
  await page.evaluate(async () => {
    window.written_on = new WeakMap();
    document.dispatchEvent(new Event("theme"));
    for (let i = 0; i < 4; ++i) await new Promise(requestAnimationFrame);
  });
}

export async function texts_on(canvas: Locator): Promise<{ texts: Written[]; width: number; height: number }> {
  return canvas.evaluate((each: HTMLCanvasElement) => ({ texts: window.written_on.get(each) ?? [], width: each.clientWidth, height: each.clientHeight }));
}

/** Pairs of texts that lie over each other. */
export function overlapping(texts: Written[]): [string, string][] {
  return texts.flatMap((a, i) => texts.slice(i + 1).flatMap((b): [string, string][] =>
    a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom ? [[a.text, b.text]] : []));
}

/** Texts that lie partly beyond a box. */
export function beyond(texts: Written[], box: { left: number; top: number; right: number; bottom: number }): string[] {
  return texts.filter((each) => each.left < box.left || each.top < box.top || each.right > box.right || each.bottom > box.bottom).map((each) => each.text);
}
