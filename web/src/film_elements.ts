// SPDX-License-Identifier: BSD-3-Clause
// Elements of the panels; text goes in as text, never as markup.

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, name: string, ...inside: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  if (name) element.className = name;
  element.append(...inside);
  return element;
}

/** Shapes on a square of 16 by 16. */
const ICONS = {
  play: "M4 2 L14 8 L4 14 Z",
  pause: "M3 2 H6.5 V14 H3 Z M9.5 2 H13 V14 H9.5 Z",
  back: "M12 2 L5 8 L12 14 Z M3 2 H5 V14 H3 Z",
  forward: "M4 2 L11 8 L4 14 Z M11 2 H13 V14 H11 Z",
  closer: "M7 2 H9 V7 H14 V9 H9 V14 H7 V9 H2 V7 H7 Z",
  farther: "M2 7 H14 V9 H2 Z",
};

export function icon(name: keyof typeof ICONS): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 16 16");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", ICONS[name]);
  svg.append(path);
  return svg;
}

/** A button with a word, or with an icon that the label names. */
export function button(name: string, face: Node | string, label: string, pressed: () => void): HTMLButtonElement {
  const made = make("button", name, face);
  made.type = "button";
  made.title = label;
  if (typeof face !== "string") made.setAttribute("aria-label", label);
  made.addEventListener("click", pressed);
  return made;
}

/** A list to choose from with its label before it. */
export function choice(name: string, label: string, chosen: (value: string) => void): { label: HTMLLabelElement; select: HTMLSelectElement } {
  const select = make("select", name);
  select.addEventListener("change", () => chosen(select.value));
  return { label: make("label", "film-choice", make("span", "", label), select), select };
}

/** Fills a list, and keeps what is chosen. */
export function set_options(select: HTMLSelectElement, options: [value: string, text: string][], chosen: string): void {
  select.replaceChildren(
    ...options.map(([value, text]) => {
      const option = make("option", "", text);
      option.value = value;
      return option;
    }),
  );
  select.value = chosen;
}

export function tick_box(name: string, label: string, on: boolean, changed: (on: boolean) => void): HTMLLabelElement {
  const box = make("input", name);
  box.type = "checkbox";
  box.checked = on;
  box.addEventListener("change", () => changed(box.checked));
  return make("label", "film-tick", box, make("span", "", label));
}
