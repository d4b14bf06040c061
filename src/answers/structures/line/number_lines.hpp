// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "input/message_text.hpp"
#include "os/error.hpp"
#include "os/read_file.hpp"

#include <charconv>
#include <filesystem>
#include <fmt/format.h>

namespace berm::line {

/// Where a file of numbers is being read, for what is wrong with it.
struct NumberLines {
  const std::filesystem::path& file;
  int line = 0;

  [[noreturn]] void refuse(const std::string& why) const { throw RunError(fmt::format("{}:{}: {}", file.string(), line, why)); }

  Real number(std::string_view word) const
  {
    Real value = nan;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size())
      refuse(fmt::format("{} is not a number", input::in_quotes(std::string(word))));
    return value;
  }
};

/// The whole text of a file of a run. Throws RunError where it cannot be read.
inline std::string text_of(const std::filesystem::path& file)
{
  constexpr std::uintmax_t max_bytes = 5'000'000'000;
  const auto [text, fault] = read_file(file, max_bytes);
  if (!fault.empty()) throw RunError(fmt::format("{}: {}", file.string(), fault));
  return text;
}

}  // namespace berm::line
