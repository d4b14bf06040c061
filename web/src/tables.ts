// SPDX-License-Identifier: BSD-3-Clause

/** Gives boxes whose table is wider than they are the class "scrolls", by which the page shows that there is more to the side. */
export function sign_scrolling_tables(): void {
  const look = (box: Element | null) => box?.classList.toggle("scrolls", box.scrollWidth > box.clientWidth + 1);
  const watch = new ResizeObserver((entries) => entries.forEach((entry) => look(entry.target.closest(".wide"))));
  for (const box of document.querySelectorAll(".wide")) {
    watch.observe(box);
    for (const table of box.children) watch.observe(table);
  }
}
