// SPDX-License-Identifier: BSD-3-Clause
// A film as a file that every program shows: an animated GIF, frame by frame from pictures of the panels.
import { applyPalette, GIFEncoder, quantize } from "gifenc";

/** Milliseconds that the last frame stays. */
const LAST_STAYS = 1500;

/** Pictures beside one another on white, `height` high. */
function side_by_side(pictures: HTMLCanvasElement[], height: number): ImageData {
  const canvas = document.createElement("canvas");
  canvas.width = pictures.reduce((sum, picture) => sum + picture.width, 0);
  canvas.height = height;
  const context = canvas.getContext("2d", { willReadFrequently: true })!;
  context.fillStyle = "#ffffff";
  context.fillRect(0, 0, canvas.width, canvas.height);
  let x = 0;
  for (const picture of pictures) {
    context.drawImage(picture, x, 0);
    x += picture.width;
  }
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** Gives the reader the frames as a GIF; `moment` makes the pictures of one (null: not loaded), `tell` hears how many are done. */
export async function save_film(
  count: number, frames_per_second: number, moment: (frame: number) => (HTMLCanvasElement | null)[], name: string, tell: (done: number) => void,
): Promise<void> {
  const gif = GIFEncoder();
  // Captions may have a line more in one frame than in another.
  const heights = [0, count - 1].flatMap((frame) => moment(frame).map((picture) => picture?.height ?? 0));
  const height = Math.max(...heights) + 18;
  for (let frame = 0; frame < count; frame++) {
    const pictures = moment(frame).filter((picture) => picture !== null);
    if (pictures.length === 0) return;
    const { data, width } = side_by_side(pictures, height);
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
