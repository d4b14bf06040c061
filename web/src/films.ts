// SPDX-License-Identifier: BSD-3-Clause
import type { PageData } from "./data";

/** Fills the section with the moving soil. */
export function show_films(section: HTMLElement, data: PageData): void {
  section.dataset.films = String(data.runs.filter((run) => run.film !== null).length);
}
