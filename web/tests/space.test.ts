// SPDX-License-Identifier: BSD-3-Clause
// The soil in space and both halves around an axis, without a browser: what is seen, what is kept, where places come to lie.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { FilmData } from "../src/data";
import { mirrored_film, mirrored_soil } from "../src/film_mirror";
import { axis_base, axis_title, place_text } from "../src/film_numbers";
import type { Soil } from "../src/film_soil";
import { axes_of, closer, dot, seeing, shifted, turned, VIEWS } from "../src/space_camera";
import { kept_by } from "../src/space_cuts";
import { length_text, round_length } from "../src/space_marks";
import { edges_of } from "../src/space_painter";
import { on_surface, seen_box, type SpaceBox, type SpaceSoil, type Vector } from "../src/space_parts";

const box: SpaceBox = { lower: [-1, -2, -3], upper: [5, 2, 1] };

function close(a: ArrayLike<number>, b: ArrayLike<number>, within = 1e-12): void {
  for (let d = 0; d < b.length; d++) assert.ok(Math.abs(a[d] - b[d]) <= within, `${Array.from(a).join()} is not ${Array.from(b).join()}`);
}

test("directions_of_a_view_are_a_right_handed_frame", () => {
  for (const { azimuth, elevation } of [...Object.values(VIEWS), { azimuth: 2.3, elevation: -0.7 }]) {
    const { right, up, back } = axes_of({ azimuth, elevation, target: [0, 0, 0], height: 1 });
    close([dot(right, up), dot(up, back), dot(back, right), dot(right, right), dot(up, up)], [0, 0, 0, 1, 1]);
    close([right[1] * up[2] - right[2] * up[1], right[2] * up[0] - right[0] * up[2], right[0] * up[1] - right[1] * up[0]], back);
  }
});

test("standard_views_show_the_axes_that_engineers_expect", () => {
  const seen = (view: keyof typeof VIEWS) => axes_of({ ...VIEWS[view], target: [0, 0, 0], height: 1 });
  close(seen("front").right, [1, 0, 0]);
  close(seen("front").up, [0, 1, 0]);
  close(seen("side").right, [0, 0, -1]);
  close(seen("above").right, [1, 0, 0]);
  close(seen("above").back, [0, 1, 0]);
  const { back } = seen("iso");
  close(back, [1, 1, 1].map((x) => x / Math.sqrt(3)));  // all axes are shortened alike
});

test("a_box_is_seen_whole_from_everywhere", () => {
  for (const aspect of [0.5, 1, 2])
    for (const view of Object.values(VIEWS)) {
      const camera = seeing(box, view, aspect), { right, up } = axes_of(camera);
      const edges = edges_of(box);
      for (let i = 0; i < edges.length; i += 3) {
        const from = [0, 1, 2].map((d) => edges[i + d] - camera.target[d]);
        assert.ok(Math.abs(dot(up, from)) <= camera.height / 2 && Math.abs(dot(right, from)) <= (camera.height * aspect) / 2);
      }
    }
});

test("zooming_keeps_the_place_under_the_pointer", () => {
  const camera = seeing(box, VIEWS.iso, 1.5), near = closer(camera, 3, 0.4, -0.2);
  const place = (c: typeof camera): Vector => {
    const { right, up } = axes_of(c);
    return c.target.map((x, d) => x + c.height * (0.4 * right[d] - 0.2 * up[d])) as Vector;
  };
  close(place(near), place(camera), 1e-9);
  assert.equal(near.height, camera.height / 3);
});

test("turning_stops_above_and_shifting_moves_the_soil_with_the_pointer", () => {
  const camera = seeing(box, VIEWS.front, 1);
  assert.equal(turned(camera, 0, 9).elevation, Math.PI / 2);
  assert.equal(turned(camera, 0, -9).elevation, -Math.PI / 2);
  const moved = shifted(camera, 0.1, 0.2);  // to the right and down: what is in the middle lay to the left and above
  close(moved.target, [camera.target[0] - 0.1 * camera.height, camera.target[1] + 0.2 * camera.height, camera.target[2]]);
});

test("cuts_keep_what_their_words_say", () => {
  const kept = kept_by([{ side: "below", at: 1 }, { side: "above", at: 2 }, { side: "slice", at: 3 }], 0.5);
  assert.deepEqual(kept, { lower: [-Infinity, 2, 2.75], upper: [1, Infinity, 3.25] });
  assert.deepEqual(kept_by([0, 1, 2].map((at) => ({ side: "off" as const, at })), 1), { lower: [-Infinity, -Infinity, -Infinity], upper: [Infinity, Infinity, Infinity] });
});

test("places_at_survey_coordinates_keep_their_digits", () => {
  assert.equal(place_text(0.1234, 0.5), "0.123");
  assert.equal(place_text(-1499.8765, 1.5), "−1499.88");
  assert.equal(place_text(6543210.9876, 0.5), "6543210.988");
});

test("an_axis_far_from_the_origin_counts_from_a_round_number", () => {
  assert.equal(axis_base(-0.2, 3), 0);
  assert.equal(axis_base(-12.2, -12.1), 0);
  assert.equal(axis_base(499876.3, 499877.8), 499900);
  assert.equal(axis_base(-1500.4, -1499.6), -1500);
  assert.equal(axis_title("x", 0, "mm"), "x (mm)");
  assert.equal(axis_title("x", 499900, "m"), "x − 499900 m (m)");
  assert.equal(axis_title("y", -1500, "mm"), "y + 1500 m (mm)");
});

test("lengths_of_the_bar_are_round", () => {
  assert.deepEqual([0.0199, 0.02, 0.7, 1, 4.9].map(round_length).map(length_text), ["10.0 mm", "20.0 mm", "500 mm", "1.00 m", "2.00 m"]);
});

/** Four particles of 10 codes: two of a column, one beside them, one high above in another column. */
const soil: SpaceSoil = {
  count: 4, lower: [0, 0, 0], step: 0.01, places: [Uint16Array.from([5, 5, 5, 5, 30, 5, 40, 6, 5, 5, 90, 90])], sizes: new Uint16Array(4).fill(10),
  box: { lower: [0, 0, 0], upper: [1, 1, 1] },
};

test("surface_is_the_highest_particle_of_each_column", () => {
  assert.deepEqual([...on_surface(soil, 0)], [0, 1, 1, 1]);
});

test("a_view_holds_bodies_above_the_soil_up_to_its_own_depth", () => {
  const body = (top: number) => ({ name: "", triangles: new Uint32Array(0), corners: [Float64Array.from([0, top, 0])] });
  assert.equal(seen_box(soil, [body(1.5)]).upper[1], 1.5);
  assert.equal(seen_box(soil, [body(50)]).upper[1], 2);
  assert.equal(seen_box(soil, []).upper[1], 1);
});

test("both_halves_lie_at_the_radius_within_a_step", () => {
  const half = { count: 2, lower: [0.5, -1], step: 0.001, view: { lower: [0.5, -1], upper: [2, 0] }, rigids: [{ name: "cone", points: 3, block: "b" }] } as unknown as FilmData;
  const film = mirrored_film(half);
  const codes = Uint16Array.from([0, 0, 65535, 400]);
  const of_half = { ...half, places: [codes], sizes: Uint16Array.from([100, 200]), largest_size: 200, triangles: Uint32Array.from([0, 1, 1]), bounds: half.view } as unknown as Soil;
  const both = mirrored_soil(of_half, film);
  assert.equal(both.count, 4);
  assert.deepEqual(film.view.lower, [-2, -1]);
  const place = (p: number) => [0, 1].map((d) => film.lower[d] + film.step * both.places[0][2 * p + d]);
  const wanted = [[0.5, -1], [66.035, -0.6], [-0.5, -1], [-66.035, -0.6]];
  for (const [p, at] of wanted.entries()) close(place(p), at, film.step);
  assert.deepEqual([...both.triangles!], [0, 1, 1, 2, 3, 3]);
  assert.ok(Math.abs(both.sizes![1] * film.step - 0.2) <= film.step);
  assert.deepEqual(film.rigids.map((rigid) => rigid.mirrored ?? false), [false, true]);
});
