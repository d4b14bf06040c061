// SPDX-License-Identifier: BSD-3-Clause
// What is seen without scrolling: charts of the structure (p-y curves), H(u), V(w) and R of a lift of the first run, of a pipeline the line at the ends of its stages, beside its answer in words and its last picture of the soil.
import { ChartView } from "./charts/chart_view";
import { drag_plans, is_of_ground, lift_plans, own_plans, push_plans } from "./charts/path_charts";
import type { Plan } from "./charts/plan";
import { line_sample } from "./charts/run_style";
import type { Settings } from "./charts/scene";
import { follow_size } from "./charts/follow_size";
import type { PageData } from "./data";
import { make } from "./film_elements";
import { PlanChart } from "./line_plan";
import { is_line_run, type LineRun, read_line } from "./line_shapes";
import { stage_ends, words_of_end } from "./line_stages";

// Words, picture and charts are seen without scrolling.
const tallest = 220;  // px

/** Puts the two charts behind what the place holds and gives them; none where the page has no such place or the run no such curve. */
export function show_first_look(place: HTMLElement | null, data: PageData): ChartView[] {
  if (place === null) return [];
  const lead = { ...data, runs: data.runs.slice(0, 1) };
  const settings: Settings = { units: "model", raw: true, published: false, hidden: new Set() };
  const plans = [
    ...own_plans({ ...lead, runs: lead.runs.filter((run) => !is_line_run(run)) }).filter((plan) => !is_of_ground(plan)),
    ...[...drag_plans(lead), ...push_plans(lead), ...lift_plans(lead)].filter((plan) => ["H_u", "V_w", "R_lift"].includes(plan.id)),
  ];
  const drawn = plans.filter((plan) => plan.traces.length > 0);
  const views = drawn
    .map((plan) => new ChartView({ ...plan, id: `look_${plan.id}` }, settings, lead.runs, null, tallest));
  place.append(...views.map((view) => view.figure), ...lead.runs.filter(is_line_run).map(ends_of_line));
  for (const [at, view] of views.entries()) {
    view.show(settings);
    if (drawn[at].by_run === false && drawn[at].traces.length > 1) view.figure.append(legend_of(drawn[at]));
  }
  follow_size(views);
  document.addEventListener("theme", () => views.forEach((view) => view.draw()));
  return views;
}

/** What the lines of a chart are of, with their samples. */
function legend_of(plan: Plan): HTMLElement {
  return make("figcaption", "quiet legend_of_look", ...plan.traces.map((trace) => make("span", "", line_sample(trace.style), ` ${trace.label}`)));
}

function ends_of_line(run: LineRun): HTMLElement {
  const figure = make("figure", "line_of_look");
  void read_line(run.line).then((shapes) => {
    const ends = stage_ends(run), plan = new PlanChart(run, shapes, ends, null);
    figure.append(make("h4", "", "The line in plan at the ends of its stages"), plan.element, ...ends.map((end) => words_of_end(run, end)));
    let width = 0;
    new ResizeObserver(() => {
      if (figure.clientWidth === width || figure.clientWidth === 0) return;
      width = figure.clientWidth;
      plan.lay_out(width);
      plan.show(null);
    }).observe(figure);
  }, () => figure.remove());  // the section of the line says what is wrong
  return figure;
}
