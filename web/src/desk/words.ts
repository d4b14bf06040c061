// SPDX-License-Identifier: BSD-3-Clause
// Numbers in words, messages, and pictures that come as text.
import { element } from "../element";
import { make } from "../film_elements";
import { digits, display_unit } from "../film_numbers";

export function duration_words(seconds: number | null): string {
  if (seconds === null || !Number.isFinite(seconds)) return "an unknown time";
  if (seconds < 90) return `${Math.max(1, Math.round(seconds))} s`;
  if (seconds < 5400) return `${Math.round(seconds / 60)} min`;
  return `${(seconds / 3600).toFixed(1)} h`;
}

export function bytes_words(bytes: number): string {
  return bytes < 1e6 ? `${Math.max(1, Math.round(bytes / 1e3))} kB` : bytes < 1e9 ? `${Math.round(bytes / 1e6)} MB` : `${(bytes / 1e9).toFixed(1)} GB`;
}

/** "4.11 kN/m". */
export function value_words(value: number, unit: string): string {
  const { name, factor } = display_unit(unit, Math.abs(value));
  return `${digits(value / factor)}${unit === "1" ? "" : ` ${name}`}`;
}

/** Calls once nothing was asked for so many ms. */
export function hurry(ms: number, act: () => void): () => void {
  let waiting = 0;
  return () => {
    clearTimeout(waiting);
    waiting = window.setTimeout(act, ms);
  };
}

/** A message at the foot of the page, which goes by itself. */
export function say(message: string, look: "good" | "bad" = "good"): void {
  const box = make("p", `message ${look}`, message);
  box.setAttribute("role", look === "bad" ? "alert" : "status");
  document.querySelector(".messages")!.append(box);
  setTimeout(() => box.remove(), look === "bad" ? 12_000 : 4_000);
}

/** An SVG that came as text, as an image: nothing in it can act. */
export function picture_of(svg: string, words: string): HTMLImageElement {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  const image = element("img", { src: address, alt: words });
  image.addEventListener("load", () => URL.revokeObjectURL(address));
  return image;
}

/** Keeps a file that berm made. */
export function download(file: Blob, name: string): void {
  const address = URL.createObjectURL(file), link = element("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
