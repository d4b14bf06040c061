// SPDX-License-Identifier: BSD-3-Clause
// The flow of the water: bytes become arrows, and the page shows them where it is asked to.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import type { FlowData } from "../src/data";
import { arrows_of, decode_flow } from "../src/film_flow";
import { launch_browser, report_data, take_screenshot } from "./browser";
import { after_drawing, difference, panel, pixels, set_frame, with_film_page } from "./film_page";

const file = process.env.BERM_WATER_REPORT!;
let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const with_page = with_film_page(() => browser);

const flow: FlowData = { lower: [0, -2], side: 1, columns: 2, rows: 2, largest: [1.27e-6, 0], block: "" };

test("bytes_of_a_flow_become_signed_numbers_by_frame", () => {
  const bytes = Uint8Array.from([0, 0, 127, 0, 0, 256 - 127, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0]);
  const [first, second] = decode_flow(bytes, 2, 4);
  assert.deepEqual([...first], [0, 0, 127, 0, 0, -127, 1, 2]);
  assert.ok(second.every((code) => code === 0));
  assert.throws(() => decode_flow(bytes, 3, 4), RangeError);
});

test("arrows_stand_in_the_middles_of_the_squares_that_have_a_flux", () => {
  const arrows = arrows_of(flow, Int8Array.from([0, 0, 127, 0, 0, -127, 1, 2]), 0);
  const near = (value: number, exact: number) => assert.ok(Math.abs(value - exact) < 1e-18, `${value} instead of ${exact}`);
  assert.deepEqual(arrows.list.map(({ x, y }) => [x, y]), [[1.5, -1.5], [0.5, -0.5], [1.5, -0.5]]);
  near(arrows.list[0].flux[0], 1.27e-6);
  near(arrows.list[1].flux[1], -1.27e-6);
  near(arrows.scale, 1e-6);
  assert.equal(arrows.spacing, 1);
  assert.equal(arrows_of(flow, new Int8Array(8), 1).list.length, 0);
});

test("around_an_axis_the_other_half_has_the_same_arrows", () => {
  const { list } = arrows_of({ ...flow, mirrored: true }, Int8Array.from([0, 0, 127, 3, 0, 0, 0, 0]), 0);
  assert.deepEqual(list.map(({ x, y }) => [x, y]), [[1.5, -1.5], [-1.5, -1.5]]);
  assert.equal(list[1].flux[0], -list[0].flux[0]);
  assert.equal(list[1].flux[1], list[0].flux[1]);
});

test("the_film_has_the_flux_as_a_field_and_its_arrows_go_with_the_box", () =>
  with_page("", async (page) => {
    const one = panel(page, 0);
    const names = report_data(file).runs[0].film!.fields.map((field) => field.name);
    assert.ok(names.includes("water_flux") && names.includes("excess_pore_pressure"), names.join());
    const count = async () => Number(await one.getAttribute("data-arrows"));
    await set_frame(one, report_data(file).runs[0].film!.frames.length - 1);
    await after_drawing(one, () => one.locator(".film-field").selectOption("excess_pore_pressure"));
    const both = await count(), with_arrows = await pixels(one, 300, 150);
    assert.ok(both > 40, `${both} arrows`);
    await take_screenshot(page, "film_flow");
    await after_drawing(one, () => page.locator(".film-both").uncheck());
    assert.equal(await count(), both / 2);
    await after_drawing(one, () => page.locator(".film-both").check());
    await after_drawing(one, () => page.locator(".film-arrows").uncheck());
    assert.equal(await count(), 0);
    const without = await pixels(one, 300, 150);
    assert.ok(difference(with_arrows, without) > 0.02);
  }, file),
);
