// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/book_html.hpp"

#include "io/atomic_file.hpp"
#include "io/duration_text.hpp"
#include "text/html.hpp"

#include <array>
#include <fmt/format.h>
#include <sstream>

namespace berm::verification {

std::string link_to(const std::string& address, const std::string& text)
{
  return fmt::format("<a href=\"{}\">{}</a>", text::html_text(address), text::html_text(text));
}

std::string address_of(const std::filesystem::path& path)
{
  std::string address;
  for (const char c : path.generic_string()) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = std::isalnum(byte) != 0 || std::string("/._-+=~").find(c) != std::string::npos;
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return address;
}

std::string badge(Verdict verdict)
{
  constexpr std::array classes{"met", "missed", "failed", "not_run"};
  return fmt::format("<span class=\"verdict {}\">{}</span>", classes[static_cast<std::size_t>(verdict)], word_of(verdict));
}

std::string readme_of(const Example& example)
{
  return io::read_text_file(example.folder / "README.md");
}

std::string title_of(const Example& example)
{
  std::istringstream lines(readme_of(example));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("# ")) return example.name + ": " + line.substr(2);
  return example.name;
}

std::vector<std::string> numbers_of(const ExpectationResult& f)
{
  std::vector<std::string> cells;
  for (const std::string& text : {f.exact, f.reason.empty() ? f.berm : "", f.error, f.tolerance}) cells.push_back(text::html_text(text));
  cells.push_back(badge(f.verdict));
  return cells;
}

std::string time_of(const ProblemResult& result)
{
  return result.end.kind == jobs::JobEnd::Kind::finished ? io::duration_text(jobs::wall_time_of(result.folder)) : "";
}

const ProblemResult* result_of(const ExamplePage& page, const std::string& run)
{
  for (std::size_t k = 0; k < page.results.size(); ++k)
    if (page.example.runs[k].first == run) return &page.results[k];
  return nullptr;
}

}  // namespace berm::verification
