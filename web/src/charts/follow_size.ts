// SPDX-License-Identifier: BSD-3-Clause
import type { ChartView } from "./chart_view";

/** Charts are as wide as their place, whenever that changes. */
export function follow_size(views: ChartView[]): void {
  const widths = new Map<Element, number>();
  const observer = new ResizeObserver((entries) => {
    for (const { target, contentRect } of entries) {
      if (widths.get(target) === Math.floor(contentRect.width)) continue;
      widths.set(target, Math.floor(contentRect.width));
      views.find((each) => each.figure === target)?.draw();
    }
  });
  for (const each of views) observer.observe(each.figure);
}
