// SPDX-License-Identifier: BSD-3-Clause
// Where labels of marks stand: within the plotting area, off each other and off the lines as far as there is room.

/** px from the left top corner. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

type Point = [x: number, y: number];

// What a label may cost, in cells of lines that it hides: one over another cannot be read, one somewhat farther from its mark can.
const cost_of_box = 10000, cost_of_distance = 0.5, cost_of_later = 0.02;

export class LabelPlaces {
  private readonly columns: number;
  private readonly lines: Uint8Array;
  private readonly boxes: Box[] = [];

  /** `cell`: px within which a label counts as on a line. */
  constructor(readonly area: Box, private readonly cell: number) {
    this.columns = Math.ceil(area.width / cell) + 1;
    this.lines = new Uint8Array(this.columns * (Math.ceil(area.height / cell) + 1));
  }

  /** Keeps labels off a line through these points; null breaks it. */
  avoid_line(points: (Point | null)[]): void {
    for (let i = 0; i < points.length; i++) {
      const here = points[i];
      if (here !== null) this.avoid_piece(points[i - 1] ?? here, here);
    }
  }

  avoid_box(box: Box): void {
    this.boxes.push(box);
  }

  /** Takes the best box for the label of a mark at x, y, and rather an earlier one; those that lie partly outside of the area are moved into it. */
  take(x: number | null, y: number | null, candidates: Box[]): Box {
    let best = candidates[0], least = Infinity;
    candidates.forEach((candidate, index) => {
      const box = this.moved_in(candidate);
      const away = Math.hypot(distance(x, box.left, box.width), distance(y, box.top, box.height)) / this.cell;
      const cost = this.cost(box) + cost_of_distance * away + cost_of_later * index;
      if (cost < least) (least = cost), (best = box);
    });
    this.boxes.push(best);
    return best;
  }

  private cost(box: Box): number {
    let cost = 0;
    for (const other of this.boxes) if (overlap(box, other)) cost += cost_of_box;
    const first_column = this.column(box.left), last_column = this.column(box.left + box.width);
    const last_row = this.row(Math.min(box.top + box.height, this.area.top + this.area.height));
    for (let row = this.row(box.top); row <= last_row; row++)
      for (let column = first_column; column <= Math.min(last_column, this.columns - 1); column++) cost += this.lines[row * this.columns + column];
    return cost;
  }

  private column(x: number): number {
    return Math.floor((x - this.area.left) / this.cell);
  }

  private row(y: number): number {
    return Math.floor((y - this.area.top) / this.cell);
  }

  private avoid_piece([x0, y0]: Point, [x1, y1]: Point): void {
    const part = part_within(this.area, x0, y0, x1 - x0, y1 - y0);
    if (part === null) return;
    const [from, to] = part;
    const steps = Math.max(1, Math.ceil(((to - from) * Math.hypot(x1 - x0, y1 - y0)) / this.cell));
    for (let i = 0; i <= steps; i++) {
      const at = from + ((to - from) * i) / steps;
      this.lines[this.row(y0 + at * (y1 - y0)) * this.columns + this.column(x0 + at * (x1 - x0))] = 1;
    }
  }

  private moved_in(box: Box): Box {
    const within = (at: number, size: number, from: number, length: number) => Math.max(from, Math.min(at, from + length - size));
    return {
      ...box,
      left: within(box.left, box.width, this.area.left, this.area.width),
      top: within(box.top, box.height, this.area.top, this.area.height),
    };
  }
}

function distance(at: number | null, from: number, length: number): number {
  return at === null ? 0 : Math.max(from - at, 0, at - from - length);
}

function overlap(a: Box, b: Box): boolean {
  return a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height;
}

/** From what part to what part of a piece (dx, dy) it lies within the area; null: nowhere. */
function part_within(area: Box, x: number, y: number, dx: number, dy: number): [from: number, to: number] | null {
  let from = 0, to = 1;
  for (const [at, step, low, size] of [[x, dx, area.left, area.width], [y, dy, area.top, area.height]]) {
    if (step === 0) {
      if (at < low || at > low + size) return null;
      continue;
    }
    const ends = [(low - at) / step, (low + size - at) / step];
    from = Math.max(from, Math.min(...ends));
    to = Math.min(to, Math.max(...ends));
  }
  return from <= to ? [from, to] : null;
}

/** Levels before points: there are fewer places for their labels. */
export function levels_first<M extends { x: number | null; y: number | null }>(marks: M[]): M[] {
  const is_point = (mark: M) => mark.x !== null && mark.y !== null;
  return [...marks.filter((mark) => !is_point(mark)), ...marks.filter(is_point)];
}

/** Places for the label of a mark at x, y: beside a point; along a level, where one of both is null. All of it in px, of which `unit` make one of the page. */
export function candidates(x: number | null, y: number | null, width: number, height: number, area: Box, unit: number): Box[] {
  const box = (left: number, top: number): Box => ({ left, top, width, height });
  if (x !== null && y !== null) {
    const around = [9, 16, 24, 36, 52].map((each) => each * unit);
    const sides = (gap: number): Box[] => [box(x + gap, y - height / 2), box(x - gap - width, y - height / 2)];
    const corners = (gap: number): Box[] => [-gap - height, gap].flatMap((down) => [box(x + 0.6 * gap, y + down), box(x - 0.6 * gap - width, y + down)]);
    const ends = (gap: number): Box[] => [box(x - width / 2, y - gap - height), box(x - width / 2, y + gap)];
    return around.flatMap((gap) => [...sides(gap), ...corners(gap), ...ends(gap)]);
  }
  if (y !== null) {
    const room = area.width - width - 8 * unit;
    return [1, 0.75, 0.5, 0.25, 0].flatMap((part) => {
      const left = area.left + 4 * unit + part * room;
      return [box(left, y - 3 * unit - height), box(left, y + 3 * unit)];
    });
  }
  if (x === null) return [];
  const places: Box[] = [];
  for (let top = area.top + 4 * unit; top === area.top + 4 * unit || top + height < area.top + area.height; top += 14 * unit)
    places.push(box(x + 4 * unit, top), box(x - 4 * unit - width, top));
  return places;
}
