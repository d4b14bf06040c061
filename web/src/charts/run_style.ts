// SPDX-License-Identifier: BSD-3-Clause
import { svg_element } from "../element";

/** Colour and dashes of a run, the same in all charts; runs differ by dashes too, for eyes and printers without colour. */
export interface RunStyle {
  /** On light and on dark ground. */
  colour: { light: string; dark: string };
  /** Lengths of dashes and gaps, px. */
  dash: number[];
}

// After Okabe and Ito's colours for all eyes, darker or lighter for contrast with the ground.
const colours = [
  { light: "#0868ac", dark: "#58a9ea" },
  { light: "#cc4e0a", dark: "#ff8d50" },
  { light: "#00806a", dark: "#30c49c" },
  { light: "#a63d80", dark: "#e58abf" },
  { light: "#866600", dark: "#dfb125" },
  { light: "#2f8fc9", dark: "#9ad4ff" },
  { light: "#30363d", dark: "#dbe0e6" },
];

const dashes = [[], [9, 4], [2.5, 3], [11, 3, 2.5, 3], [5, 2.5], [11, 3, 2.5, 3, 2.5, 3]];

/** 7 colours and 6 dashes: 42 pairs before one comes again. */
export function run_style(index: number): RunStyle {
  return { colour: colours[index % colours.length], dash: dashes[index % dashes.length] };
}

/** A short piece of the line, for legends. */
export function line_sample(style: RunStyle): SVGSVGElement {
  const line = svg_element("line", { x1: 0, y1: 5, x2: 34, y2: 5, "stroke-width": 2.5, "stroke-dasharray": style.dash.join(" ") || null });
  const sample = svg_element("svg", { width: 34, height: 10, "aria-hidden": "true", class: "line_sample" }, line);
  sample.style.setProperty("--light", style.colour.light);
  sample.style.setProperty("--dark", style.colour.dark);
  return sample;
}
