// SPDX-License-Identifier: BSD-3-Clause
// Mouse, fingers and keys on the picture.

/** Goes through a film by keys. */
export interface KeyPlayer {
  play(): void;
  step(frames: number): void;
  first(): void;
  last(): void;
}

export interface Gestures extends KeyPlayer {
  /** px of the page: the soil follows the pointer. */
  drag(right: number, down: number): void;
  /** Zooms about a point, in px of the page from the element's corner; null: about the middle. */
  zoom(factor: number, about: { x: number; y: number } | null): void;
  region(): void;
  /** With Shift held, and by two fingers; without it these are drags. */
  pan?(right: number, down: number): void;
  /** What other keys do. */
  keys?: Record<string, () => void>;
}

export const KEYS_HELP =
  "Dashed is the surface at the start. Keys, after a click on the picture: space plays, ← → go frame by frame, Home and End to the first and last; + and − or the wheel zoom, " +
  "a drag or Shift with arrows moves the picture, 0 shows the region of interest. Ctrl with the wheel zooms without the click; two fingers zoom.";

const ZOOM_STEP = 1.25;
/** px of the page for one press of Shift with an arrow. */
const KEY_PAN = 40;

export function listen(stage: HTMLElement, gestures: Gestures): void {
  listen_to_pointers(stage, gestures);
  stage.addEventListener(
    "wheel",
    (event) => {
      // Without a click on it first the picture would catch those who scroll the page.
      if (!event.ctrlKey && !event.metaKey && document.activeElement !== stage) return;
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      gestures.zoom(Math.exp(-Math.max(-200, Math.min(200, event.deltaY * lines)) * 0.002), place(stage, event));
    },
    { passive: false },
  );
  listen_to_keys(stage, (event) => key_action(event, gestures));
}

/** Does what a key stands for while the stage is chosen. */
export function listen_to_keys(stage: HTMLElement, action_of: (event: KeyboardEvent) => (() => void) | undefined): void {
  stage.addEventListener("keydown", (event) => {
    if (event.target !== stage || event.ctrlKey || event.metaKey || event.altKey) return;
    const action = action_of(event);
    if (action === undefined) return;
    event.preventDefault();
    action();
  });
}

/** Keys that go through a film. */
export function player_keys(player: KeyPlayer): Record<string, () => void> {
  return {
    " ": () => player.play(),
    ArrowLeft: () => player.step(-1),
    ArrowRight: () => player.step(1),
    Home: () => player.first(),
    End: () => player.last(),
  };
}

function key_action(event: KeyboardEvent, gestures: Gestures): (() => void) | undefined {
  if (event.shiftKey) {
    const pans: Record<string, [number, number]> = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const pan = pans[event.key];
    if (pan !== undefined) return () => gestures.drag(KEY_PAN * pan[0], KEY_PAN * pan[1]);
  }
  const actions: Record<string, () => void> = {
    ...player_keys(gestures),
    "+": () => gestures.zoom(ZOOM_STEP, null),
    "=": () => gestures.zoom(ZOOM_STEP, null),
    "-": () => gestures.zoom(1 / ZOOM_STEP, null),
    "0": () => gestures.region(),
  };
  return actions[event.key] ?? gestures.keys?.[event.key];
}

function listen_to_pointers(stage: HTMLElement, gestures: Gestures): void {
  const down = new Map<number, { x: number; y: number }>();
  stage.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    stage.setPointerCapture(event.pointerId);
    down.set(event.pointerId, place(stage, event));
  });
  stage.addEventListener("pointermove", (event) => {
    const before = down.get(event.pointerId);
    if (before === undefined) return;
    const now = place(stage, event);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    down.set(event.pointerId, now);
    if (other === undefined) {
      if (event.shiftKey && gestures.pan !== undefined) gestures.pan(now.x - before.x, now.y - before.y);
      else gestures.drag(now.x - before.x, now.y - before.y);
      return;
    }
    const apart = (point: { x: number; y: number }) => Math.max(10, Math.hypot(point.x - other.x, point.y - other.y));
    (gestures.pan ?? gestures.drag)((now.x - before.x) / 2, (now.y - before.y) / 2);
    gestures.zoom(apart(now) / apart(before), { x: (now.x + other.x) / 2, y: (now.y + other.y) / 2 });
  });
  const lift = (event: PointerEvent) => down.delete(event.pointerId);
  stage.addEventListener("pointerup", lift);
  stage.addEventListener("pointercancel", lift);
}

function place(stage: HTMLElement, event: MouseEvent): { x: number; y: number } {
  const box = stage.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}
