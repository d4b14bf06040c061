// SPDX-License-Identifier: BSD-3-Clause
#include "input/load_history.hpp"

#include "core/error.hpp"

#include <charconv>
#include <fmt/format.h>
#include <fstream>

namespace berm::input {
namespace {

/// The number that a field is, without the spaces around it; empty where it is none.
std::optional<Real> number_of(std::string_view field)
{
  const auto begin = field.find_first_not_of(" \t"), end = field.find_last_not_of(" \t\r");
  if (begin == std::string_view::npos) return std::nullopt;
  field = field.substr(begin, end + 1 - begin);
  Real number = 0;
  const auto [rest, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  if (error != std::errc() || rest != field.data() + field.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

void read_load_history(problem::StageSettings& stage, std::size_t stage_number, const std::filesystem::path& folder)
{
  if (stage.load_history.empty() && stage.load_times.empty()) return;
  if (!stage.load_history.empty()) {
    const std::filesystem::path file = folder / stage.load_history;
    std::ifstream lines(file);
    if (!lines) throw KeyError(fmt::format("stage[{}].load_history: {} cannot be read", stage_number, file.string()));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (line.find_first_not_of(" \t\r") == std::string::npos || line[0] == '#') continue;
      const std::size_t comma = line.find(',');
      const auto time = number_of(std::string_view(line).substr(0, comma));
      const auto factor = comma == std::string::npos ? std::nullopt : number_of(std::string_view(line).substr(comma + 1));
      if (!time && !factor && stage.load_times.empty() && comma != std::string::npos) continue;
      const auto refuse = [&](const char* why) { throw InputError(fmt::format("{}:{}: {}", file.string(), number, why)); };
      if (!time || !factor) refuse("a line of a load history is two numbers, time in s and factor: 0.5, 1.2");
      if (*time < 0) refuse("times count from the begin of the stage: 0 or more");
      if (!stage.load_times.empty() && *time <= stage.load_times.back()) refuse("times must ascend");
      stage.load_times.push_back(*time);
      stage.load_factors.push_back(*factor);
    }
    if (stage.load_times.empty() || stage.load_times.back() == 0)
      throw InputError(fmt::format("{}: has no line of two numbers, time in s (more than 0) and factor", file.string()));
    stage.load_history.clear();
  }
  stage.until.time = std::min(stage.until.time.value_or(infinity), stage.load_times.back());
}

}  // namespace berm::input
