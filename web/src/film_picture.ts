// SPDX-License-Identifier: BSD-3-Clause
// A panel as a picture for a paper: black on white, with colour bar and caption.
import { PAPER } from "./film_axes";
import { BAR_HEIGHT, type ColourBar, draw_colour_bar } from "./film_colour_bar";

export interface Picture {
  /** px of the page, of what is drawn above colour bar and caption. */
  width: number;
  height: number;
  draw(context: CanvasRenderingContext2D): void;
  /** null: the soil has no field. */
  bar: ColourBar | null;
  bar_title: string;
  caption: string;
  /** Pixels for one px of the page. */
  ratio: number;
}

const LINE = 17;
const FONT = '12.5px system-ui, "DejaVu Sans", sans-serif';

export function compose(picture: Picture): HTMLCanvasElement {
  const { width, ratio } = picture;
  const canvas = document.createElement("canvas");
  const context = canvas.getContext("2d")!;
  context.font = FONT;
  const lines = wrap(context, picture.caption, width - 2 * 12), titles = wrap(context, picture.bar_title, width - 2 * 12);
  const height = picture.height + (picture.bar === null ? 0 : LINE * titles.length + BAR_HEIGHT + 10) + LINE * lines.length + 14;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  context.scale(ratio, ratio);
  context.fillStyle = PAPER.ground;
  context.fillRect(0, 0, width, height);
  picture.draw(context);
  let y = picture.height + 4;
  const write = (text: string) => {
    context.font = FONT;
    context.fillStyle = PAPER.text;
    context.textAlign = "left";
    context.textBaseline = "top";
    context.fillText(text, 12, y);
    y += LINE;
  };
  if (picture.bar !== null) {
    for (const line of titles) write(line);
    draw_colour_bar(context, picture.bar, 12, y, width - 2 * 12, PAPER);
    y += BAR_HEIGHT + 10;
  }
  for (const line of lines) write(line);
  return canvas;
}

/** Gives the reader a file. */
export function save_picture(canvas: HTMLCanvasElement, name: string): void {
  canvas.toBlob((blob) => {
    if (blob === null) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `${name.replaceAll(/[^\p{L}\p{N}._-]+/gu, "_")}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }, "image/png");
}

function wrap(context: CanvasRenderingContext2D, text: string, width: number): string[] {
  const lines: string[] = [];
  for (const word of text.split(" ")) {
    const longer = lines.length === 0 ? word : `${lines[lines.length - 1]} ${word}`;
    if (lines.length === 0 || context.measureText(longer).width > width) lines.push(word);
    else lines[lines.length - 1] = longer;
  }
  return lines;
}
