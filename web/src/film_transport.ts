// SPDX-License-Identifier: BSD-3-Clause
// What plays a film and goes through it: buttons, a slider over its frames, and where it is in words.
import { button, choice, icon, make, set_options } from "./film_elements";

const SPEEDS = [1, 2, 5, 10, 20, 40];

/** A list of speeds in frames a second. */
export function speed_choice(name: string, speed: number, chosen: (speed: number) => void): HTMLLabelElement {
  const { label, select } = choice(name, "Speed", (value) => chosen(Number(value)));
  set_options(select, SPEEDS.map((frames) => [String(frames), `${frames} frame${frames === 1 ? "" : "s"}/s`]), String(speed));
  return label;
}

/** What the reader asks of a film. */
export interface Player {
  play(): void;
  step(frames: number): void;
  move(at: number): void;
}

export class Transport {
  readonly element: HTMLElement;
  private play: HTMLButtonElement;
  private slider = make("input", "film-frame");
  private frame = make("output", "film-frame-text");

  constructor(player: Player) {
    this.play = button("film-play", icon("play"), "Play", () => player.play());
    this.slider.type = "range";
    this.slider.min = "0";
    this.slider.step = "1";
    this.slider.addEventListener("input", () => player.move(this.slider.valueAsNumber));
    this.element = make(
      "div", "film-transport",
      this.play,
      button("film-back", icon("back"), "One frame back", () => player.step(-1)),
      button("film-forward", icon("forward"), "One frame forward", () => player.step(1)),
      this.slider, this.frame);
  }

  set_frames(last: number, name: string): void {
    this.slider.max = String(last);
    this.slider.setAttribute("aria-label", `Frame of ${name}`);
  }

  show_playing(playing: boolean): void {
    this.play.replaceChildren(icon(playing ? "pause" : "play"));
    this.play.title = playing ? "Pause" : "Play";
    this.play.setAttribute("aria-label", this.play.title);
  }

  /** `sentence` is for those who hear the page. */
  show(at: number, last: number, sentence: string): void {
    this.slider.value = String(Math.round(at));
    this.slider.setAttribute("aria-valuetext", sentence);
    this.frame.value = frame_text(at, last);
  }
}

/** The frame's number, or those of the two that the moment lies between. */
export function frame_text(at: number, last: number): string {
  const near = Math.abs(at - Math.round(at)) < 1e-3;
  return `frame ${near ? Math.round(at) : `${Math.floor(at)}\u2013${Math.ceil(at)}`} of ${last}`;
}
