// SPDX-License-Identifier: BSD-3-Clause
import type { RunData } from "../data";
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
  if (system === "dimensionless" && quantity.kind in reference_powers) return dimensionless(quantity, runs);
  if (system === "prototype" && quantity.unit in prototype_units) {
    const [name, si] = prototype_units[quantity.unit];
    // At N times the gravity of the earth a length stands for one N times as long, and so does a force per metre; energy is their product.
    const power = quantity.kind === "energy" ? 2 : 1;
    return { name, divisor: "", factor: (run) => run.gravity_level ** power / si };
  }
  const [name, si] = (steps[quantity.unit] ?? [[quantity.unit, 1, 0]]).filter(([, , from]) => largest >= from).at(-1)!;
  // 1 / si, rounded to what it is: 0.001 has no exact neighbour.
  return { name, divisor: "", factor: () => (si < 1 ? Math.round(1 / si) : 1 / si) };
}

// Powers of D by which quantities are made dimensionless: with gamma' D (or s_u) as the stress.
const reference_powers = { length: 1, force: 1, energy: 2, stress: 0 };

function dimensionless(quantity: Quantity, runs: RunData[]): Unit {
  const kind = quantity.kind as keyof typeof reference_powers;
  const power = reference_powers[kind];
  const raised = (letter: string, to: number) => (to === 0 ? "" : to === 1 ? letter : `${letter}${"\u00b2\u00b3"[to - 2]}`);
  if (kind === "length") return { name: "", divisor: "D", factor: (run) => (run.diameter === null ? null : 1 / run.diameter) };
  const of_weight = `\u03b3\u2032${raised("D", power + 1)}`;
  const of_strength = power === 0 ? "s_u" : `${raised("D", power)} s_u`;
  const with_pipe = runs.filter((run) => run.diameter !== null);
  const divisors = [
    ...(with_pipe.some((run) => run.unit_weight > 0) ? [of_weight] : []),
    ...(with_pipe.some((run) => run.unit_weight === 0) ? [of_strength] : []),
  ];
  return {
    name: "",
    divisor: divisors.join(" or "),
    factor: (run) => {
      const stress = reference_stress(run);
      return stress === null ? null : 1 / (stress * run.diameter! ** power);
    },
  };
}

function reference_stress(run: RunData): number | null {
  if (run.diameter === null) return null;
  return run.unit_weight > 0 ? run.unit_weight * run.diameter : run.strength;
}

/** The systems in which these runs can be shown. */
export function offered_systems(runs: RunData[]): UnitSystem[] {
  const with_pipe = runs.filter((run) => run.diameter !== null);
  const systems: UnitSystem[] = ["model"];
  if (with_pipe.length > 0 && with_pipe.every((run) => reference_stress(run) !== null)) systems.push("dimensionless");
  if (runs.some((run) => run.gravity_level !== 1)) systems.push("prototype");
  return systems;
}

/** What a system is called where it is chosen. */
export function system_name(system: UnitSystem, runs: RunData[]): string {
  if (system === "model") return "model (mm, N/m)";
  if (system === "prototype") return "prototype (m, kN/m)";
  const force = dimensionless({ words: "", symbol: "V", kind: "force", unit: "N/m" }, runs);
  return `dimensionless (w/D, ${over("V", force.divisor)})`;
}

/** Symbol (or words) and unit: "V (N/m)", "w/D". */
export function short_title(quantity: Quantity, unit: Unit): string {
  const name = quantity.symbol || quantity.words;
  return unit.divisor !== "" ? over(name, unit.divisor) : unit.name !== "" ? `${name} (${unit.name})` : name;
}

/** Words, symbol and unit: "vertical reaction V (N/m)", "embedment w/D". */
export function axis_title(quantity: Quantity, unit: Unit): string {
  return quantity.symbol === "" ? short_title(quantity, unit) : `${quantity.words} ${short_title(quantity, unit)}`;
}

function over(name: string, divisor: string): string {
  return divisor.split(" or ").map((each) => `${name}/${each === "D" || each === "s_u" ? each : `(${each})`}`).join(" or ");
}
