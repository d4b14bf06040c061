// SPDX-License-Identifier: BSD-3-Clause
// H(u) and V(w) of the runs whose soil is shown, below it, with a mark where each panel is.
import { ChartView } from "./charts/chart_view";
import { follow_size } from "./charts/follow_size";
import { drag_plans, push_plans } from "./charts/path_charts";
import type { Plan } from "./charts/plan";
import type { Settings } from "./charts/scene";
import type { PageData, RunData } from "./data";
import { element } from "./element";

/** A run and the time (s) that its panel shows. */
export interface FilmMoment {
  run: RunData;
  time: number;
}

const shown_charts = ["H_u", "V_w"];

export class FilmCurves {
  readonly element = element("div", { class: "film-curves chart_group" });
  private readonly views: ChartView[];
  private of: RunData[] = [];

  constructor(private readonly data: PageData) {
    const settings: Settings = { units: "model", raw: false, published: false, hidden: new Set() };
    this.views = this.plans(data.runs).map((plan) => new ChartView(plan, settings, data.runs));
    this.element.append(...this.views.map((view) => view.figure));
    for (const view of this.views) view.show(settings);
    follow_size(this.views);
    document.addEventListener("theme", () => this.views.forEach((view) => view.draw()));
  }

  /** Marks the moments; the curves are those of their runs. */
  show(moments: FilmMoment[]): void {
    const runs = moments.map((moment) => moment.run);
    if (runs.length !== this.of.length || runs.some((run, i) => run !== this.of[i])) {
      this.of = runs;
      const plans = this.plans(runs);
      this.views.forEach((view, i) => view.set_plan(plans[i]));
    }
    for (const view of this.views) view.mark(moments);
  }

  /** The charts that any run of the page has, with the lines of these runs. */
  private plans(runs: RunData[]): Plan[] {
    return [...drag_plans(this.data), ...push_plans(this.data)]
      .filter((plan) => shown_charts.includes(plan.id) && plan.traces.length > 0)
      .map((plan) => ({ ...plan, id: `film_${plan.id}`, traces: plan.traces.filter((trace) => runs.includes(trace.run)) }));
  }
}
