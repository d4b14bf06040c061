// SPDX-License-Identifier: BSD-3-Clause
// Labels of marks in an area of 300 by 200 px.
import assert from "node:assert/strict";
import { test } from "node:test";
import { type Box, candidates, LabelPlaces } from "../src/charts/label_places";

const area: Box = { left: 50, top: 10, width: 300, height: 200 };
const [width, height] = [80, 13];

function places(...lines: ([number, number] | null)[][]): LabelPlaces {
  const made = new LabelPlaces(area, 3);
  for (const line of lines) made.avoid_line(line);
  return made;
}

/** The place of a label, once the mark itself (10 px wide where it is a point) has taken its own. */
function label(in_places: LabelPlaces, x: number | null, y: number | null, wide = width): Box {
  if (x !== null && y !== null) in_places.avoid_box({ left: x - 5, top: y - 5, width: 10, height: 10 });
  return in_places.take(x, y, candidates(x, y, wide, height, area, 1));
}

function lies_within(box: Box): boolean {
  return box.left >= 50 && box.top >= 10 && box.left + box.width <= 350 && box.top + box.height <= 210;
}

test("a_label_with_room_stands_to_the_right_of_its_point", () => {
  assert.deepEqual(label(places(), 100, 100), { left: 109, top: 93.5, width, height });
});

test("a_label_at_an_edge_stays_within", () => {
  for (const [x, y] of [[50, 10], [350, 10], [50, 210], [350, 210], [200, 10], [350, 100]]) {
    const box = label(places(), x, y);
    assert.ok(lies_within(box), `${x}, ${y}: ${JSON.stringify(box)}`);
    assert.ok(box.left > x || box.left + width < x || box.top > y || box.top + height < y, "beside its point");
  }
});

test("a_label_too_wide_for_either_side_is_moved_above_or_below", () => {
  const box = label(places(), 200, 100, 280);
  assert.ok(lies_within(box));
  assert.ok(box.top > 100 || box.top + height < 100);
});

test("a_label_keeps_off_a_line", () => {
  // From the left to the right, through the point itself.
  const line: [number, number][] = [[50, 100], [350, 100]];
  const box = label(places(line), 100, 100);
  assert.ok(box.top + height < 100 - 1 || box.top > 100 + 1, JSON.stringify(box));
});

test("a_line_far_outside_the_area_takes_no_time_and_no_room", () => {
  const line: [number, number][] = [[-1e9, -1e9], [1e9, -1e9], [1e9, 100], [-1e9, 100]];
  const box = label(places(line), 100, 100);
  assert.ok(box.top + height < 100 - 1 || box.top > 100 + 1, "the piece within the area counts");
  assert.deepEqual(label(places([[-1e9, -1e9], [1e9, -1e9]]), 100, 100), label(places(), 100, 100));
});

test("a_broken_line_leaves_its_gap_free", () => {
  assert.deepEqual(label(places([[60, 100], null, [340, 180]]), 150, 120), label(places(), 150, 120));
});

test("labels_keep_off_each_other_and_off_boxes", () => {
  const shared = places();
  const boxes = [100, 100, 102, 101].map((y) => label(shared, 200, y));
  boxes.forEach((a, i) => boxes.slice(i + 1).forEach((b) => assert.ok(Math.abs(a.left - b.left) >= width || Math.abs(a.top - b.top) >= height)));
  const right = places();
  right.avoid_box({ left: 105, top: 90, width: 245, height: 20 });
  const box = label(right, 100, 100);
  assert.ok(box.left + width <= 100 || box.top + height <= 90 || box.top >= 110, JSON.stringify(box));
});

test("labels_of_levels_near_each_other_are_apart", () => {
  const shared = places();
  const [a, b] = [label(shared, null, 100), label(shared, null, 102)];
  assert.ok(Math.abs(a.left - b.left) >= width || Math.abs(a.top - b.top) >= height);
  assert.ok(lies_within(label(places(), null, 11)), "a level at the top");
  assert.ok(lies_within(label(places(), 349, null)), "an upright at the right");
});
