// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mesh/gmsh_test.cpp
#include "mesh/line_reader.hpp"

#include "os/error.hpp"
#include "os/text_file.hpp"

#include <charconv>
#include <fmt/format.h>

namespace berm::mesh {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text)
{
  const std::size_t first = text.find_first_not_of(blanks);
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Without bytes that would corrupt a terminal.
std::string plain(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7F) c = '?';
  return text;
}

// Enough of a line to recognize it.
std::string quoted(std::string_view text)
{
  constexpr std::size_t max = 60;
  std::string result = plain(std::string(text.substr(0, max)));
  for (char& c : result)
    if (static_cast<unsigned char>(c) > '~') c = '?';
  return "\"" + result + (text.size() > max ? "...\"" : "\"");
}

}  // namespace

Lines::Lines(const std::filesystem::path& path) : name_(path.string())
{
  constexpr std::uintmax_t max_bytes = 20'000'000'000;
  FileBytes found = read_file(path, max_bytes);
  if (!found.fault.empty()) throw InputError(fmt::format("{}: {}", name_, found.fault));
  content_ = std::move(found.bytes);
  position_ = begin_of_text(content_);
}

bool Lines::next()
{
  while (position_ < content_.size()) {
    const std::size_t end = std::min(content_.find('\n', position_), content_.size());
    line_ = trimmed(std::string_view(content_).substr(position_, end - position_));
    position_ = end + 1;
    ++number_;
    rest_ = line_;
    if (!line_.empty()) return true;
  }
  line_ = rest_ = {};
  return false;
}

void Lines::need(const char* expected)
{
  if (!next()) fail(fmt::format("expected {}, but the file ends here", expected));
}

std::string_view Lines::word(const char* expected)
{
  if (rest_.empty()) fail_expected(expected);
  const std::size_t end = std::min(rest_.find_first_of(blanks), rest_.size());
  const std::string_view found = rest_.substr(0, end);
  rest_ = trimmed(rest_.substr(end));
  return found;
}

BigIndex Lines::integer(const char* expected, BigIndex min, BigIndex max)
{
  const std::string_view digits = word(expected);
  BigIndex value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) fail_expected(expected);
  if (error != std::errc() || value < min || value > max) fail(fmt::format("expected {}; {} is out of range", expected, quoted(digits)));
  return value;
}

Real Lines::real(const char* expected)
{
  const std::string_view digits = word(expected);
  Real value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) fail_expected(expected);
  if (error == std::errc() && !std::isfinite(value)) fail(fmt::format("expected {}; {} is not finite", expected, quoted(digits)));
  if (error != std::errc() && digits.find("e-") == digits.npos)
    fail(fmt::format("expected {}; {} is out of range", expected, quoted(digits)));
  return value;
}

BigIndex Lines::count(const char* expected, BigIndex bytes)
{
  const BigIndex value = integer(expected, 0, std::numeric_limits<BigIndex>::max());
  const auto left = static_cast<BigIndex>(content_.size() - std::min(position_, content_.size()) + 1);
  if (value > left / bytes)
    fail(fmt::format("expected {}; {} is impossible: the rest of the file is too short for so many", expected, value));
  return value;
}

void Lines::need_end(const char* expected) const
{
  if (!rest_.empty()) fail(fmt::format("expected only {}, but {} follows", expected, quoted(rest_)));
}

void Lines::fail(const std::string& message) const
{
  throw InputError(fmt::format("{}:{}: {}", name_, number_, plain(message)));
}

void Lines::fail_expected(const char* expected) const
{
  fail(fmt::format("expected {}, but the line is {}", expected, quoted(line_)));
}

}  // namespace berm::mesh
