// SPDX-License-Identifier: BSD-3-Clause
#include "verification/requirements.hpp"

#include "text/html.hpp"
#include "text/plain_page.hpp"
#include "verification/book_html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

/// The worst of the verdicts of a promise's numbers: one that is missed breaks it.
Verdict verdict_of(const Promise& promise, const std::vector<ExpectationResult>& findings)
{
  constexpr Verdict order[] = {Verdict::met, Verdict::not_run, Verdict::missed, Verdict::failed};
  const auto place = [&](Verdict v) { return std::find(std::begin(order), std::end(order), v) - std::begin(order); };
  Verdict worst = Verdict::met;
  for (const std::size_t k : promise.numbers)
    if (place(findings[k].verdict) > place(worst)) worst = findings[k].verdict;
  return worst;
}

/// A run, or several for an order of convergence, with a link to them, what they gave and the verdict.
std::string proof_html(const ExamplePage& page, std::size_t k)
{
  const Expectation& e = page.example.expectations[k];
  const ExpectationResult& f = page.findings[k];
  const std::string address = address_of(page.example.name + ".html") + "#" + (e.runs.empty() ? e.run : convergence);
  const std::string found = f.berm.empty() ? "" : fmt::format(": {}, expected {}", f.berm, f.exact);
  return fmt::format("<div>{} <span class=\"quiet\">{}{}</span> {}</div>", link_to(address, f.problem), text::html_text(f.what),
                     text::html_text(found), f.verdict == Verdict::met ? "" : badge(f.verdict));
}

}  // namespace

std::vector<Promise> promises_of(const Example& example)
{
  std::vector<Promise> promises;
  for (std::size_t k = 0; k < example.expectations.size(); ++k) {
    const Expectation& e = example.expectations[k];
    auto same = std::find_if(promises.begin(), promises.end(),
                             [&](const Promise& p) { return p.requirement == e.requirement && p.derived == e.derived; });
    if (same == promises.end()) same = promises.insert(same, {e.requirement, e.derived, {}});
    same->numbers.push_back(k);
  }
  return promises;
}

std::string requirements_page(const std::vector<ExamplePage>& pages)
{
  std::string html = "<nav>" + link_to("index.html", "verification book") + "</nav>\n<h1>Requirements</h1>\n";
  html += "<p>Requirements that users may rely on, their derivation, and the runs of this book that verify them, with their results. "
          "<code>berm verify --requirements</code> lists the requirements of all examples.</p>\n<table>\n";
  html += text::plain_row({"requirement", "derived", "", "proved by"}, 9, 9, "th");
  for (const ExamplePage& page : pages) {
    html += fmt::format("<tr class=\"example\"><td colspan=\"4\">{}</td></tr>\n",
                        link_to(address_of(page.example.name + ".html"), title_of(page.example)));
    for (const Promise& promise : promises_of(page.example)) {
      std::string proofs;
      for (const std::size_t k : promise.numbers) proofs += proof_html(page, k);
      html += text::plain_row(
          {text::html_text(promise.requirement), text::html_text(promise.derived), badge(verdict_of(promise, page.findings)), proofs}, 9, 9,
          "td");
    }
  }
  return text::plain_page("berm: requirements", html + "</table>\n");
}

std::string requirements_text(const std::vector<ExamplePage>& pages)
{
  std::string text;
  for (const ExamplePage& page : pages)
    for (const Promise& promise : promises_of(page.example)) {
      text += fmt::format("{}: {}\n  derived: {}\n", page.example.name, promise.requirement, promise.derived);
      for (const std::size_t k : promise.numbers) {
        const ExpectationResult& f = page.findings[k];
        text += fmt::format("  {}: {} {}{}\n", word_of(f.verdict), f.problem, f.what,
                            f.berm.empty() ? "" : fmt::format(" = {}, expected {}", f.berm, f.exact));
      }
    }
  return text;
}

}  // namespace berm::verification
