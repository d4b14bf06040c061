// SPDX-License-Identifier: BSD-3-Clause
import { ChartView } from "./charts/chart_view";
import { chart_controls, labelled_select } from "./charts/controls";
import { follow_size } from "./charts/follow_size";
import { drag_plans, is_of_ground, lift_plans, own_plans, push_plans } from "./charts/path_charts";
import type { Plan } from "./charts/plan";
import type { Settings } from "./charts/scene";
import { column_names, contact_plans, energy_plan, free_plan, quiet_plans, runs_with_energies, water_plans } from "./charts/time_charts";
import type { PageData } from "./data";
import { element } from "./element";
import { is_line_run } from "./line_shapes";

/** Fills the section with the charts of all runs, and ends that on trust with those of energies, contact and noise, folded; gives the charts of the push and the drag. */
export function show_charts(section: HTMLElement, trust: HTMLElement, data: PageData): ChartView[] {
  const settings: Settings = { units: "model", raw: true, published: true, hidden: new Set() };
  const views: ChartView[] = [];
  const view = (plan: Plan, choices: HTMLElement | null = null) => {
    const made = new ChartView(plan, settings, data.runs, choices);
    views.push(made);
    return made;
  };
  const [own, outlines] = parted(own_plans(data), is_of_ground);
  const [forces, noise] = parted([...own, ...push_plans(data), ...drag_plans(data), ...lift_plans(data), ...outlines], (plan) => plan.id.includes("_noise"));
  section.append(chart_controls(data, settings, () => views.forEach((each) => each.show(settings))));
  section.append(element("p", { class: "quiet chart_hint" }, hint(forces)));
  const thinned = data.runs.flatMap((run) => (run.row === null ? [] : `${run.name} (${run.row.length} of ${run.row.at(-1)! + 1})`));
  if (thinned.length > 0) section.append(element("p", { class: "quiet" }, `Not all rows of history.csv are in this page: ${thinned.join(", ")}.`));
  const paths = with_data(forces).map((plan) => view(plan));
  section.append(
    ...group(data.runs.every(is_line_run) ? "Load of the line" : "Push and drag", paths),
    ...group("Pore pressure", with_data(water_plans(data.runs)).map((plan) => view(plan))),
    ...folded("Any column of history.csv against any other", free_views(data, view)),
  );
  trust.append(...folded(`Charts of ${data.runs.some((run) => run.diameter !== null) ? "energy, equilibrium, contact and noise" : "energy and equilibrium"}`, [
    ...energy_views(data, view),
    ...with_data([...quiet_plans(data.runs), ...contact_plans(data.runs), ...noise]).map((plan) => view(plan)),
  ]));
  for (const each of views) each.show(settings);
  follow_size(views);
  document.addEventListener("theme", () => views.forEach((each) => each.draw()));
  return paths;
}

function hint(forces: Plan[]): string {
  const means = forces.some((plan) => plan.traces.some((trace) => trace.mean !== null));
  return "Point at a chart, or move through it with the arrow keys, to read rows of history.csv. Drag over it to zoom, double-click to see all again." +
    (means ? " Thick lines and \u201cmean\u201d are smoothed over 0.01 D of travel to either side, of short travels over a twentieth of them; travels that go back and forth have none." : "");
}

function parted<T>(all: T[], is_second: (each: T) => boolean): [T[], T[]] {
  return [all.filter((each) => !is_second(each)), all.filter(is_second)];
}

function with_data(plans: Plan[]): Plan[] {
  return plans.filter((plan) => plan.traces.length > 0);
}

type View = (plan: Plan, choices: HTMLElement) => ChartView;

function energy_views(data: PageData, view: View): ChartView[] {
  const runs = runs_with_energies(data.runs);
  if (runs.length === 0) return [];
  const names = runs.map((run, i): [string, string] => [String(i), run.name]);
  const choice = labelled_select("Run", "chart_run", names, "0", (index) => made.set_plan(energy_plan(runs[Number(index)])));
  const made = view(energy_plan(runs[0]), element("div", { class: "chart_choices" }, choice));
  return [made];
}

function free_views(data: PageData, view: View): ChartView[] {
  const columns = column_names(data.runs);
  if (columns.length < 2) return [];
  let argument = columns.includes("time_s") ? "time_s" : columns[0];
  let value = columns.find((name) => /^[uw]_m$/.test(name) || name.endsWith("_vy_m_s")) ?? columns.find((name) => name !== argument)!;
  const names = columns.map((name): [string, string] => [name, name]);
  const show = () => made.set_plan(free_plan(data.runs, argument, value));
  const choices = element(
    "div", { class: "chart_choices" },
    labelled_select("Up", "chart_value", names, value, (name) => ((value = name), show())),
    labelled_select("across", "chart_argument", names, argument, (name) => ((argument = name), show())),
  );
  const made = view(free_plan(data.runs, argument, value), choices);
  return [made];
}

function side_by_side(views: ChartView[]): HTMLElement {
  return element("div", { class: "chart_group" }, ...views.map((each) => each.figure));
}

function group(title: string, views: ChartView[]): HTMLElement[] {
  return views.length === 0 ? [] : [element("h3", {}, title), side_by_side(views)];
}

/** Charts are drawn when they are unfolded: they follow the size of their place. */
function folded(title: string, views: ChartView[]): HTMLElement[] {
  return views.length === 0 ? [] : [element("details", { class: "chart_fold" }, element("summary", {}, title), side_by_side(views))];
}
