// SPDX-License-Identifier: BSD-3-Clause
// What is seen without scrolling: H(u) and V(w) of the first run, beside its last picture of the soil.
import { ChartView } from "./charts/chart_view";
import { drag_plans, push_plans } from "./charts/path_charts";
import type { Settings } from "./charts/scene";
import { follow_size } from "./charts/follow_size";
import type { PageData } from "./data";

/** Puts the two charts before what the place holds and gives them; none where the page has no such place or the run no such curve. */
export function show_first_look(place: HTMLElement | null, data: PageData): ChartView[] {
  if (place === null) return [];
  const lead = { ...data, runs: data.runs.slice(0, 1) };
  const settings: Settings = { units: "model", raw: true, published: false, hidden: new Set() };
  const plans = [...drag_plans(lead).filter((plan) => plan.id === "H_u"), ...push_plans(lead).filter((plan) => plan.id === "V_w")];
  const views = plans
    .filter((plan) => plan.traces.length > 0)
    .map((plan) => new ChartView({ ...plan, id: `look_${plan.id}` }, settings, lead.runs));
  place.prepend(...views.map((view) => view.figure));
  for (const view of views) view.show(settings);
  follow_size(views);
  document.addEventListener("theme", () => views.forEach((view) => view.draw()));
  return views;
}
