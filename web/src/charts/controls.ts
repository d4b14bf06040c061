// SPDX-License-Identifier: BSD-3-Clause
import type { PageData, RunData } from "../data";
import { element, svg_element } from "../element";
import { tick_sample, was_remeshed } from "./remeshings";
import { line_sample, run_style } from "./run_style";
import type { Settings } from "./scene";
import { left_out, offered_systems, system_name } from "./units";
import type { UnitSystem } from "./units";

/** The controls of all charts: which runs, which units, what else; calls `changed` with every change of the settings. */
export function chart_controls(data: PageData, settings: Settings, changed: () => void): HTMLElement {
  const runs = element("fieldset", { class: "chart_runs" }, element("legend", {}, "Runs"));
  data.runs.forEach((run, index) => runs.append(run_switch(run, index, settings, changed)));
  if (data.runs.some(was_remeshed)) runs.append(key_of_remeshings());
  const options = element("div", { class: "chart_options" });
  const controls = element("div", { class: "chart_controls" }, runs, options);

  const systems = offered_systems(data.runs);
  const note = element("p", { class: "quiet chart_note", role: "status" });
  if (systems.length > 1) {
    const names = systems.map((system): [string, string] => [system, system_name(system, data.runs)]);
    options.append(
      labelled_select("Units", "chart_units", names, settings.units, (value) => {
        settings.units = value as UnitSystem;
        note.textContent = note_on(data.runs, settings.units);
        changed();
      }),
    );
  }
  if (data.runs.some((run) => run.push.rows.length > 0 || run.drag.rows.length > 0))
    options.append(labelled_box("every row (thin)", "chart_raw", settings.raw, (on) => ((settings.raw = on), changed())));
  if (data.published.length > 0)
    options.append(labelled_box("published numbers", "chart_published", settings.published, (on) => ((settings.published = on), changed())));
  options.append(note);
  return controls;
}

function run_switch(run: RunData, index: number, settings: Settings, changed: () => void): HTMLElement {
  const box = element("input", { type: "checkbox", "data-run": run.name });
  box.checked = true;
  const label = element("label", { title: run.title }, box, line_sample(run_style(index)), element("span", {}, run.name));
  box.addEventListener("change", () => {
    if (box.checked) settings.hidden.delete(run);
    else settings.hidden.add(run);
    label.classList.toggle("off", !box.checked);
    changed();
  });
  return label;
}

function key_of_remeshings(): HTMLElement {
  const sample = svg_element("svg", { width: 34, height: 10, "aria-hidden": "true" }, tick_sample(0, 1));
  return element("span", { class: "chart_key", title: "ticks at the edge of the charts, in the colour of the run" }, sample, element("span", {}, "remeshing"));
}

function note_on(runs: RunData[], units: UnitSystem): string {
  const without = left_out(units, runs).map((run) => run.name);
  if (without.length === 0) return "";
  const why = units === "prototype"
    ? "Without a prototype (gravity as on earth, or none), and so left out of charts of lengths, forces and energies"
    : "Without a driven body, or in soil without weight and strength, and so left out of charts that need them";
  return `${why}: ${without.join(", ")}.`;
}

/** A label with a list to choose from; options are values with what is shown for them. */
export function labelled_select(
  text: string, name: string, options: [value: string, shown: string][], chosen: string, change: (value: string) => void,
): HTMLLabelElement {
  const select = element("select", { class: name });
  for (const [value, shown] of options) select.append(element("option", { value }, shown));
  select.value = chosen;
  select.addEventListener("change", () => change(select.value));
  return element("label", {}, `${text} `, select);
}

function labelled_box(text: string, name: string, on: boolean, change: (on: boolean) => void): HTMLLabelElement {
  const box = element("input", { type: "checkbox", class: name });
  box.checked = on;
  box.addEventListener("change", () => change(box.checked));
  return element("label", {}, box, element("span", {}, text));
}
