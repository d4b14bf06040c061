// SPDX-License-Identifier: BSD-3-Clause
// A film as a file that every program shows: an animated GIF, frame by frame from pictures of the panels.
import { applyPalette, GIFEncoder, quantize } from "gifenc";

/** Milliseconds that the last frame stays. */
const LAST_STAYS = 1500;

/** Pictures beside one another on white, each in a column of its width, which is empty where there is none, `height` high. */
function side_by_side(pictures: (HTMLCanvasElement | null)[], widths: number[], height: number): ImageData {
  const canvas = document.createElement("canvas");
  canvas.width = widths.reduce((sum, width) => sum + width, 0);
  canvas.height = height;
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, canvas.width, canvas.height);
  let x = 0;
  for (const [i, picture] of pictures.entries()) {
    if (picture !== null && widths[i] > 0) context.drawImage(picture, x, 0);
    x += widths[i];
  }
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** Gives the reader the frames as a GIF; `moment` makes the pictures of one (null: not loaded), `tell` hears how many are done. */
export async function save_film(
  count: number, frames_per_second: number, moment: (frame: number) => (HTMLCanvasElement | null)[], name: string, tell: (done: number) => void,
): Promise<void> {
  const gif = GIFEncoder();
  // Captions may have a line more in one frame than in another; all frames have one size, also where a panel is loaded in some of them only.
  const samples = [0, count - 1].map(moment);
  const height = Math.max(...samples.flat().map((picture) => picture?.height ?? 0)) + 18;
  const widths = samples[0].map((_, i) => Math.max(...samples.map((pictures) => pictures[i]?.width ?? 0)));
  if (widths.every((width) => width === 0)) return;
  for (let frame = 0; frame < count; frame++) {
    const { data, width } = side_by_side(moment(frame), widths, height);
    const palette = quantize(data, 256);
    const delay = frame === count - 1 ? LAST_STAYS : 1000 / frames_per_second;
    gif.writeFrame(applyPalette(data, palette), width, height, { palette, delay });
    tell(frame + 1);
    // The page stays alive.
    await new Promise((done) => setTimeout(done));
  }
  gif.finish();
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([gif.bytes().slice().buffer], { type: "image/gif" }));
  link.download = `${name.replaceAll(/[^\p{L}\p{N}._-]+/gu, "_")}.gif`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
