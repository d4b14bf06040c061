// SPDX-License-Identifier: BSD-3-Clause
import type { RunData } from "../data";
import { column_of_label } from "./quantity";
import type { Quantity } from "./quantity";

export type UnitSystem = "model" | "dimensionless" | "prototype";

/** The unit of an axis: a number in SI units times factor(run) is what is shown; factor is null where a run has no such number. */
export interface Unit {
  /** "" for a pure number. */
  name: string;
  /** What a dimensionless number is divided by, else "". */
  divisor: string;
  factor(run: RunData): number | null;
}

/** A name of a unit, how much of SI it is, and from what size on it is used. */
type Step = [name: string, si: number, from: number];

const steps: Record<string, Step[]> = {
  m: [["mm", 1e-3, 0], ["m", 1, 10]],
  "N/m": [["N/m", 1, 0], ["kN/m", 1e3, 1e4]],
  "J/m": [["J/m", 1, 0], ["kJ/m", 1e3, 1e4]],
  "N m/m": [["N m/m", 1, 0], ["kN m/m", 1e3, 1e4]],
  "N m": [["N m", 1, 0], ["kN m", 1e3, 1e4]],
  N: [["N", 1, 0], ["kN", 1e3, 1e4]],
  J: [["J", 1, 0], ["kJ", 1e3, 1e4]],
  s: [["s", 1, 0], ["h", 3600, 7200], ["days", 86400, 3 * 86400]],
  Pa: [["Pa", 1, 0], ["kPa", 1e3, 1e3], ["MPa", 1e6, 1e6]],
};

const prototype_units: Record<string, [name: string, si: number]> = {
  m: ["m", 1],
  "N/m": ["kN/m", 1e3],
  "J/m": ["kJ/m", 1e3],
  "N m/m": ["kN m/m", 1e3],
};

/** The unit that shows a quantity of at most `largest` (SI) of these runs. */
export function unit_of(system: UnitSystem, quantity: Quantity, largest: number, runs: RunData[]): Unit {
  if (system === "dimensionless" && quantity.kind in powers_of_force) return dimensionless(quantity.kind as Measured, runs);
  if (system === "prototype" && quantity.unit in prototype_units) {
    const [name, si] = prototype_units[quantity.unit];
    // Energy is force times length.
    const power = quantity.kind === "energy" ? 2 : 1;
    return { name, divisor: "", factor: (run) => (run.prototype === null ? null : run.prototype ** power / si) };
  }
  const [name, si] = (steps[quantity.unit] ?? [[quantity.unit, 1, 0]]).filter(([, , from]) => largest >= from).at(-1)!;
  // 1 / si, rounded to what it is: 0.001 has no exact neighbour.
  return { name, divisor: "", factor: () => (si < 1 ? Math.round(1 / si) : 1 / si) };
}

// By how many D more than a force per metre something is divided.
const powers_of_force = { length: 0, stress: -1, force: 0, energy: 1 };
type Measured = keyof typeof powers_of_force;

function dimensionless(kind: Measured, runs: RunData[]): Unit {
  if (kind === "length") return { name: "", divisor: "D", factor: (run) => (run.diameter === null ? null : 1 / run.diameter) };
  return {
    name: "",
    divisor: [...new Set(runs.flatMap((run) => run.measure?.[kind] ?? []))].join(" or "),
    factor: (run) => (run.measure === null || run.diameter === null ? null : 1 / (run.measure.size * run.diameter ** powers_of_force[kind])),
  };
}

/** Runs whose lengths and forces have no number in a system: they are left out of its charts. */
export function left_out(system: UnitSystem, runs: RunData[]): RunData[] {
  if (system === "model") return [];
  return runs.filter((run) => (system === "prototype" ? run.prototype === null : run.measure === null || run.diameter === null));
}

/** The systems in which any of these runs can be shown. */
export function offered_systems(runs: RunData[]): UnitSystem[] {
  return (["model", "dimensionless", "prototype"] as const).filter((system) => left_out(system, runs).length < runs.length);
}

/** What a system is called where it is chosen. */
export function system_name(system: UnitSystem, runs: RunData[]): string {
  const forces = runs.map((run) => column_of_label(run, "V")).filter((column) => column !== undefined);
  if (system === "model") return forces.length > 0 && !forces.includes("V_N_m") ? "model (mm, N)" : "model (mm, N/m)";
  const without = left_out(system, runs).length;
  const units = system === "prototype" ? "m, kN/m" : `w/D, ${over("V", dimensionless("force", runs).divisor)}`;
  return `${system} (${units}${without === 0 ? "" : `; leaves out ${without} of ${runs.length} runs`})`;
}

/** Symbol (or words) and unit: "V (N/m)", "w/D", "U". */
export function short_title(quantity: Quantity, unit: Unit): string {
  const name = quantity.symbol || quantity.words;
  return unit.divisor !== "" ? over(name, unit.divisor) : unit.name !== "" && unit.name !== "1" ? `${name} (${unit.name})` : name;
}

/** Words, symbol and unit: "vertical reaction V (N/m)", "embedment w/D". */
export function axis_title(quantity: Quantity, unit: Unit): string {
  return quantity.symbol === "" ? short_title(quantity, unit) : `${quantity.words} ${short_title(quantity, unit)}`;
}

function over(name: string, divisor: string): string {
  return divisor.split(" or ").map((each) => `${name}/${each.includes(" ") ? `(${each})` : each}`).join(" or ");
}
