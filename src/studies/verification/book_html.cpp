// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/verification/verify_test.cpp
#include "verification/book_html.hpp"

#include "io/atomic_file.hpp"
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

}  // namespace berm::verification
