// SPDX-License-Identifier: BSD-3-Clause
// node measure_desk.mjs BERM FOLDER     how long the desk's page takes until its first paint and until what it shows is there: start, list of runs, a case, ten times each
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { chromium } from "playwright-core";

const [program, folder] = process.argv.slice(2), times = 10;
if (!folder) throw new Error("measure_desk.mjs BERM FOLDER");
const desk = spawn(program, ["desk", folder, "--no-browser"], { stdio: ["ignore", "pipe", "inherit"] });
const address = await new Promise((found) => {
  let text = "";
  desk.stdout.on("data", (part) => {
    const line = /http:\/\/\S+\n/.exec((text += part));
    if (line) found(line[0].trim());
  });
});
const executablePath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find((path) => existsSync(path));
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
const range = (values) => `${Math.min(...values).toFixed(0)} to ${Math.max(...values).toFixed(0)} ms`;
try {
  const first = await browser.newPage();
  await first.goto(address);
  await first.locator(".folder_list :is(h3, p)").first().waitFor();
  const a_case = await first.locator('.folder_list a[href*="#/case"]').first().getAttribute("href").catch(() => null);
  for (const [name, hash, there] of [["start", "#/", ".folder_list :is(h3, p)"], ["runs", "#/runs", ".runs_view tbody tr"], ...(a_case ? [["case", a_case, ".form .field"]] : [])]) {
    const paints = [], shown = [];
    for (let k = 0; k < times; ++k) {
      const page = await browser.newPage();
      await page.goto(address); // each page has the token of its own
      await page.goto(`${address.split("#")[0]}${hash}`);
      await page.reload();
      await page.locator(there).first().waitFor();
      shown.push(await page.evaluate(() => performance.now()));
      paints.push(await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN));
      await page.close();
    }
    console.log(`${name}: first paint ${range(paints)}, shown after ${range(shown)}`);
  }
} finally {
  await browser.close();
  desk.kill("SIGINT");
}
