// SPDX-License-Identifier: BSD-3-Clause
// node build.mjs pages FOLDER     script and style, minified, of the page of a report (page_files.cpp, with the licences of what is in them) and of the desk (desk_files.cpp, each
//                                 begins with them), as C++ constants that the program holds; licences.txt has the licences of both
// node build.mjs tests FOLDER     the tests of the page, for node
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));

// String literals of C++ may be this long; they are joined when the program starts to need them.
const LONGEST = 16000;

function constant(name, text) {
  const parts = [];
  for (let at = 0; at < text.length; at += LONGEST) parts.push(`R"~page~(${text.slice(at, at + LONGEST)})~page~"`);
  return `const std::string_view ${name} =\n${parts.join("\n")};\n`;
}

// The packages whose code a bundle holds.
function packages_in(metafile) {
  const found = new Set();
  for (const output of Object.values(metafile.outputs))
    for (const [file, { bytesInOutput }] of Object.entries(output.inputs)) {
      const match = /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file);
      if (match && bytesInOutput > 0) found.add(match[1]);
    }
  return found;
}

function licence_of(name) {
  const folder = join(here, "node_modules", name);
  const { version, license } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const file = readdirSync(folder).find((file) => /^licen[cs]e(\.|$)/i.test(file));
  if (!file) throw new Error(`the package ${name} has no licence text`);
  return `${name} ${version} (${license})\n\n${readFileSync(join(folder, file), "utf8").trim()}\n`;
}

async function bundle(entry, options, held) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
    bundle: true,
    minify: true,
    write: false,
    charset: "ascii",
    legalComments: "inline",
    target: "es2022",
    metafile: true,
    absWorkingDir: here,
    ...options,
  });
  for (const name of packages_in(result.metafile)) held.add(name);
  // A page ends its script at the first "</script", wherever that stands.
  return result.outputFiles[0].text.replaceAll("</script", "<\\/script").replaceAll("</style", "<\\/style");
}

function licences_of(held) {
  return [...held].sort().map(licence_of).join("\n" + "-".repeat(80) + "\n\n");
}

// A file that is served by itself says what it holds of others.
function with_licences(text, held) {
  return `/*\nThis file holds code of others, under these licences:\n\n${licences_of(held).replaceAll("*/", "* /")}*/\n${text}`;
}

// The script as a Content-Security-Policy names it.
function source_of(script) {
  return `'sha256-${createHash("sha256").update(script).digest("base64")}'`;
}

function write_constants(file, header, room, constants) {
  writeFileSync(
    file,
    `// SPDX-License-Identifier: BSD-3-Clause\n// Made by web/build.mjs.\n#include "${header}"\n\nnamespace berm::${room} {\n\n` +
      Object.entries(constants).map(([name, text]) => constant(name, text)).join("\n") + `\n}  // namespace berm::${room}\n`,
  );
}

async function pages(folder) {
  const of_report = new Set(), of_script = new Set(), of_style = new Set();
  const page_script = await bundle("main.ts", { format: "iife" }, of_report);
  const page_style = await bundle("page.css", {}, of_report);
  const desk_script = await bundle("desk/main.ts", { format: "iife" }, of_script);
  const desk_style = await bundle("desk/desk.css", {}, of_style);
  write_constants(join(folder, "page_files.cpp"), "report/page/page_files.hpp", "report", { page_script, page_script_source: source_of(page_script), page_style, page_licences: licences_of(of_report) });
  write_constants(join(folder, "desk_files.cpp"), "desk/desk_files.hpp", "desk", {
    desk_script: with_licences(desk_script, of_script),
    desk_style: with_licences(desk_style, of_style),
    report_script_source: source_of(page_script),
  });
  writeFileSync(join(folder, "licences.txt"), licences_of(new Set([...of_report, ...of_script, ...of_style])));
}

async function tests(folder) {
  const names = readdirSync(join(here, "tests")).filter((name) => name.endsWith(".test.ts"));
  await build({
    entryPoints: names.map((name) => join(here, "tests", name)),
    bundle: true,
    platform: "node",
    format: "esm",
    outdir: folder,
    outExtension: { ".js": ".mjs" },
    packages: "external",
    sourcemap: "inline",
  });
}

const [what, out] = process.argv.slice(2);
if (what === "pages" && out) await pages(out);
else if (what === "tests" && out) await tests(out);
else throw new Error("build.mjs pages FOLDER | build.mjs tests FOLDER");
