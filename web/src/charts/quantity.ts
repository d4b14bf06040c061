// SPDX-License-Identifier: BSD-3-Clause
import type { AxisData, RunData } from "../data";

/** What a number measures: tells how it is scaled in another system of units. */
export type Kind = "length" | "force" | "energy" | "stress" | "time" | "other";

/** What stands on an axis. */
export interface Quantity {
  words: string;
  /** Letter of the formulas, "" where there is none. */
  symbol: string;
  kind: Kind;
  /** SI unit, "" for pure numbers. */
  unit: string;
}

// By unit; forces, energies and moments those of plane strain, per metre run.
const kinds: Record<string, Kind> = { m: "length", "N/m": "force", "J/m": "energy", "N m/m": "energy", Pa: "stress", s: "time" };

/** What a column of history.csv holds, as the history's schema tells: that of the first run that has the column. */
export function quantity_of_column(runs: RunData[], column: string): Quantity {
  const told = runs.find((run) => column in run.quantities)?.quantities[column];
  if (told === undefined) return { words: column, symbol: "", kind: "other", unit: "" };
  return { words: told.words, symbol: told.label.length === 1 ? told.label : "", kind: kinds[told.unit] ?? "other", unit: told.unit };
}

/** What an axis of a chart that a structure has by itself shows. */
export function quantity_of_axis(axis: AxisData): Quantity {
  return { words: axis.meaning, symbol: axis.symbol, unit: axis.unit, kind: kinds[axis.unit] ?? "other" };
}

/** The column of that label, whatever the dimension: "kinetic" is kinetic_J_m in plane strain, kinetic_J in space; undefined where the run has none. */
export function column_of_label(run: RunData, label: string): string | undefined {
  return Object.keys(run.quantities).find((column) => run.quantities[column].label === label);
}

/** A pure number. */
export function ratio(words: string, symbol: string): Quantity {
  return { words, symbol, kind: "other", unit: "" };
}
