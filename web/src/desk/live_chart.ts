// SPDX-License-Identifier: BSD-3-Clause
// A curve that grows while a run is at work.
import uPlot from "uplot";
import { display_unit } from "../film_numbers";
import { make } from "../film_elements";
import { page_colour } from "../theme";
import type { Column } from "./api";

const height = 210;

/** From where to where an axis goes: a little beyond the values, and around them where they are one value but for round-off, as before a body moves. */
export function axis_range(least: number | null, most: number | null): [number, number] {
  if (least === null || most === null) return [-1, 1];
  const size = Math.max(Math.abs(least), Math.abs(most)), span = most - least;
  const beyond = span > 1e-6 * size ? 0.05 * span : size > 0 ? 0.1 * size : 1;
  return [least - beyond, most + beyond];
}

export class LiveChart {
  readonly element = make("div", "live_chart");
  private plot: uPlot | null = null;
  private watch = new ResizeObserver(() => this.fit());
  private count = -1;
  private units = "";
  private readonly again = () => {
    this.count = -1;
    this.plot?.destroy();
    this.plot = null;
    this.show(this.seen[0], this.seen[1]);
  };
  private seen: [(number | null)[], (number | null)[]] = [[], []];

  /** `curves`: that stand behind one another with gaps between, each in its colour. `downwards`: y grows towards the foot of the chart, as depths do. */
  constructor(readonly x: Column, readonly y: Column, private readonly downwards = false, private readonly curves = 1) {
    this.element.setAttribute("role", "img");
    this.element.setAttribute("aria-label", `${y.label} against ${x.label}`);
    this.watch.observe(this.element);
    document.addEventListener("theme", this.again);
  }

  end(): void {
    this.watch.disconnect();
    this.plot?.destroy();
    document.removeEventListener("theme", this.again);
  }

  show(x: (number | null)[], y: (number | null)[]): void {
    this.seen = [x, y];
    if (x.length === this.count || this.element.clientWidth === 0) return;
    this.count = x.length;
    const largest = (values: (number | null)[]) => values.reduce<number>((most, value) => Math.max(most, Math.abs(value ?? 0)), 0);
    const [of_x, of_y] = [display_unit(this.x.unit ?? "1", largest(x)), display_unit(this.y.unit ?? "1", largest(y))];
    const scaled = (values: (number | null)[], factor: number) => values.map((value) => (value === null ? null : value / factor));
    const data = [scaled(x, of_x.factor), scaled(y, of_y.factor)] as unknown as uPlot.AlignedData;
    const label = (column: Column, unit: string) => `${column.label}${unit && unit !== "1" ? ` (${unit})` : ""}`;
    const units = `${of_x.name} ${of_y.name}`;
    if (this.plot !== null && units !== this.units) this.plot.destroy(), (this.plot = null);
    this.units = units;
    if (this.plot === null) {
      const range: uPlot.Scale.Range = (_, least, most) => axis_range(least, most);
      const axis = { stroke: page_colour("--quiet"), grid: { stroke: page_colour("--grid"), width: 1 }, ticks: { stroke: page_colour("--line"), width: 1 } };
      this.plot = new uPlot(
        {
          mode: 2, width: this.element.clientWidth, height, legend: { show: false }, cursor: { drag: { x: true, y: true } },
          scales: { x: { time: false, range }, y: { range, dir: this.downwards ? -1 : 1 } },
          axes: [{ ...axis, label: label(this.x, of_x.name), scale: "x" }, { ...axis, label: label(this.y, of_y.name), scale: "y", size: 62 }],
          series: [null as unknown as uPlot.Series, { stroke: page_colour("--accent"), width: 1.8, facets: [{ scale: "x", auto: true }, { scale: "y", auto: true }], paths: (plot: uPlot, series: number) => drawn_in(plot, series, this.curves) }],
        } as unknown as uPlot.Options,
        [null, data] as unknown as uPlot.AlignedData, this.element);
      return;
    }
    this.plot.setData([null, data] as unknown as uPlot.AlignedData);
  }

  private fit(): void {
    if (this.plot) this.plot.setSize({ width: this.element.clientWidth, height });
    else if (this.seen[0].length > 0) this.count = -1, this.show(...this.seen);
  }
}

/** Of one curve of several, from the first to the last. */
export const curve_colour = (k: number, of: number) => (of === 1 ? page_colour("--accent") : `hsl(${210 + (150 * k) / (of - 1)} 65% 50%)`);

/** Points in the order of the run: u goes back where a sweep turns. */
function drawn_in(plot: uPlot, series: number, curves: number): null {
  const { ctx } = plot, [x, y] = plot.data[series] as unknown as [(number | null)[], (number | null)[]];
  const { left, top, width, height: tall } = plot.bbox;
  ctx.save();
  ctx.beginPath();
  ctx.rect(left, top, width, tall);
  ctx.clip();
  ctx.lineWidth = 1.8 * devicePixelRatio;
  let drawn = false, curve = 0;
  const stroke = () => {
    ctx.strokeStyle = curve_colour(curve, curves);
    ctx.stroke();
    ctx.beginPath();
    drawn = false;
  };
  ctx.beginPath();
  for (let k = 0; k < x.length; k++) {
    if (x[k] === null || y[k] === null) {
      stroke();
      if (curve < curves - 1) ++curve;
      continue;
    }
    const px = plot.valToPos(x[k]!, "x", true), py = plot.valToPos(y[k]!, "y", true);
    if (drawn) ctx.lineTo(px, py);
    else ctx.moveTo(px, py);
    drawn = true;
  }
  stroke();
  ctx.restore();
  return null;
}
