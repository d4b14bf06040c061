// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/quality/quality_section_test.cpp
#include "structures/base/trust_measure.hpp"

#include "text/quantity_words.hpp"

#include <array>
#include <fmt/format.h>

namespace berm::base {

const char* heading_of(Effect effect)
{
  constexpr std::array headings{"Dilation",       "Cells",       "Contact width", "Walls",   "Drive speed",      "Energy",
                                "Out of balance", "Shaken soil", "Noise",         "Contact", "Bounds of volume", "Short travel"};
  static_assert(headings.size() == static_cast<std::size_t>(Effect::count));
  return headings[static_cast<std::size_t>(effect)];
}

text::Standing judge(const Limit& limit, Real value)
{
  if (std::isnan(value)) return text::Standing::unknown;
  if (limit.large ? value >= limit.good : value <= limit.good) return text::Standing::good;
  return (limit.large ? value < limit.bad : value > limit.bad) ? text::Standing::bad : text::Standing::fair;
}

std::string TrustMeasure::warning_of(const record::RunRecord& run, Real of) const
{
  if (warning.made) return warning.made(run, of);
  return fmt::format(fmt::runtime(warning.text), words(run, of));
}

TrustMeasures joined(std::initializer_list<TrustMeasures> parts)
{
  TrustMeasures all;
  for (const TrustMeasures& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

bool always(const record::RunRecord&)
{
  return true;
}

std::string in_percent(const record::RunRecord&, Real value)
{
  return text::percent_words(value);
}

std::string as_number(const record::RunRecord&, Real value)
{
  return fmt::format("{:.2g}", value);
}

std::string bare_limit(Real value)
{
  return fmt::format("{:.4g}", value);
}

}  // namespace berm::base
