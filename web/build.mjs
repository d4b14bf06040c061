// SPDX-License-Identifier: BSD-3-Clause
// node build.mjs page OUT.cpp     the page's script and style, minified, and the licences of what is in them, as C++ constants that the program holds; the licences also as
//                                 licences.txt beside it
// node build.mjs tests FOLDER     the tests of the page, for node
import { build } from "esbuild";
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

async function page(out) {
  const held = new Set();
  const script = await bundle("main.ts", { format: "iife" }, held);
  const style = await bundle("page.css", {}, held);
  const licences = [...held].sort().map(licence_of).join("\n" + "-".repeat(80) + "\n\n");
  writeFileSync(join(dirname(out), "licences.txt"), licences);
  writeFileSync(
    out,
    `// SPDX-License-Identifier: BSD-3-Clause\n// Made by web/build.mjs.\n#include "report/page/page_files.hpp"\n\nnamespace berm::report {\n\n` +
      constant("page_script", script) + "\n" + constant("page_style", style) + "\n" + constant("page_licences", licences) + "\n}  // namespace berm::report\n",
  );
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
if (what === "page" && out) await page(out);
else if (what === "tests" && out) await tests(out);
else throw new Error("build.mjs page OUT.cpp | build.mjs tests FOLDER");
