// SPDX-License-Identifier: BSD-3-Clause
// A screenshot as a PNG of 128 colours, which takes half of the bytes or less.
import gifenc from "gifenc";
import type { Page } from "playwright-core";
import { deflateSync } from "node:zlib";

const colours = 128;

/** The pixels of a PNG, red, green, blue and opacity, as the browser decodes them. */
async function pixels_of(page: Page, png: Buffer): Promise<{ width: number; height: number; pixels: Uint8Array }> {
  const blank = await page.context().newPage();
  const { width, height, text } = await blank.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)), image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(image.width, image.height), ctx = canvas.getContext("2d")!;
    ctx.drawImage(image, 0, 0);
    const { data } = ctx.getImageData(0, 0, image.width, image.height);
    let letters = "";
    for (let at = 0; at < data.length; at += 8192) letters += String.fromCharCode(...data.subarray(at, at + 8192));
    return { width: image.width, height: image.height, text: btoa(letters) };
  }, png.toString("base64"));
  await blank.close();
  return { width, height, pixels: new Uint8Array(Buffer.from(text, "base64")) };
}

/** As PNG wants it. */
function crc32(bytes: Uint8Array): number {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

function chunk(type: string, data: Uint8Array): Buffer {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]), whole = Buffer.alloc(body.length + 8);
  whole.writeUInt32BE(data.length, 0);
  body.copy(whole, 4);
  whole.writeUInt32BE(crc32(body), body.length + 4);
  return whole;
}

export async function in_few_colours(page: Page, png: Buffer): Promise<Buffer> {
  const { width, height, pixels } = await pixels_of(page, png);
  const palette = gifenc.quantize(pixels, colours), indices = gifenc.applyPalette(pixels, palette);
  const rows = Buffer.alloc(height * (width + 1)); // a filter of 0 before each row
  for (let row = 0; row < height; ++row) rows.set(indices.subarray(row * width, (row + 1) * width), row * (width + 1) + 1);
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 3, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk("IHDR", header), chunk("PLTE", Uint8Array.from(palette.flatMap((colour: number[]) => colour.slice(0, 3)))), chunk("IDAT", deflateSync(rows, { level: 9 })),
    chunk("IEND", new Uint8Array())]);
}
