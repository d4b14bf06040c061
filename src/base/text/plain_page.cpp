// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "text/plain_page.hpp"

#include "text/html.hpp"

#include <fmt/format.h>

namespace berm::text {
namespace {

constexpr const char* style = R"(
:root { --line: #d9dee4; --quiet: #5b6570; --link: #1764ab; }
body { font: 15px/1.5 system-ui, 'DejaVu Sans', sans-serif; color: #1d232a; margin: 0; }
main { max-width: 1180px; margin: 0 auto; padding: 24px 28px 64px; }
h1 { font-size: 1.7em; margin: .4em 0 .5em; } h2 { font-size: 1.3em; margin: 2em 0 .5em; } h3 { font-size: 1.08em; margin: 1.8em 0 .4em; }
a { color: var(--link); text-decoration: none; } a:hover { text-decoration: underline; }
nav { color: var(--quiet); font-size: .9em; }
p.quiet, .quiet { color: var(--quiet); }
table { border-collapse: collapse; margin: .8em 0 1.2em; font-size: .92em; }
th, td { text-align: left; padding: 5px 14px 5px 0; border-bottom: 1px solid var(--line); vertical-align: top; }
th { color: var(--quiet); font-weight: 600; } td.number, th.number { text-align: right; white-space: nowrap; }
tr.example td { padding-top: 1.3em; font-weight: 600; font-size: 1.05em; }
code, pre { font: .9em/1.45 'DejaVu Sans Mono', monospace; } pre { background: #f5f7f9; padding: 12px 14px; overflow-x: auto; }
pre, .tex { border-radius: 4px; } .tex { background: #f5f7f9; padding: 1px 5px; }
math[display=block] { margin: 1em 0; font-size: 1.1em; }
/* A root as high as what is below it, in any font. */
math .root { padding: .18em .1em 0 .68em; margin: 0 .12em;
  background: linear-gradient(#1d232a, #1d232a) .66em 0 / 100% .07em no-repeat, url("data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 10 20' preserveAspectRatio='none'%3E%3Cpath d='M.3 12 2.4 10.6 5.2 19.2 9.8 .5' fill='none' stroke='%231d232a' stroke-width='1.1' vector-effect='non-scaling-stroke'/%3E%3C/svg%3E") left top / .68em 100% no-repeat; }
img { max-width: 100%; height: auto; display: block; margin: .6em 0; }
.pictures { display: flex; flex-wrap: wrap; align-items: flex-start; gap: 12px; } .pictures img { width: 49%; min-width: 320px; border: 1px solid var(--line); }
.tables { display: flex; flex-wrap: wrap; align-items: flex-start; gap: 0 48px; }
.verdict { padding: 1px 9px; border-radius: 9px; font-size: .9em; white-space: nowrap; color: #fff; }
.met { background: #23813f; } .missed, .failed { background: #bf3425; } .not_run { background: #77818c; }
)";

}  // namespace

std::string plain_page(const std::string& title, const std::string& content)
{
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{}<meta name=\"viewport\" "
      "content=\"width=device-width\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<main>\n{}</main>\n</body>\n</html>\n",
      content_policy(), html_text(title), style, content);
}

std::string plain_row(const std::vector<std::string>& cells, std::size_t first_number, std::size_t last_number, const char* tag)
{
  std::string html = "<tr>";
  for (std::size_t k = 0; k < cells.size(); ++k)
    html += fmt::format("<{0}{1}>{2}</{0}>", tag, k >= first_number && k <= last_number ? " class=\"number\"" : "", cells[k]);
  return html + "</tr>\n";
}

}  // namespace berm::text
