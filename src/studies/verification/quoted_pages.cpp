// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/quoted_pages.hpp"

#include "expectations/quotation.hpp"
#include "input/message_text.hpp"
#include "io/atomic_file.hpp"
#include "io/tell.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::verification {
namespace {

namespace fs = std::filesystem;

/// Replaces what is there once. Throws RunError where it is not.
void replace_in(const fs::path& file, const std::string& old, const std::string& text)
{
  std::string content = io::read_text_file(file);
  const std::size_t at = content.find(old);
  if (at == std::string::npos) throw RunError(fmt::format("{} has no {}; change it by hand", file.string(), input::in_quotes(old)));
  io::write_atomically(file, content.replace(at, old.size(), text));
}

}  // namespace

void check_quotations(const fs::path& folder, const std::vector<Expectation>& expectations)
{
  for (const Expectation& e : expectations) {
    if (e.quoted.empty()) continue;
    const expectations::Quotation quotation = quotation_of(e);
    const std::string content = io::read_text_file(folder / e.page), text = quotation.on_page(quotation.number);
    const std::size_t at = content.find(text);
    const bool once = at != std::string::npos && content.find(text, at + 1) == std::string::npos;
    if (!once)
      throw InputError(fmt::format("{}: quoted: {} has {} {}", (folder / expectations::expected_file).string(), (folder / e.page).string(),
                                   at == std::string::npos ? "no" : "more than one", input::in_quotes(text)));
  }
}

void quote_results(const std::vector<ExamplePage>& pages)
{
  for (const ExamplePage& page : pages)
    for (std::size_t k = 0; k < page.findings.size(); ++k) {
      const Expectation& e = page.example.expectations[k];
      if (e.quoted.empty() || page.findings[k].verdict != Verdict::missed) continue;
      const expectations::Quotation quotation = quotation_of(e);
      const std::string number = quotation.rounded(page.findings[k].number);
      const fs::path file = page.example.folder / e.page;
      replace_in(file, quotation.on_page(quotation.number), quotation.on_page(number));
      replace_in(page.example.folder / expectations::expected_file, e.quoted, quotation.in_braces(number));
      io::tell("{}: {} is now {}\n", file.string(), quotation.on_page(quotation.number), number);
    }
}

}  // namespace berm::verification
