// SPDX-License-Identifier: BSD-3-Clause
/** Calls `advance` with the seconds since the last call, while it plays, until that returns false; held where nobody looks. */
export class Clock {
  private running = false;
  private held = false;
  private pending = 0;
  private last = 0;

  constructor(
    private advance: (seconds: number) => boolean,
    private changed: (playing: boolean) => void,
  ) {}

  get playing(): boolean {
    return this.running;
  }

  play(): void {
    if (this.running) return;
    this.running = true;
    this.changed(true);
    this.wait();
  }

  pause(): void {
    if (!this.running) return;
    this.running = false;
    cancelAnimationFrame(this.pending);
    this.pending = 0;
    this.changed(false);
  }

  /** Stops for as long as the film is out of sight; it goes on where it stopped. */
  hold(held: boolean): void {
    this.held = held;
    if (held) {
      cancelAnimationFrame(this.pending);
      this.pending = 0;
    } else if (this.running && this.pending === 0) {
      this.wait();
    }
  }

  private wait(): void {
    this.last = -1;
    if (!this.held) this.pending = requestAnimationFrame((now) => this.tick(now));
  }

  private tick(now: number): void {
    // A slow machine skips; after a long pause the film does not jump.
    const seconds = this.last < 0 ? 0 : Math.min(0.25, (now - this.last) / 1000);
    this.last = now;
    if (!this.advance(seconds)) this.pause();
    // Only now, so that what `advance` asked to have drawn is drawn before the next tick, not after it.
    if (this.running) this.pending = requestAnimationFrame((next) => this.tick(next));
  }
}
