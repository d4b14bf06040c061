// SPDX-License-Identifier: BSD-3-Clause

/** What the desk shows at an address. */
export interface Place {
  readonly element: HTMLElement;
  readonly title: string;
  /** False: the reader wants to stay. */
  may_leave?(): boolean;
  leave?(): void;
  /** True where the keys were meant for it. */
  keys?(event: KeyboardEvent): boolean;
}
