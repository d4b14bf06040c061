// SPDX-License-Identifier: BSD-3-Clause
// What is made of the shapes of a line, without a page.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { RunData } from "../src/data";
import { roomy } from "../src/line_drawing";
import { column_at, exaggeration, exaggeration_words, extremes, type LineRun, mirrored, shape_at, swept, value_at } from "../src/line_shapes";
import { stage_ends, warmth_of } from "../src/line_stages";

const numbers = (...values: number[]) => Float64Array.from(values);

test("the_other_half_is_a_mirror_image_or_turned_by_half_a_turn", () => {
  assert.deepEqual(mirrored(numbers(5, 3, 1), 1), numbers(1, 3, 5, 3, 1));
  assert.deepEqual(mirrored(numbers(0, 3, 1), -1), numbers(-1, -3, 0, 3, 1));
});

test("between_frames_a_shape_lies_on_the_straight_line", () => {
  const frames = [numbers(0, 2), numbers(4, 2), numbers(4, 0)];
  assert.deepEqual(shape_at(frames, 0.25), numbers(1, 2));
  assert.deepEqual(shape_at(frames, 2), numbers(4, 0));
});

test("the_strip_that_was_swept_holds_all_frames_so_far_and_half_a_diameter_more", () => {
  const frames = [numbers(0, 1), numbers(2, -1), numbers(1, 5)];
  const { low, high } = swept(frames, 1.5, 0.5);
  assert.deepEqual(low, numbers(-0.5, -1.5));
  assert.deepEqual(high, numbers(2.5, 2.5), "half of the way to the third frame");
});

test("numbers_between_nodes_and_extremes_of_a_part_of_the_line", () => {
  const x = numbers(-2, 0, 2), y = numbers(1, 3, -1);
  assert.equal(value_at(x, y, 1), 1);
  assert.equal(value_at(x, y, 9), -1);
  assert.deepEqual(extremes(x, [y, numbers(9, 4, 9)], 1), [3, 4]);
});

test("y_is_drawn_larger_by_a_round_number_that_fits", () => {
  assert.equal(exaggeration(2.5, 5, 250), 20);
  assert.equal(exaggeration(2.5, 5, 125), 10);
  assert.equal(exaggeration(2.5, 5, 124), 5);
  assert.equal(exaggeration(100, 5, 250), 0.5);
  assert.equal(exaggeration_words(10), "y is drawn 10 times larger than x");
  assert.equal(exaggeration_words(1), "to scale");
  assert.equal(exaggeration_words(0.2), "y is drawn 5 times smaller than x");
});

test("an_axis_holds_zero_and_has_room_where_it_does_not_end_there", () => {
  assert.deepEqual(roomy([1, 2], 0.1), [0, 2.2]);
  assert.deepEqual(roomy([-2, -1], 0.1), [-2.2, 0]);
  assert.deepEqual(roomy([0, 0], 0.1), [0, 1]);
});

/** Two cycles between 0 and 300 kN, or none where nothing is heated. */
function cycles(largest: number): LineRun {
  const ends = ["heat", "cool", "heat_2", "cool_2"].map((name, frame) => ({ name, frame }));
  return {
    columns: { time_s: [0, 1, 2, 3], line_P0_N: [largest, 0.1 * largest, largest, 0.1 * largest] },
    line: { ends, frames: ends.map(({ name, frame }) => ({ time: frame, stage: name })) },
  } as unknown as LineRun;
}

test("stages_are_hot_or_cold_by_their_compression_and_like_ones_differ_by_dashes", () => {
  const ends = stage_ends(cycles(3e5));
  assert.deepEqual(ends.map((end) => end.warmth), ["hot", "cold", "hot", "cold"]);
  assert.equal(ends[0].dash, ends[1].dash);
  assert.notEqual(ends[0].dash, ends[2].dash);
  assert.equal(warmth_of(ends, "cool_2"), "cold");
  assert.equal(warmth_of(ends, "lay"), "plain");
  assert.deepEqual(stage_ends(cycles(0)).map((end) => end.warmth), ["plain", "plain", "plain", "plain"]);
});

test("a_column_at_a_time_lies_between_its_rows", () => {
  const run = { columns: { time_s: [0, 1, 3], T: [10, 20, null], p: [0, 4, 8] } } as unknown as RunData;
  assert.equal(column_at(run, "T", 0.5), 15);
  assert.equal(column_at(run, "p", 2), 6);
  assert.equal(column_at(run, "p", 7), 8);
  assert.equal(column_at(run, "T", 2), null);
  assert.equal(column_at(run, "no_column", 1), null);
});
