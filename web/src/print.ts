// SPDX-License-Identifier: BSD-3-Clause

/** Opens <details> for the print, but those for the screen, and closes again those that were closed. */
export function open_details_in_print(): void {
  let opened: HTMLDetailsElement[] = [];
  addEventListener("beforeprint", () => {
    opened = [...document.querySelectorAll<HTMLDetailsElement>("details:not([open], .for_screen)")];
    for (const each of opened) each.open = true;
  });
  addEventListener("afterprint", () => {
    for (const each of opened) each.open = false;
  });
}
