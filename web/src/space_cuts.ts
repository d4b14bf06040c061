// SPDX-License-Identifier: BSD-3-Clause
// Planes that cut the soil in space, one across each axis.
import { choice, make, set_options } from "./film_elements";
import { place_text } from "./film_numbers";
import type { SpaceBox, Vector } from "./space_parts";

const SIDES = { off: "all", below: "up to", above: "from", slice: "slice at" } as const;
export type Side = keyof typeof SIDES;

/** m: what is kept, from and to, along each axis. */
export type Kept = SpaceBox;

export interface Cut {
  side: Side;
  /** m */
  at: number;
}

/** What the cuts keep; a slice is `thickness` m thick. */
export function kept_by(cuts: readonly Cut[], thickness: number): Kept {
  const ends = (cut: Cut): [number, number] => {
    if (cut.side === "below") return [-Infinity, cut.at];
    if (cut.side === "above") return [cut.at, Infinity];
    return cut.side === "slice" ? [cut.at - thickness / 2, cut.at + thickness / 2] : [-Infinity, Infinity];
  };
  const all = cuts.map(ends);
  return { lower: all.map(([from]) => from) as Vector, upper: all.map(([, to]) => to) as Vector };
}

/** The controls of the three cuts. */
export class CutControls {
  readonly element = make("div", "space-cuts");
  readonly cuts: Cut[] = [0, 1, 2].map(() => ({ side: "off", at: 0 }));
  private shown: { side: ReturnType<typeof choice>; slider: HTMLInputElement; text: HTMLOutputElement }[] = [];

  constructor(private changed: () => void) {
    for (const [axis, name] of ["x", "y", "z"].entries()) {
      const side = choice("space-cut-side", name, (value) => this.set_side(axis, value as Side));
      side.select.setAttribute("aria-label", `Cut across ${name}: what is kept`);
      set_options(side.select, Object.entries(SIDES), "off");
      const slider = make("input", "space-cut-at"), text = make("output", "space-cut-text");
      slider.type = "range";
      slider.setAttribute("aria-label", `Cut across ${name}: position`);
      slider.addEventListener("input", () => this.set_place(axis, slider.valueAsNumber));
      this.shown.push({ side, slider, text });
      this.element.append(make("div", "space-cut", side.label, slider, text));
    }
  }

  /** The sliders go over this box; cuts begin in its middle. */
  set_box(box: SpaceBox): void {
    for (const [axis, { slider }] of this.shown.entries()) {
      const [low, high] = [box.lower[axis], box.upper[axis]];
      slider.min = String(low);
      slider.max = String(high);
      slider.step = String((high - low) / 200);
      this.cuts[axis].at = (low + high) / 2;
    }
    this.show();
  }

  private set_side(axis: number, side: Side): void {
    this.cuts[axis].side = side;
    this.show();
    this.changed();
  }

  private set_place(axis: number, at: number): void {
    this.cuts[axis].at = at;
    this.show();
    this.changed();
  }

  private show(): void {
    for (const [axis, { side, slider, text }] of this.shown.entries()) {
      const cut = this.cuts[axis], place = `${place_text(cut.at, Number(slider.max) - Number(slider.min))} m`;
      side.select.value = cut.side;
      slider.value = String(cut.at);
      slider.disabled = cut.side === "off";
      text.value = cut.side === "off" ? "" : place;
      slider.setAttribute("aria-valuetext", place);
    }
  }
}
