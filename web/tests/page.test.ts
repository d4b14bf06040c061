// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { changed_report, launch_browser, open_report, report_data, report_file, scratch_folder, take_screenshot } from "./browser";
import { unfolded_charts } from "./charts";

let browser: Browser;
before(async () => void (browser = await launch_browser()));
after(() => browser.close());

/** What the theme gives the page and its first chart. */
async function look(page: Page): Promise<string[]> {
  return page.evaluate(() => [
    getComputedStyle(document.body).backgroundColor,
    getComputedStyle(document.body).color,
    document.querySelector<HTMLCanvasElement>("#curves canvas")!.toDataURL(),
  ]);
}

function same(a: string[], b: string[]): boolean {
  return a.every((each, i) => each === b[i]);
}

for (const colour of ["light", "dark"] as const)
  for (const width of [1280, 400])
    test(`page_is_quiet_and_fits_${width}_px_${colour}`, async () => {
      const { page, context, errors, requests } = await open_report(browser, { viewport: { width, height: 900 }, colorScheme: colour });
      assert.ok((await page.locator("#curves .chart canvas").count()) > 0);
      const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
      assert.equal(beyond, 0, `the page is ${beyond} px wider than its window`);
      await take_screenshot(page, `page_${width}_${colour}`, true);
      await page.locator("#curves").scrollIntoViewIfNeeded();
      await take_screenshot(page, `curves_${width}_${colour}`);
      assert.deepEqual(errors, []);
      assert.deepEqual(requests, []);
      await context.close();
    });

test("a_wide_page_has_the_answer_beside_its_picture_and_its_right_third_used", async () => {
  const { page, context } = await open_report(browser, { viewport: { width: 1400, height: 900 } });
  const words = (await page.locator("#first-look > div").first().boundingBox())!, picture = (await page.locator("#first-look img").boundingBox())!;
  assert.ok(picture.x >= words.x + words.width && picture.y < words.y + words.height, "side by side");
  const reached = await page.evaluate(() => ["answer", "soil", "curves", "model", "trust", "record"].map((id) => {
    const section = document.getElementById(id)!;
    const seen = [...section.querySelectorAll("table, p, li, img, canvas, svg")].map((each) => each.getBoundingClientRect()).filter((box) => box.width > 0);
    return { id: section.id, right: Math.max(...seen.map((box) => box.right)), wide: section.getBoundingClientRect().right };
  }));
  for (const { id, right, wide } of reached) assert.ok(right > 0.75 * wide, `${id} ends at ${right} of ${wide} px`);
  await context.close();
});

test("curves_and_soil_of_the_first_run_are_seen_without_scrolling", async () => {
  const { page, context } = await open_report(browser, { viewport: { width: 1400, height: 900 } });
  const run = report_data().runs[0];
  const charts = page.locator("#first-look .chart");
  const paths = [run.drag, run.push].filter((path) => run.diameter !== null && path.rows.length > 1).length;
  assert.equal(await charts.count(), paths);
  for (const each of [...(await charts.locator(".chart_plot").all()), page.locator("#first-look img")]) {
    const box = (await each.boundingBox())!;
    assert.ok(box.width > 200 && box.height > 100 && box.y + box.height <= 900, `${box.y} + ${box.height} px`);
  }
  await context.close();
});

test("theme_button_changes_colours", async () => {
  const { page, context, errors } = await open_report(browser);
  const light = await look(page);
  const button = page.locator("button.theme");
  await button.click();
  assert.equal(await button.textContent(), "theme: light");
  assert.ok(same(await look(page), light));
  await button.click();
  assert.equal(await button.textContent(), "theme: dark");
  const dark = await look(page);
  for (let i = 0; i < light.length; ++i) assert.ok(dark[i] !== light[i], "ground, text and chart change");
  await page.reload();
  assert.equal(await button.textContent(), "theme: dark", "the choice is kept");
  await button.click();
  assert.equal(await button.textContent(), "theme: auto");
  assert.ok(same(await look(page), light));
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForFunction((was) => document.querySelector<HTMLCanvasElement>("#curves canvas")!.toDataURL() !== was, light[2]);
  assert.ok(same(await look(page), dark), "auto follows the system");
  assert.deepEqual(errors, []);
  await context.close();
});

test("theme_button_is_in_sight_on_a_phone", async () => {
  const { page, context } = await open_report(browser, { viewport: { width: 400, height: 800 } });
  const button = page.locator("button.theme");
  const box = (await button.boundingBox())!;
  assert.ok(box.x >= 0 && box.x + box.width <= 400, `from ${box.x} to ${box.x + box.width}`);
  assert.ok(await button.evaluate((each) => {
    const { left, top, width, height } = each.getBoundingClientRect();
    return document.elementFromPoint(left + width / 2, top + height / 2) === each;
  }), "nothing lies over it");
  await context.close();
});

test("claims_need_no_sideways_scrolling_on_a_phone", async () => {
  const { page, context } = await open_report(browser, { viewport: { width: 400, height: 800 } });
  const widths = await page.evaluate(() => {
    const badge = `<span class="badge bad">not reproduced</span>`, words = "A push to w = 0.1 D takes V = 4 kN, in agreement with the test. ";
    const table = `<table id="claims-table"><thead><tr><th>claim</th><th>verdict</th><th>what berm finds</th><th>why</th></tr></thead><tbody>
      <tr><th scope="row">${words}</th><td>${badge}</td><td>${words.repeat(3)}${badge}</td><td>${words.repeat(3)}</td></tr></tbody></table>`;
    document.getElementById("claims")?.remove();
    document.querySelector("main")!.insertAdjacentHTML("beforeend", `<section id="claims"><div class="wide">${table}</div></section>`);
    const wide = document.querySelector<HTMLElement>("#claims .wide")!;
    return { all: wide.scrollWidth, seen: wide.clientWidth, cells: [...wide.querySelectorAll<HTMLElement>("tbody td:last-child")].map((each) => each.clientWidth) };
  });
  assert.equal(widths.all, widths.seen);
  for (const cell of widths.cells) assert.ok(cell > 0.9 * widths.seen, "words have the width of the page");
  await context.close();
});

test("without_script_colours_follow_the_system", async () => {
  for (const [colorScheme, ground, letter] of [["dark", "rgb(20, 24, 29)", "rgb(228, 232, 236)"], ["light", "rgb(255, 255, 255)", "rgb(29, 35, 42)"]] as const) {
    const { page, context } = await open_report(browser, { colorScheme, javaScriptEnabled: false });
    const seen = await page.evaluate(() => [getComputedStyle(document.body).backgroundColor, getComputedStyle(document.body).color]);
    assert.deepEqual(seen, [ground, letter]);
    await context.close();
  }
});

test("theme_works_without_storage", async () => {
  const { page, context, errors } = await open_report(browser, {
    script: () => Object.defineProperty(window, "localStorage", { get: () => { throw new Error("no storage"); } }),
  });
  const light = await look(page);
  for (const choice of ["light", "dark"]) {
    await page.locator("button.theme").click();
    assert.equal(await page.locator("button.theme").textContent(), `theme: ${choice}`);
  }
  assert.ok(!same(await look(page), light));
  assert.deepEqual(errors, []);
  await context.close();
});

test("text_of_the_user_is_never_markup", async () => {
  const markup = `<img src=x onerror="window.broken_in=1">`;
  const file = changed_report((data) => {
    for (const run of data.runs) {
      run.name = `${markup} ${run.name}`;
      run.title = markup + run.title;
      run.stage = run.stage.map((stage) => markup + stage);
      run.columns[markup] = run.columns.time_s;
    }
    for (const point of data.published) point.label = markup + point.label;
    data.published.push({ chart: "H_u", x: null, y: 1, label: markup });
  });
  const { page: plain, context: plain_context } = await open_report(browser);
  const images = await plain.locator("img").count();
  await plain_context.close();
  const { page, context, errors, requests } = await open_report(browser, { file });
  await unfolded_charts(page);
  await page.locator(".chart .chart_argument").selectOption(markup);
  for (const plot of await page.locator(".chart_plot").all()) {
    await plot.focus();
    await page.keyboard.press("End");
  }
  assert.equal(await page.locator("img").count(), images);
  assert.equal(await page.evaluate(() => "broken_in" in window), false);
  assert.ok((await page.locator(".chart_runs").textContent())!.includes(markup), "the text is shown as it is");
  assert.deepEqual(errors, []);
  assert.deepEqual(requests, []);
  await context.close();
});

/** What the table that the page's first copy button copies holds, with tabs and line ends. */
async function first_table(page: Page): Promise<string> {
  return page.evaluate(() => {
    const id = document.querySelector<HTMLElement>("button.copy[data-copy]")!.dataset.copy!;
    const rows = [...document.getElementById(id)!.querySelectorAll("tr")];
    return rows.map((row) => [...row.querySelectorAll("th, td")].map((cell) => cell.textContent!.trim().replace(/\s+/g, " ")).join("\t") + "\n").join("");
  });
}

/** Clicks the first copy button, which may lie in a closed <details>. */
async function copy(page: Page): Promise<void> {
  await page.evaluate(() => document.querySelectorAll("details").forEach((each) => (each.open = true)));
  await page.locator("button.copy[data-copy]").first().click();
  await page.locator("button.copy", { hasText: "copied" }).waitFor();
}

test("copy_button_copies_the_table", async () => {
  const { page, context, errors } = await open_report(browser, {
    script: () => Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text: string) => void (document.documentElement.dataset.copied = text) } }),
  });
  const words = await page.locator("button.copy").first().textContent();
  await copy(page);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.copied), await first_table(page));
  await page.waitForFunction((was) => document.querySelector("button.copy")!.textContent === was, words);
  assert.deepEqual(errors, []);
  await context.close();
});

test("copied_numbers_of_an_invalid_answer_keep_their_mark", async () => {
  const { page, context, errors } = await open_report(browser, {
    script: () => Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text: string) => void (document.documentElement.dataset.copied = text) } }),
  });
  const numbers = await page.evaluate(() => {
    const table = document.getElementById(document.querySelector<HTMLElement>("button.copy[data-copy]")!.dataset.copy!)!;
    table.classList.add("invalid");
    return table.querySelectorAll("td.number").length;
  });
  await copy(page);
  const text = await page.evaluate(() => document.documentElement.dataset.copied!);
  assert.ok(numbers > 0 && text.split(" (!)").length === numbers + 1, text);
  assert.deepEqual(errors, []);
  await context.close();
});

test("copy_button_works_where_the_clipboard_is_not_allowed", async () => {
  const { page, context, errors } = await open_report(browser, {
    script: () => {
      Object.defineProperty(navigator, "clipboard", { value: undefined });
      document.addEventListener("copy", (event) => {
        document.documentElement.dataset.copied = (event.target as HTMLTextAreaElement).value;
      });
    },
  });
  await copy(page);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.copied), await first_table(page));
  assert.equal(await page.locator("textarea").count(), 0);
  assert.deepEqual(errors, []);
  await context.close();
});

/** How many pixels of the first chart have exactly a colour (#rrggbb). */
async function pixels_of(page: Page, colour: string): Promise<number> {
  return page.locator("#curves canvas").first().evaluate((canvas: HTMLCanvasElement, wanted) => {
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let found = 0;
    for (let i = 0; i < data.length; i += 4)
      if (data[i + 3] === 255 && wanted === "#" + [...data.slice(i, i + 3)].map((each) => each.toString(16).padStart(2, "0")).join("")) ++found;
    return found;
  }, colour);
}

/** The colour of the page's letters. */
async function letters(page: Page): Promise<string> {
  return page.evaluate(() => getComputedStyle(document.documentElement).getPropertyValue("--text").trim());
}

test("print_is_light_with_all_details_open", async () => {
  const { page, context, errors } = await open_report(browser, { colorScheme: "dark" });
  const closed = () => page.locator("details:not([open])").count();
  const before_print = await closed();
  const dark_letters = await letters(page);
  assert.ok((await pixels_of(page, dark_letters)) > 0);
  await page.evaluate(() => {
    document.addEventListener("theme", () => (document.body.dataset.drawn = "anew"));
    dispatchEvent(new Event("beforeprint"));
  });
  assert.equal(await closed(), await page.locator("details.for_screen").count(), "all but what is for the screen");
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(255, 255, 255)");
  await page.waitForFunction(() => document.body.dataset.drawn === "anew");
  for (const hidden of ["nav", "button.copy", "button.theme", ".chart_buttons button", ".chart_options"])
    if ((await page.locator(hidden).count()) > 0) assert.equal(await page.locator(hidden).first().isVisible(), false, hidden);
  assert.equal(await page.locator("#curves canvas").first().isVisible(), false, "on paper charts are lines and letters");
  assert.equal(await page.locator("#curves .chart_print svg path").first().isVisible(), true);
  const look = await page.evaluate(() => [getComputedStyle(document.body).fontSize, getComputedStyle(document.querySelector("main")!).paddingLeft]);
  assert.deepEqual(look, ["12px", "0px"], "letters of 9 pt over all of the paper");
  await page.setViewportSize({ width: 688, height: 990 });  // A4 less its margins
  const beyond = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(beyond, 0, `the print is ${beyond} px wider than the paper`);
  const broken = await page.evaluate(() =>
    [...document.querySelectorAll("td.number")].filter((cell) => {
      const text = document.createRange();
      text.selectNodeContents(cell);
      return !cell.textContent!.trim().includes(" ") && new Set([...text.getClientRects()].filter((box) => box.width > 0).map((box) => Math.round(box.top))).size > 1;
    }).map((cell) => cell.textContent));
  assert.deepEqual(broken, [], "no number goes on in another line");
  const cut = await page.evaluate(() => [...document.querySelectorAll(".wide")].filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.getAttribute("aria-label")));
  assert.deepEqual(cut, [], "no table is wider than the paper");
  await take_screenshot(page, "print", true);
  await page.emulateMedia({ media: "screen", colorScheme: "dark" });
  await page.evaluate(() => void dispatchEvent(new Event("afterprint")));
  assert.equal(await closed(), before_print);
  assert.ok((await page.pdf({ format: "A4" })).length > 1000);
  assert.deepEqual(errors, []);
  await context.close();
});

test("the_program_prints_the_page_with_its_soil", () => {
  const pdf = readFileSync(report_file().replace(/\.html$/, ".pdf")).toString("latin1");
  assert.ok(pdf.startsWith("%PDF"));
  const pages = pdf.match(/\/Type \/Page\b/g)!.length;
  assert.ok(pages > 3 && pages < 60, `${pages} pages`);
  for (const box of pdf.match(/\/MediaBox \[[^\]]*\]/g)!) {
    const [, , width, height] = box.match(/[\d.]+/g)!.map(Number);
    assert.ok(Math.abs(width - 595) < 2 && Math.abs(height - 842) < 2, `${box} is not A4`);
  }
  // The panels of the film are pictures of twice their size on the page.
  const widths = [...pdf.matchAll(/\/Subtype \/Image\b[^>]*?\/Width (\d+)|\/Width (\d+)[^>]*?\/Subtype \/Image\b/g)].map((found) => Number(found[1] ?? found[2]));
  const films = report_data().runs.filter((run) => run.film !== null).length;
  assert.ok(widths.filter((width) => width > 600).length >= Math.min(2, films), `pictures of ${widths} pixels`);
});

test("the_document_stands_below_the_title_and_in_the_record", async () => {
  const { page, context, errors } = await open_report(browser);
  const made = report_data().runs[0].name === "pipe";
  if (made) {
    const lines = (await page.locator("#document").textContent())!;
    for (const words of ['Flowline <2>, "north"', "B", "C. Checker"]) assert.ok(lines.includes(words), lines);
    assert.equal(await page.evaluate(() => [...document.styleSheets[0].cssRules].some((rule) => rule.cssText.includes("@bottom-left"))), true, "the foot of a printed page");
  }
  const digests = await page.locator("#record code.hash").allTextContents();
  assert.ok(digests.length >= 4 && digests.every((digest) => /^[0-9a-f]{64}$/.test(digest)), `${digests}`);
  assert.deepEqual(errors, []);
  await context.close();
});

test("on_a_phone_all_sections_are_in_sight_and_wide_tables_say_so", async () => {
  const { page, context } = await open_report(browser, { viewport: { width: 400, height: 800 } });
  for (const link of await page.locator("nav a").all()) {
    const box = (await link.boundingBox())!;
    assert.ok(box.x >= 0 && box.x + box.width <= 400, `${await link.textContent()} from ${box.x} to ${box.x + box.width}`);
    const seen = await link.evaluate((each) => {
      const { left, top, width, height } = each.getBoundingClientRect();
      return document.elementFromPoint(left + width / 2, top + height / 2) === each;
    });
    assert.ok(seen, `something lies over ${await link.textContent()}`);
  }
  await page.evaluate(() => document.querySelectorAll("details").forEach((each) => (each.open = true)));
  await page.waitForFunction(() => document.querySelectorAll(".wide.scrolls").length > 0);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const tables = await page.evaluate(() =>
    [...document.querySelectorAll<HTMLElement>(".wide")].filter((box) => box.offsetParent !== null).map((box) => ({
      name: box.getAttribute("aria-label"), wider: box.scrollWidth > box.clientWidth + 1, says: box.classList.contains("scrolls"),
      caption: Math.round(box.querySelector("caption > span")?.getBoundingClientRect().right ?? 0),
    })));
  for (const table of tables) {
    assert.equal(table.says, table.wider, table.name ?? "");
    assert.ok(table.caption <= 400, `the caption of ${table.name} ends at ${table.caption} px`);
  }
  await context.close();
});

test("every_control_has_a_name_and_every_canvas_says_what_is_seen", async () => {
  const { page, context } = await open_report(browser);
  const nameless = await page.evaluate(() => {
    const named = (each: Element) =>
      each.getAttribute("aria-label") || (each.matches("button, a") && each.textContent!.trim()) || [...((each as HTMLInputElement).labels ?? [])].some((label) => label.textContent!.trim());
    return [...document.querySelectorAll("button, select, input, a[href]")].filter((each) => !named(each)).map((each) => each.outerHTML);
  });
  assert.deepEqual(nameless, []);
  for (const canvas of await (await unfolded_charts(page)).locator("canvas").all()) {
    assert.equal(await canvas.getAttribute("role"), "img");
    assert.match((await canvas.getAttribute("aria-label"))!, /Across: .*up: .*Lines: /);
  }
  await context.close();
});

test("browser_refuses_scripts_that_are_not_the_page's", async () => {
  const foreign = '<script>window.ran = "inline";</script><img src="data:," onerror="window.ran = \'attribute\'">';
  const file = join(scratch_folder(), "foreign.html");
  writeFileSync(file, readFileSync(report_file(), "utf8").replace("<main>", `<main>${foreign}`));
  const { page, context, requests } = await open_report(browser, { file });
  assert.ok((await page.locator("#curves .chart canvas").count()) > 0, "the page's own script runs");
  assert.equal(await page.evaluate(() => (window as unknown as { ran?: string }).ran), undefined);
  assert.deepEqual(requests, []);
  await context.close();
});

test("page_holds_the_licences_of_its_code", async () => {
  const { page, context } = await open_report(browser);
  const words = await page.locator("#licences pre").textContent();
  for (const name of ["uplot", "gifenc", "three", "d3-scale-chromatic", "Permission is hereby granted"]) assert.ok(words!.includes(name), name);
  await context.close();
});
