// SPDX-License-Identifier: BSD-3-Clause
// What the colours mean: field, unit, range.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { launch_browser } from "./browser";
import { after_drawing, difference, panel, pixels, quiet, with_film_page } from "./film_page";
import { run_of, runs } from "./film_runs";

let browser: Browser;
before(async () => (browser = await launch_browser()));
after(() => browser.close());

const with_page = with_film_page(() => browser);

test("another_field_changes_colours_and_unit", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const run = await run_of(page, 0);
    const now = await left.getAttribute("data-field");
    const unit = run.film!.fields.find((field) => field.name === now)!.unit;
    const other = run.film!.fields.find((field) => field.unit !== unit)!;
    const before_change = await pixels(left);
    const shown = await left.locator(".film-bar-title").textContent();
    await after_drawing(left, () => left.locator(".film-field").selectOption(other.name));
    assert.equal(await left.getAttribute("data-field"), other.name);
    assert.ok(difference(before_change, await pixels(left)) > 0.05);
    const title = await left.locator(".film-bar-title").textContent();
    assert.notEqual(title, shown);
    assert.ok(title!.startsWith(other.label));
    assert.match(title!, other.unit === "1" ? /\(–\)$/ : new RegExp(`\\([kMm]?${other.unit}\\)$`));
    if (runs.length > 1) {
      assert.equal(await panel(page, 1).locator(".film-field").inputValue(), other.name);
      await page.locator(".film-linked").uncheck();
      await quiet(page);
    }
    // Alone, the panel spans its own field: numbers times the unit's prefix are the data's ends.
    const own_title = (await left.locator(".film-bar-title").textContent())!;
    const prefix = own_title.slice(own_title.lastIndexOf("(") + 1, -1).slice(0, -other.unit.length);
    const factor = other.unit === "1" ? 1 : { "": 1, k: 1e3, M: 1e6, m: 1e-3 }[prefix]!;
    for (const [end, value] of [["from", other.low], ["to", other.high]] as const) {
      const written = Number(await left.locator(`.film-${end}`).inputValue()) * factor;
      assert.ok(Math.abs(written - value) <= 1e-3 * (other.high - other.low), `${end} ${written} instead of ${value}`);
    }
  }));

test("a_narrower_range_changes_colours_and_default_brings_them_back", () =>
  with_page("", async (page) => {
    const left = panel(page, 0);
    const usual = await pixels(left);
    const end = await left.locator(".film-to").inputValue();
    const quarter = String(Number((Number(end) / 4).toPrecision(3)));
    await after_drawing(left, () => left.locator(".film-to").fill(quarter).then(() => left.locator(".film-to").blur()));
    assert.ok(difference(usual, await pixels(left)) > 0.001);
    if (runs.length > 1) assert.equal(await panel(page, 1).locator(".film-to").inputValue(), quarter);
    await after_drawing(left, () => left.locator(".film-range-back").click());
    assert.equal(await left.locator(".film-to").inputValue(), end);
    assert.equal(difference(usual, await pixels(left)), 0);
  }));
