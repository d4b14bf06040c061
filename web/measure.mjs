// SPDX-License-Identifier: BSD-3-Clause
// node measure.mjs REPORT.html     how long the page's first paint takes, and how many pictures a second the soil's animation gives, for both painters
import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [report] = process.argv.slice(2);
if (!report) throw new Error("measure.mjs REPORT.html");
const executablePath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((path) => existsSync(path));
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--enable-unsafe-swiftshader"] });

for (const query of ["", "?painter=webgl", "?painter=2d"]) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(pathToFileURL(resolve(report)).href + query);
  await page.waitForFunction(() => performance.getEntriesByName("first-contentful-paint").length > 0);
  const paint = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime);

  await page.locator("#soil").scrollIntoViewIfNeeded();
  await page.waitForFunction(() => [...document.querySelectorAll(".film-panel")].every((panel) => panel.dataset.state === "ready" && panel.dataset.framesDrawn));
  const loaded = await page.evaluate(() => performance.now());
  const film = await page.evaluate(async () => {
    const panel = document.querySelector(".film-panel");
    const drawn = () => Number(panel.dataset.framesDrawn);
    panel.querySelector(".film-stage").scrollIntoView({ block: "center" });
    const slider = panel.querySelector(".film-frame");
    slider.value = 0;
    slider.dispatchEvent(new Event("input"));
    const run = JSON.parse(document.getElementById("berm-data").textContent).runs.find((one) => one.name === panel.dataset.run);
    await new Promise((done) => setTimeout(done, 500));
    panel.querySelector(".film-play").click();
    const from = performance.now();
    const before = drawn();
    while (performance.now() - from < 4000 && Number(panel.dataset.frame) < run.film.frames.length - 1) await new Promise(requestAnimationFrame);
    const seconds = (performance.now() - from) / 1000;
    return { name: run.name, count: run.film.count, painter: panel.dataset.painter, rate: (drawn() - before) / seconds };
  });
  console.log(`${film.painter}: first paint ${paint.toFixed(0)} ms, film shown after ${loaded.toFixed(0)} ms, ` +
    `${film.rate.toFixed(1)} pictures a second (${film.name}, ${film.count} points, with the other panel linked)`);
  await page.close();
}
await browser.close();
