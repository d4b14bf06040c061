// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/document_test.cpp
#include "input/message_text.hpp"

#include "os/control_characters.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::input {
namespace {

std::string with_unit(const std::string& number, const std::string& unit)
{
  return unit.empty() ? number : number + " " + unit;
}

std::string bounds(const Range& range, Real scale, const std::string& unit)
{
  const auto number = [&](Real value) { return fmt::format("{:.4g}", value / scale); };
  const bool below = range.min > -infinity, above = range.max < infinity;
  if (below && above && !range.min_open && !range.max_open)
    return with_unit(fmt::format("from {} to {}", number(range.min), number(range.max)), unit);
  std::string text;
  if (below) text = fmt::format("{} {}", range.min_open ? "more than" : "at least", number(range.min));
  if (above) text += fmt::format("{}{} {}", below ? " and " : "", range.max_open ? "less than" : "at most", number(range.max));
  return with_unit(text, unit);
}

}  // namespace

int edit_distance(const std::string& a, const std::string& b)
{
  const int n = static_cast<int>(a.size()), m = static_cast<int>(b.size());
  std::vector<std::vector<int>> d(n + 1, std::vector<int>(m + 1));
  for (int i = 0; i <= n; ++i) d[i][0] = i;
  for (int j = 0; j <= m; ++j) d[0][j] = j;
  for (int i = 1; i <= n; ++i)
    for (int j = 1; j <= m; ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[n][m];
}

std::string nearest(const std::string& word, const std::vector<std::string>& words)
{
  if (word.empty() || word.size() > 100) return "";
  std::string best;
  int min = 2 + static_cast<int>(word.size()) / 4;
  for (const std::string& candidate : words) {
    if (candidate.size() > 2 * word.size() + 2) continue;  // farther than that
    const int distance = edit_distance(word, candidate);
    if (distance < min && distance < static_cast<int>(std::max(word.size(), candidate.size()))) min = distance, best = candidate;
  }
  const auto begins = [&](const std::string& candidate) { return word.size() > 2 && candidate.starts_with(word); };
  if (best.empty() && std::count_if(words.begin(), words.end(), begins) == 1) best = *std::find_if(words.begin(), words.end(), begins);
  return best;
}

std::string suggestion(const std::string& word, const std::vector<std::string>& allowed)
{
  if (allowed.empty()) return "";
  const std::string near = nearest(word, allowed);
  return (near.empty() ? "" : fmt::format("; did you mean {}?", in_quotes(near))) + fmt::format(" (allowed: {})", listed(allowed));
}

std::string listed(const std::vector<std::string>& words)
{
  constexpr std::size_t max = 12;
  std::string text;
  for (std::size_t k = 0; k < std::min(words.size(), max); ++k) text += (k == 0 ? "" : ", ") + words[k];
  return words.size() > max ? text + ", ..." : text;
}

std::string shortened(const std::string& text, std::size_t max)
{
  std::size_t end = std::min(text.size(), max);
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + (end < text.size() ? "..." : "");
}

std::string in_quotes(const std::string& text)
{
  return one_line(fmt::format("\"{}\"", shortened(text, 60)));
}

std::string quantity(Real value, const std::string& si_unit)
{
  if (si_unit == "rad") return fmt::format("{:.6g} deg", value / degree);
  return with_unit(fmt::format("{:.6g}", value), si_unit);
}

std::string range_text(const Range& range, const std::string& si_unit)
{
  if (range.min == -infinity && range.max == infinity) return "";
  if (si_unit != "rad") return bounds(range, 1, si_unit);
  std::string radians = bounds(range, 1, "rad");
  if (radians.starts_with("from ")) radians.erase(0, 5);
  return fmt::format("{} ({})", bounds(range, degree, "deg"), radians);
}

bool within(Real value, const Range& range)
{
  const bool above = range.min_open ? value > range.min : value >= range.min;
  const bool below = range.max_open ? value < range.max : value <= range.max;
  return above && below;
}

}  // namespace berm::input
