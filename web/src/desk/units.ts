// SPDX-License-Identifier: BSD-3-Clause
// Units that an engineer may like better than those of SI, by the SI unit of a key.

/** What a number in the unit is multiplied by to be one in SI units. */
type Units = Record<string, number>;

const degree = Math.PI / 180, foot = 0.3048, pound = 4.4482216152605;
const units: Record<string, Units> = {
  m: { m: 1, mm: 1e-3, cm: 1e-2, km: 1e3, in: 0.0254, ft: foot },
  "m/s": { "m/s": 1, "mm/s": 1e-3, "cm/s": 1e-2 },
  "m^2": { "m^2": 1, "mm^2": 1e-6 },
  s: { s: 1, ms: 1e-3, min: 60, h: 3600, day: 86400 },
  rad: { deg: degree, rad: 1 },
  "rad/s": { "deg/s": degree, "rad/s": 1 },
  Pa: { Pa: 1, kPa: 1e3, MPa: 1e6, GPa: 1e9, "lbf/ft^2": pound / foot ** 2 },
  "Pa/m": { "Pa/m": 1, "kPa/m": 1e3, "MPa/m": 1e6 },
  N: { N: 1, kN: 1e3, MN: 1e6, lbf: pound },
  "N/m": { "N/m": 1, "kN/m": 1e3, "MN/m": 1e6, "lbf/ft": pound / foot },
  "N m": { "N m": 1, "kN m": 1e3, "MN m": 1e6 },
  "N/m^2": { "N/m^2": 1, "kN/m^2": 1e3 },
  "N/m^3": { "N/m^3": 1, "kN/m^3": 1e3, "MN/m^3": 1e6 },
  "N m^2": { "N m^2": 1, "kN m^2": 1e3, "MN m^2": 1e6 },
  kg: { kg: 1, t: 1e3 },
  "kg/m": { "kg/m": 1 },
  "kg/m^3": { "kg/m^3": 1, "t/m^3": 1e3 },
  K: { K: 1 },
  "1/K": { "1/K": 1 },
  "1/s": { "1/s": 1 },
  "m/s^2": { "m/s^2": 1, gravity: 9.80665 },
};

/** Units that a key may have; only its own where no others are known. */
export function units_of(si: string): string[] {
  return Object.keys(units[si] ?? { [si]: 1 });
}

export interface Quantity {
  number: string;
  unit: string;
  /** Spelled as a number alone, in SI units. */
  plain: boolean;
}

/** A number of TOML, or a text with a number and a unit of the list; null where it is neither. */
export function quantity_of(spelling: string, si: string): Quantity | null {
  const word = spelling.trim();
  if (/^[-+]?[\d._]+([eE][-+]?\d+)?$/.test(word)) return { number: word, unit: si, plain: true };
  const found = /^"\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*(.*?)\s*"$/.exec(word);
  return found && units_of(si).includes(found[2]) ? { number: found[1], unit: found[2], plain: false } : null;
}

/** As TOML spells it; "" of nothing. */
export function spelled({ number, unit, plain }: Quantity, si: string): string {
  const clean = number.trim().replace(",", ".");
  if (clean === "") return "";
  if (!/^[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$/.test(clean)) return JSON.stringify(clean);
  const whole = clean.replace(/^([-+]?)\./, "$10.").replace(/\.$/, "");
  return si === "" || (plain && unit === si) ? whole : `"${whole} ${unit}"`;
}

/** The same quantity in another unit, with as many digits as a reader wants. */
export function in_unit({ number, unit }: Quantity, si: string, to: string): Quantity {
  const factors = units[si] ?? {}, value = Number(number);
  if (!Number.isFinite(value) || !(unit in factors) || !(to in factors)) return { number, unit: to, plain: false };
  return { number: String(Number(((value * factors[unit]) / factors[to]).toPrecision(8))), unit: to, plain: false };
}
