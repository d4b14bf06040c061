// SPDX-License-Identifier: BSD-3-Clause
// A card for each slice: H(u), V over the weight and sinkage over u, at one scale in all; the largest of all slices is marked.
import { svg_element } from "./element";
import { make } from "./film_elements";
import { digits, display_unit, type Unit } from "./film_numbers";
import { ChartArea, drawing, roomy } from "./line_drawing";
import { card_id } from "./line_plan";
import { column_at, type LineRun } from "./line_shapes";
import { type StageEnd, warmth_of } from "./line_stages";

/** px of the page */
const margin = { left: 42, right: 10, top: 20, bottom: 6 };
const height_of_plot = 74, height_of_numbers = 30;
const width_on_paper = 160;
/** The part of an axis that stays free at its ends. */
const room = 0.06;

interface Kind {
  column: string;
  symbol: string;
  unit: (largest: number, run: LineRun) => Unit;
  downwards?: boolean;
}
/** What a card shows over u. */
const kinds: Kind[] = [
  { column: "H_N_m", symbol: "H", unit: (largest) => display_unit("N/m", largest) },
  { column: "V_N_m", symbol: "V/W", unit: (_, run) => ({ name: "", factor: run.line.weight }) },
  { column: "w_m", symbol: "w", unit: (largest) => display_unit("m", largest), downwards: true },
];

/** A quantity of all slices by row, in the unit of its axis; null where the history has no number. */
interface Series {
  kind: Kind;
  unit: Unit;
  values: (number | null)[][];
  /** The largest size of all slices. */
  largest: { slice: number; row: number };
}

interface Card {
  element: HTMLElement;
  holder: HTMLElement;
  dots: SVGCircleElement[];
}

export class SliceCards {
  readonly element: HTMLElement;
  private cards: Card[];
  private series: Series[];
  private u: { unit: Unit; values: (number | null)[][] };
  private areas: ChartArea[] = [];
  private time = 0;
  /** Rows in which stages load the line. */
  private rows: number[];

  /** `picked`: the reader points at the card of a slice. */
  constructor(private readonly run: LineRun, private readonly ends: StageEnd[], picked: (slice: number | null) => void) {
    const loading = new Set(run.line.ends.map((end) => end.name));
    this.rows = run.stage.flatMap((stage, row) => (loading.has(stage) ? [row] : []));
    this.u = this.in_unit("u_m", (largest) => display_unit("m", largest));
    this.series = kinds.map((kind) => {
      const { unit, values } = this.in_unit(kind.column, kind.unit);
      return { kind, unit, values, largest: this.largest_of(values) };
    });
    this.cards = run.line.slices.map((x, k) => this.make_card(x, k, picked));
    this.element = make("div", "line_cards", ...this.cards.map((card) => card.element));
  }

  /** Draws for the width that a card has now, or on paper. */
  lay_out(paper: boolean): void {
    const width = paper ? width_on_paper : Math.floor(this.cards[0].holder.clientWidth);
    if (width > 0) this.cards.forEach((card, k) => this.draw(card, k, width));
    this.go_to(this.time);
  }

  /** Moves the dots to a time, s. */
  go_to(time: number): void {
    this.time = time;
    if (this.areas.length === 0) return;
    this.cards.forEach(({ dots }, k) => {
      const u = this.at(k, "u_m", this.u.unit.factor);
      this.series.forEach(({ kind, unit }, i) => {
        const value = this.at(k, kind.column, unit.factor);
        const shown = u !== null && value !== null;
        dots[i].setAttribute("visibility", shown ? "visible" : "hidden");
        if (!shown) return;
        dots[i].setAttribute("cx", String(this.areas[i].x(u)));
        dots[i].setAttribute("cy", String(this.areas[i].y(value)));
      });
    });
  }

  highlight(slice: number | null): void {
    this.cards.forEach(({ element }, k) => element.classList.toggle("picked", k === slice));
  }

  private at(slice: number, column: string, factor: number): number | null {
    const value = column_at(this.run, column_of(slice, column), this.time);
    return value === null ? null : value / factor;
  }

  /** A column of all slices, in the unit that goes with its largest number. */
  private in_unit(column: string, unit_of: Kind["unit"]): { unit: Unit; values: (number | null)[][] } {
    const all = this.run.line.slices.map((_, k) => this.rows.map((row) => this.run.columns[column_of(k, column)]?.[row] ?? null));
    const [low, high] = ends_of(all), unit = unit_of(Math.max(0, -low, high), this.run);
    return { unit, values: all.map((list) => list.map((value) => (value === null ? null : value / unit.factor))) };
  }

  private largest_of(values: (number | null)[][]): Series["largest"] {
    let found = { slice: 0, row: 0 }, most = -1;
    values.forEach((list, slice) => list.forEach((value, row) => {
      if (value === null || Math.abs(value) <= most) return;
      most = Math.abs(value);
      found = { slice, row };
    }));
    return found;
  }

  private make_card(x: number, k: number, picked: (slice: number | null) => void): Card {
    const holder = make("div", "line_holder");
    const element = make("section", "line_card", make("h4", "", `Slice ${k}, x = ${x} m`), holder, this.numbers(k));
    element.id = card_id(this.run, k);
    element.addEventListener("pointerenter", () => picked(k));
    element.addEventListener("pointerleave", () => picked(null));
    return { element, holder, dots: this.series.map(() => svg_element("circle", { r: 3.5, class: "line_dot" })) };
  }

  /** The largest of each quantity in the slice; that of all slices is marked. */
  private numbers(k: number): HTMLElement {
    const list = make("dl", "line_numbers");
    for (const { kind, unit, values, largest } of this.series) {
      const most = Math.max(...values[k].map((value) => Math.abs(value ?? 0)));
      const of_all = largest.slice === k;
      const number = make("dd", of_all ? "line_largest" : "", `${digits(most)}${unit.name && ` ${unit.name}`}`);
      if (of_all) number.title = "the largest of all slices";
      list.append(make("div", "", make("dt", "", kind.symbol === "H" ? "largest |H|" : `largest ${kind.symbol}`), number));
    }
    return list;
  }

  private draw(card: Card, k: number, width: number): void {
    const step = margin.top + height_of_plot + margin.bottom, last = this.series.length - 1;
    const svg = drawing(width, step * this.series.length + height_of_numbers, `Slice ${k}: H/W, V/W and embedment w against u`);
    const along = roomy(ends_of(this.u.values), room);
    this.areas = this.series.map(({ kind, unit, values, largest }, i) => {
      const box = { left: margin.left, top: i * step + margin.top, width: width - margin.left - margin.right, height: height_of_plot };
      const area = new ChartArea(
        box, { range: along, ticks: box.width / 55, bare: i < last, title: i === last ? `u (${this.u.unit.name})` : undefined },
        { range: roomy(ends_of(values), room), ticks: 3, downwards: kind.downwards, title: unit.name ? `${kind.symbol} (${unit.name})` : kind.symbol });
      area.inside.append(...this.curves(area, this.u.values[k], values[k]));
      if (largest.slice === k) {
        const [x, y] = [area.x(this.u.values[k][largest.row] ?? 0), area.y(values[k][largest.row] ?? 0)];
        area.element.append(svg_element("circle", { cx: x, cy: y, r: 6, class: "line_ring" }, svg_element("title", {}, "the largest of all slices")));
      }
      area.element.append(card.dots[i]);
      svg.append(area.element);
      return area;
    });
    card.holder.replaceChildren(svg);
  }

  /** A curve for each stage, in the colour of its warmth. */
  private curves(area: ChartArea, u: (number | null)[], values: (number | null)[]): SVGPathElement[] {
    const made: SVGPathElement[] = [];
    let x: number[] = [], y: number[] = [];
    this.rows.forEach((row, i) => {
      const stage = this.run.stage[row], another = i + 1 === this.rows.length || this.run.stage[this.rows[i + 1]] !== stage;
      if (u[i] !== null && values[i] !== null) x.push(u[i]!), y.push(values[i]!);
      if (!another || x.length === 0) return;
      made.push(area.path({ look: `line_end ${warmth_of(this.ends, stage)}`, x, y }));
      [x, y] = [[x[x.length - 1]], [y[y.length - 1]]];
    });
    return made;
  }
}

/** A column of a slice; that at x = 0 has those of the run. */
function column_of(slice: number, column: string): string {
  return slice === 0 ? column : `slice_${slice}_${column}`;
}

/** Whether there is something to show in cards. */
export function has_cards(run: LineRun): boolean {
  return run.line.slices.length > 1 && run.line.ends.length > 0;
}

/** The lowest and the highest; infinity and -infinity of none. */
function ends_of(values: (number | null)[][]): [low: number, high: number] {
  let low = Infinity, high = -Infinity;
  for (const value of values.flat()) if (value !== null) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return [low, high];
}
