// SPDX-License-Identifier: BSD-3-Clause
// Numbers and units as the page shows them.

/** A unit for display: shown value = value / factor. */
export interface Unit {
  name: string;
  factor: number;
}

const forces = ["Pa", "N/m", "N", "N m"];

/** The unit that shows values up to `largest` with few digits; a pure number is shown without one. */
export function display_unit(unit: string, largest: number): Unit {
  if (unit === "1") return { name: "–", factor: 1 };
  if (forces.includes(unit) && largest >= 1e6) return { name: `M${unit}`, factor: 1e6 };
  if (forces.includes(unit) && largest >= 1e3) return { name: `k${unit}`, factor: 1e3 };
  if (unit === "m/s" && largest > 0 && largest < 5e-7) return { name: "nm/s", factor: 1e-9 };
  if (unit === "m/s" && largest > 0 && largest < 5e-4) return { name: "µm/s", factor: 1e-6 };
  if ((unit === "m" || unit === "m/s") && largest < 0.5) return { name: `m${unit}`, factor: 1e-3 };
  return { name: unit, factor: 1 };
}

/** A number with so many significant digits; a minus sign, not a hyphen. */
export function digits(value: number, significant = 3): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e6) return value.toExponential(significant - 1).replace("e+", "e").replaceAll("-", "−");
  return value.toFixed(Math.max(0, significant - 1 - Math.floor(Math.log10(size)))).replace("-", "−");
}

/** Round numbers from `from` to `to`, about `wanted` of them, and how many decimals they need. */
export function ticks(from: number, to: number, wanted: number): { values: number[]; decimals: number } {
  const rough = (to - from) / Math.max(1, wanted);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((s) => s * power >= rough * 0.999)! * power;
  const values = [];
  for (let i = Math.ceil(from / step - 1e-9); i <= to / step + 1e-9; i++) values.push(i * step);
  return { values, decimals: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
}

/** A place in m, on a line that is `length` long: as many digits as tell a hundredth of that apart, however far the line is from the origin. */
export function place_text(at: number, length: number): string {
  if (!(Math.abs(at) > 10 * length)) return digits(at);
  return at.toFixed(Math.max(0, 2 - Math.floor(Math.log10(length)))).replace("-", "−");
}

/** What the numbers of an axis count from: 0, or a round number where the axis is so far from the origin that they would have no room. */
export function axis_base(from: number, to: number): number {
  const far = Math.max(Math.abs(from), Math.abs(to)), length = to - from;
  if (!(far > 1000 && far > 1000 * length)) return 0;
  const power = 10 ** Math.ceil(Math.log10(10 * length));
  return Number((Math.round((from + to) / 2 / power) * power).toPrecision(12));
}

/** The title of such an axis, x (mm) or x − 500000 m (mm). */
export function axis_title(name: string, base: number, unit: string): string {
  return base === 0 ? `${name} (${unit})` : `${name} ${base < 0 ? "+" : "−"} ${Math.abs(base)} m (${unit})`;
}

/** A tick's number. */
export function tick_text(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text.replace("-", "−");
}
