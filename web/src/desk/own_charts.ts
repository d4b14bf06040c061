// SPDX-License-Identifier: BSD-3-Clause
// Charts of a run that has ended beside V(w), H(u) and w(u): p-y curves of a pile, resistance over depth of a penetrometer, uplift over its travel, a buckle over the load.
import { make } from "../film_elements";
import { api, type Axis, type Chart, type Column } from "./api";
import { curve_colour, LiveChart } from "./live_chart";

/** Those that curves of the history show, or that follow from them. */
const shown_otherwise = ["V_w", "H_u", "w_u", "V_u", "H_over_V_u", "H_travel", "u_H", "u_t", "U_t", "H_s"];
/** Depths increase downwards. */
const is_depth = ({ symbol }: Axis) => symbol === "z";

const column = ({ symbol, unit, meaning }: Axis): Column => ({ name: symbol, label: symbol, unit, meaning });
const head = ({ x, y }: Chart) => `${y.meaning} ${y.symbol} against ${x.meaning} ${x.symbol}`;

/** Empty where the run wrote none. */
export async function own_charts(run: string): Promise<{ chart: LiveChart; fill: () => void; face: HTMLElement }[]> {
  const file = await api.file(`${run}/curves.json`).catch(() => null);
  if (file === null) return [];
  const { charts } = JSON.parse(await file.text()) as { charts: Chart[] };
  return charts.filter(({ chart, curves }) => !shown_otherwise.includes(chart) && curves.length > 0).map((each) => {
    const upright = is_depth(each.x), [x, y] = upright ? [each.y, each.x] : [each.x, each.y];
    const chart = new LiveChart(column(x), column(y), upright, each.curves.length), points = each.curves.map((curve) => ({ x: curve.x, y: curve.smoothed ?? curve.y }));
    const names = each.curves.length < 2 ? [] : each.curves.map(({ name }, k, { length }) => {
      const word = make("span", "", ` ${name}`);
      word.style.color = curve_colour(k, length);
      return word;
    });
    const face = make("figure", "own_chart", chart.element, make("figcaption", "quiet", head(each), ...names));
    return { chart, face, fill: () => chart.show(...joined(upright ? points.map(({ x: depth, y: value }) => ({ x: value, y: depth })) : points)) };
  });
}

/** Curves behind one another, with a gap between them. */
function joined(curves: { x: (number | null)[]; y: (number | null)[] }[]): [(number | null)[], (number | null)[]] {
  const x: (number | null)[] = [], y: (number | null)[] = [];
  for (const curve of curves) {
    if (x.length > 0) x.push(null), y.push(null);
    for (let k = 0; k < curve.x.length; ++k) if (curve.x[k] !== null && curve.y[k] !== null) x.push(curve.x[k]), y.push(curve.y[k]);
  }
  return [x, y];
}
