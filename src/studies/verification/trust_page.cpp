// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/trust_page_test.cpp
#include "verification/trust_page.hpp"

#include "os/error.hpp"
#include "structures/structures.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"
#include "text/quantity_words.hpp"
#include "verification/book_html.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::verification {
namespace {

using text::Standing;

constexpr std::array standing_words{"good", "doubtful", "bad", "not known"};
constexpr std::array standing_classes{"met", "not_run", "missed", "not_run"};

/// Whether an expectation says what a number of one run is, and not only between which bounds berm gives it.
bool is_known(const Expectation& e)
{
  return e.runs.empty() && e.over.empty() && !e.over_number && e.held == expectations::Held::not_asked && e.exact && *e.exact != 0 &&
         e.tolerance;
}

/// Whether it is an answer of the run: a column, or a quantity that is neither given by the case nor says how good others are.
bool is_answer(const Expectation& e, const record::RunRecord& run)
{
  if (!e.observable.column.empty()) return true;
  const run_folder::Quantity* quantity = run.quantity(e.observable.quantity);
  return quantity != nullptr && (quantity->kind == run_folder::QuantityKind::answer || quantity->kind == run_folder::QuantityKind::ratio);
}

/// The finding of a run that is farthest off; none where none is known.
Index farthest_off(const ExamplePage& page, const std::string& name, const record::RunRecord& run)
{
  Index farthest = none;
  Real largest = -1;
  for (std::size_t k = 0; k < page.findings.size(); ++k) {
    const Expectation& e = page.example.expectations[k];
    if (e.run != name || !is_known(e) || !is_answer(e, run)) continue;
    const Real error = std::abs(error_of(e, page.findings[k].number));
    if (error > largest) largest = error, farthest = static_cast<Index>(k);
  }
  return farthest;
}

std::string truth_words(const TrustQuestion& question)
{
  return question.is_right() ? "right" : question.is_wrong() ? "wrong" : "between";
}

std::string row_of(const TrustQuestion& question)
{
  const auto standing = static_cast<std::size_t>(question.judgement.standing);
  std::string warnings;
  for (const std::string& warning : question.judgement.warnings) warnings += fmt::format("<div>{}</div>", text::html_text(warning));
  return text::plain_row({link_to(address_of(question.example + ".html") + "#" + question.run, question.problem),
                          text::html_text(question.what), text::html_text(question.exact), text::percent_words(question.error),
                          truth_words(question),
                          fmt::format("<span class=\"verdict {}\">{}</span>", standing_classes[standing], standing_words[standing]),
                          fmt::format("<span class=\"quiet\">{}</span>", warnings)},
                         2, 3, "td");
}

}  // namespace

bool TrustQuestion::is_misjudged() const
{
  return (is_right() && judgement.standing == Standing::bad) || (is_wrong() && judgement.standing == Standing::good);
}

std::vector<TrustQuestion> trust_questions(const std::vector<ExamplePage>& pages)
{
  std::vector<TrustQuestion> questions;
  for (const ExamplePage& page : pages)
    for (std::size_t k = 0; k < page.results.size(); ++k) {
      const auto& [name, run] = page.example.runs[k];
      if (!run.is_run() || page.results[k].end.kind != jobs::JobEnd::Kind::finished) continue;
      const record::RunRecord record = structures::read_run(page.results[k].folder);
      const Index farthest = farthest_off(page, name, record);
      if (farthest == none) continue;
      const Expectation& e = page.example.expectations[farthest];
      const ExpectationResult& f = page.findings[farthest];
      questions.push_back({f.problem, page.example.name, name, f.what, f.exact, error_of(e, f.number), report::judgement_of(record)});
    }
  return questions;
}

std::string words_of(const std::vector<TrustQuestion>& questions)
{
  const auto count = [&](auto is) { return std::count_if(questions.begin(), questions.end(), is); };
  return fmt::format("{} runs whose answer is known: of {} right ones {} are rated bad, of {} wrong ones {} are rated good",
                     questions.size(), count([](const TrustQuestion& q) { return q.is_right(); }),
                     count([](const TrustQuestion& q) { return q.is_right() && q.is_misjudged(); }),
                     count([](const TrustQuestion& q) { return q.is_wrong(); }),
                     count([](const TrustQuestion& q) { return q.is_wrong() && q.is_misjudged(); }));
}

std::string trust_page(const std::vector<TrustQuestion>& questions)
{
  std::vector<TrustQuestion> ordered = questions;
  std::stable_sort(ordered.begin(), ordered.end(), [](const TrustQuestion& a, const TrustQuestion& b) {
    return std::pair(!a.is_misjudged(), -std::abs(a.error)) < std::pair(!b.is_misjudged(), -std::abs(b.error));
  });
  std::string html = "<nav>" + link_to("index.html", "verification book") + "</nav>\n<h1>Are the verdicts of the pages right?</h1>\n";
  html += fmt::format(
      "<p>{}. An answer is right where its least accurate number is within {:g} % of the known one, and wrong where it is off by more than "
      "{:g} %. What a page says is the worst of its measures; doubtful is a warning, whatever it is of. Misjudged runs come "
      "first.</p>\n<table>\n",
      words_of(questions), 100 * error_of_right, 100 * error_of_wrong);
  html += text::plain_row({"run", "farthest off", "known", "error", "the answer is", "its page says", "its warnings"}, 2, 3, "th");
  for (const TrustQuestion& question : ordered) html += row_of(question);
  return text::plain_page("berm: are the verdicts of the pages right?", html + "</table>\n");
}

}  // namespace berm::verification
