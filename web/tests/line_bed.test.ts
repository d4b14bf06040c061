// SPDX-License-Identifier: BSD-3-Clause
// The bed under a line in plan, without a page.
import assert from "node:assert/strict";
import { test } from "node:test";
import { heaped_words, most_of, patches_at, shade_of } from "../src/line_bed";
import type { LineRun } from "../src/line_shapes";

const numbers = (...values: number[]) => Float64Array.from(values);

/** Two slices, 4 m apart, with three columns of 0.1 m; the first was laid at y = 0.5 m. */
function line(half: "symmetric" | "antisymmetric" | "none"): LineRun {
  return { line: { half, slices: [0, 4], bed: { first: 1, frames: 2, y: [-0.1, 0, 0.1] } } } as unknown as LineRun;
}
const shapes = { x: numbers(-4, 0, 4), y: [numbers(0, 0.5, 0)], rise: [numbers(0, 0, 0, 0, 0, 0), numbers(-0.2, 0.4, 0.4, 0, 0, 0.2)] };
const near = (patch: { shade: number; x: number[]; y: number[] }) => [patch.shade, ...[...patch.x, ...patch.y].map((value) => Number(value.toFixed(6)))];

test("shades_grow_with_the_rise_and_little_is_left_blank", () => {
  const most = most_of(shapes.rise);
  assert.deepEqual(most, { up: 0.4, down: 0.2 });
  assert.deepEqual([0.4, 0.2, 0.03, 0, -0.2, -0.05].map((rise) => shade_of(rise, most)), [5, 3, 0, 0, -5, -2]);
});

test("columns_of_one_shade_are_one_patch_and_count_from_where_the_pipe_was_laid", () => {
  assert.deepEqual(patches_at(line("none"), shapes, 2).map(near), [[-5, 0, 2, 0.35, 0.45], [5, 0, 2, 0.45, 0.65], [3, 2, 4, 0.05, 0.15]]);
});

test("the_other_half_is_mirrored_or_turned", () => {
  assert.deepEqual(patches_at(line("symmetric"), shapes, 2).map(near).slice(4), [[3, 2, 4, 0.05, 0.15], [3, -4, -2, 0.05, 0.15]]);
  assert.deepEqual(patches_at(line("antisymmetric"), shapes, 2).map(near).slice(4), [[3, 2, 4, 0.05, 0.15], [3, -4, -2, -0.15, -0.05]]);
});

test("there_is_none_before_the_line_hangs", () => {
  assert.deepEqual(patches_at(line("symmetric"), shapes, 0.9), []);
  assert.equal(heaped_words([]), null);
  assert.match(heaped_words(shapes.rise)!, /up to 0\.4.* m; blue: displaced, by up to 0\.2/);
});
