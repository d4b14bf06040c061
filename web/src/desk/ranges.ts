// SPDX-License-Identifier: BSD-3-Clause
// Low and high values of an uncertain parameter. They stand in the comment of its key, "s_u at the seabed; low 2 kPa, high 4 kPa", where a study of the case takes them from.
import type { CaseText, Path } from "./case_text";

export interface Range { low: string; high: string }

const written = /(?:;\s*)?\blow ([-+]?[\d.][^,;]*), high ([-+]?[\d.][^,;]*)$/;

/** null where the comment gives none. */
export function range_in(comment: string): Range | null {
  const found = written.exec(comment);
  return found ? { low: found[1].trim(), high: found[2].trim() } : null;
}

/** What the comment says beside them. */
export const without_range = (comment: string) => comment.replace(written, "").trim();

/** Numbers without a unit get that of the key. */
export function with_range(comment: string, { low, high }: Range, unit: string): string {
  const spelled = (value: string) => {
    const clean = value.trim().replace(/^([-+]?\d*),(\d)/, "$1.$2");
    return /^[-+\d.eE]+$/.test(clean) && unit !== "" ? `${clean} ${unit}` : clean;
  };
  const words = without_range(comment);
  return low.trim() === "" || high.trim() === "" ? words : `${words === "" || words === "<-" ? words && `${words} ` : `${words}; `}low ${spelled(low)}, high ${spelled(high)}`;
}

/** What is wrong with them; "" where nothing is, or nothing stands there. */
export function wrong_in({ low, high }: Range): string {
  const parts = [low, high].map((value) => /^\s*([-+]?\d*[.,]?\d+(?:[eE][-+]?\d+)?)\s*([^\s,;#"]*)\s*$/.exec(value));
  if (low.trim() === "" && high.trim() === "") return "";
  if (parts.some((part) => part === null)) return "a number, or a number and its unit: 2 kPa";
  const [from, to] = parts.map((part) => Number(part![1].replace(",", ".")));
  return parts[0]![2] === parts[1]![2] && from >= to ? "low must be less than high" : "";
}

/** Whether a study may vary what stands there: numbers of soils and of contacts. */
export const may_vary = (text: CaseText, path: Path) => ["material", "contact"].includes(String(path[0])) && path.length === 3 && /^"?[+]?[\d.]/.test(text.spelled(path) ?? "");
