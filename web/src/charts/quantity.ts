// SPDX-License-Identifier: BSD-3-Clause

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

// Endings of column names, the longest first, for no ending to hide in another.
const endings: [string, Kind, string][] = [
  ["_Nm_m", "energy", "N m/m"],
  ["_N_m", "force", "N/m"],
  ["_J_m", "energy", "J/m"],
  ["_N_s", "other", "N s"],
  ["_m_s", "other", "m/s"],
  ["_rad", "other", "rad"],
  ["_Pa", "stress", "Pa"],
  ["_m", "length", "m"],
  ["_s", "time", "s"],
];

const known: Record<string, [words: string, symbol: string]> = {
  time_s: ["time", "t"],
  u_m: ["horizontal displacement", "u"],
  w_m: ["embedment", "w"],
  H_N_m: ["horizontal resistance", "H"],
  V_N_m: ["vertical reaction", "V"],
  M_Nm_m: ["moment", "M"],
  angle_rad: ["rotation", ""],
  kinetic_J_m: ["kinetic energy", ""],
  internal_J_m: ["internal energy", ""],
  damping_J_m: ["energy lost to damping", ""],
  friction_J_m: ["energy lost to friction", ""],
  external_J_m: ["work done from outside", ""],
  energy_error_J_m: ["error of the energy balance", ""],
  out_of_balance: ["force out of balance", ""],
  gap_m: ["gap", ""],
  overlap_m: ["overlap", ""],
  second_impulse_N_m: ["second contact correction", ""],
};

/** What a column of history.csv holds, told by its name. */
export function quantity_of_column(column: string): Quantity {
  const [ending, kind, unit] = endings.find(([each]) => column.endsWith(each)) ?? ["", "other" as const, ""];
  const [words, symbol] = known[column] ?? [column.slice(0, column.length - ending.length), ""];
  return { words, symbol, kind, unit };
}

/** A pure number. */
export function ratio(words: string, symbol: string): Quantity {
  return { words, symbol, kind: "other", unit: "" };
}
