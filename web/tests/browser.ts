// SPDX-License-Identifier: BSD-3-Clause
// What every test of the page begins with: a browser, the report in it as a reader opens it, and the run folders that it is made from.
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium, firefox } from "playwright-core";
import type { Browser, BrowserContext, BrowserContextOptions, Page } from "playwright-core";
import type { PageData } from "../src/data";
import { in_few_colours } from "./palette_png";

const browsers = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"];

/** A path that the tests are given. */
export function from_environment(name: string): string {
  const value = process.env[name];
  if (!value) throw new Error(`${name} is not set`);
  return resolve(value);
}

/** The browser that the tests use, or the Firefox of the distribution where BERM_BROWSER says so; WebGL is drawn by software. Downloads go to a folder, if it is named. */
export async function launch_browser(downloadsPath?: string): Promise<Browser> {
  if (process.env.BERM_BROWSER === "firefox") {
    const found = ["/usr/bin/firefox-esr", "/usr/bin/firefox"].find((path) => existsSync(path));
    if (!found) throw new Error("Firefox is not installed"); // ctest takes these words for a test that is skipped
    return firefox.launch({ channel: "moz-firefox", executablePath: found, downloadsPath });
  }
  const found = process.env.CHROMIUM ?? browsers.find((path) => existsSync(path));
  if (!found) throw new Error(`no browser: set CHROMIUM, or install one of ${browsers.join(", ")}`);
  return chromium.launch({ executablePath: found, args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"], downloadsPath });
}

// Software draws a long page in seconds, and in a minute where the machine does other work; a test that hangs is ended by its own limit.
const patience = 300_000;

/** A report open in a page of its own, and what must not have happened in it. */
export interface OpenReport {
  page: Page;
  context: BrowserContext;
  /** Messages of errors, of the console and uncaught. */
  errors: string[];
  /** Addresses asked for other than the file itself. */
  requests: string[];
}

/** Opens BERM_REPORT, or `file`, from its file:// address, with `script` run before its own; resolves when its script has run. */
export async function open_report(
  browser: Browser,
  { file = report_file(), script, ...options }: BrowserContextOptions & { file?: string; script?: () => void } = {},
): Promise<OpenReport> {
  const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, colorScheme: "light", acceptDownloads: true, ...options });
  context.setDefaultTimeout(patience);
  if (script) await context.addInitScript(script);
  const page = await context.newPage();
  const errors: string[] = [];
  const requests: string[] = [];
  const address = pathToFileURL(file).href;
  page.on("console", (message) => {
    if (message.type() === "error") errors.push(message.text());
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  context.on("request", (request) => {
    const asked = request.url().split("#")[0];
    if (asked !== address && !/^(blob|data):/.test(asked)) requests.push(asked);
  });
  await page.goto(address, { waitUntil: "load" });
  return { page, context, errors, requests };
}

/** The report under test. */
export function report_file(): string {
  return from_environment("BERM_REPORT");
}

/** The data that stands in a report's file. */
export function report_data(file = report_file()): PageData {
  return JSON.parse(data_element(readFileSync(file, "utf8")).json) as PageData;
}

/** A copy of the report whose data is changed, in a folder for this test run. */
export function changed_report(change: (data: PageData) => void): string {
  const text = readFileSync(report_file(), "utf8");
  const { json, at } = data_element(text);
  const data = JSON.parse(json) as PageData;
  change(data);
  const file = join(scratch_folder(), `changed_${copies++}.html`);
  writeFileSync(file, text.slice(0, at) + JSON.stringify(data).replaceAll("<", "\\u003c") + text.slice(at + json.length));
  return file;
}

let copies = 0;
let scratch: string | null = null;

/** A folder that is gone when the tests end. */
export function scratch_folder(): string {
  if (scratch === null) {
    const made = mkdtempSync(join(tmpdir(), "berm-page-"));
    process.on("exit", () => rmSync(made, { recursive: true, force: true }));
    scratch = made;
  }
  return scratch;
}

function data_element(text: string): { json: string; at: number } {
  const opened = /<script[^>]*\bid="?berm-data"?[^>]*>/.exec(text);
  if (!opened) throw new Error("the report has no #berm-data");
  const at = opened.index + opened[0].length;
  return { json: text.slice(at, text.indexOf("</script", at)), at };
}

/** history.csv of a run: its columns as text, by name. */
export function read_history(run: string): Map<string, string[]> {
  const lines = readFileSync(join(from_environment("BERM_RUNS"), run, "history.csv"), "utf8").trim().split(/\r?\n/);
  const names = lines[0].split(",");
  const rows = lines.slice(1).map((line) => line.split(","));
  return new Map(names.map((name, column) => [name, rows.map((row) => row[column])]));
}

/** Names of the run folders. */
export function run_names(): string[] {
  return readdirSync(from_environment("BERM_RUNS"));
}

/** Writes a picture of what is seen (or of all the page) into BERM_SCREENSHOTS, if that is set. */
export async function take_screenshot(page: Page, name: string, whole_page = false): Promise<void> {
  const folder = process.env.BERM_SCREENSHOTS;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, `${name}.png`), await in_few_colours(page, await page.screenshot({ fullPage: whole_page })));
}
