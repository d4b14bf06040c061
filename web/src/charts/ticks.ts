// SPDX-License-Identifier: BSD-3-Clause

/** The part of an axis that is seen, in the axis's unit. */
export type Range = [low: number, high: number];

/** Where an axis has ticks, and what stands beside them. */
export interface Ticks {
  at: number[];
  labels: string[];
}

/** About `count` ticks over a range; on a logarithmic axis at powers of ten, if there are two of them. */
export function ticks_of([low, high]: Range, logarithmic: boolean, count: number): Ticks {
  return (logarithmic ? powers_of_ten(low, high, count) : null) ?? multiples(low, high, count);
}

/** 1, 2 or 5 times a power of ten, so that about `count` steps make the range. */
function tick_step(range: number, count: number): number {
  const rough = range / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const parts = rough / power;
  return power * (parts < 1.5 ? 1 : parts < 3.5 ? 2 : parts < 7.5 ? 5 : 10);
}

function multiples(low: number, high: number, count: number): Ticks {
  const step = tick_step(high - low, count);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const largest = Math.max(Math.abs(low), Math.abs(high));
  const plain = decimals <= 4 && largest < 1e6;
  const at: number[] = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) at.push(Number((i * step).toPrecision(12)));
  return { at, labels: at.map((value) => signed(plain ? value.toFixed(decimals) : short_exponent(value))) };
}

function powers_of_ten(low: number, high: number, count: number): Ticks | null {
  const first = Math.ceil(Math.log10(low) - 1e-9), last = Math.floor(Math.log10(high) + 1e-9);
  if (last - first < 1) return null;
  const every = Math.ceil((last - first) / Math.max(1, count));
  const at: number[] = [], labels: string[] = [];
  for (let power = first; power <= last; power += every) {
    at.push(10 ** power);
    labels.push(power >= -2 && power <= 3 ? String(Number((10 ** power).toPrecision(3))) : `10${raised(power)}`);
  }
  return { at, labels };
}

function short_exponent(value: number): string {
  if (value === 0) return "0";
  const [digits, power] = value.toExponential(6).split("e");
  return `${Number(digits)}\u00b710${raised(Number(power))}`;
}

function raised(power: number): string {
  const digits = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
  return (power < 0 ? "\u207b" : "") + [...String(Math.abs(power))].map((digit) => digits[Number(digit)]).join("");
}

/** With the minus of print. */
function signed(text: string): string {
  return text.replace("-", "\u2212");
}

/** A number to five digits, as a table of numbers may be read in by other programs. */
export function five_digits(value: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3) return value.toExponential(4);
  return size >= 99999.5 && size < 1e9 ? value.toFixed(0) : value.toPrecision(5).replace("e+", "e");
}
