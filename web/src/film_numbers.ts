// SPDX-License-Identifier: BSD-3-Clause
// Numbers and units as the page shows them.

/** A unit for display: shown value = value / factor. */
export interface Unit {
  name: string;
  factor: number;
}

/** The unit that shows values up to `largest` with few digits; a pure number is shown without one. */
export function display_unit(unit: string, largest: number): Unit {
  if (unit === "1") return { name: "–", factor: 1 };
  if (["Pa", "N/m", "N"].includes(unit) && largest >= 1e6) return { name: `M${unit}`, factor: 1e6 };
  if (["Pa", "N/m", "N"].includes(unit) && largest >= 1e3) return { name: `k${unit}`, factor: 1e3 };
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

/** A tick's number. */
export function tick_text(value: number, decimals: number): string {
  const text = value.toFixed(decimals);
  return Number(text) === 0 ? (0).toFixed(decimals) : text.replace("-", "−");
}
