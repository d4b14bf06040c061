// SPDX-License-Identifier: BSD-3-Clause
// Light or dark: as the reader's system has it, or as chosen with the button. Whoever draws on a canvas listens to the event "theme".
import { element } from "./element";

const choices = ["auto", "light", "dark"] as const;
type Choice = (typeof choices)[number];
const stored_as = "berm-theme";

/** Whether the page is dark now; on paper it never is. */
export function is_dark(): boolean {
  return page_colour("--scheme") === "dark";
}

/** A colour of base.css as it is now. */
export function page_colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Puts the button that chooses the theme at the end of the navigation, or of the header. */
export function follow_theme(): void {
  let choice = stored();
  const button = element("button", { type: "button", class: "theme" });
  const apply = () => {
    if (choice === "auto") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = choice;
    button.textContent = `theme: ${choice}`;
    document.dispatchEvent(new Event("theme"));
  };
  button.addEventListener("click", () => {
    choice = choices[(choices.indexOf(choice) + 1) % choices.length];
    store(choice);
    apply();
  });
  (document.querySelector("header nav") ?? document.querySelector("header"))?.append(button);
  for (const query of ["(prefers-color-scheme: dark)", "print"])
    matchMedia(query).addEventListener("change", () => document.dispatchEvent(new Event("theme")));
  apply();
}

// A page opened from a file may have no storage: then the choice lasts as long as the page.
function stored(): Choice {
  try {
    return choices.find((each) => each === localStorage.getItem(stored_as)) ?? "auto";
  } catch {
    return "auto";
  }
}

function store(choice: Choice): void {
  try {
    localStorage.setItem(stored_as, choice);
  } catch {
    return;
  }
}
