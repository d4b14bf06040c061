// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/safety/search_test.cpp
#include "safety/search.hpp"

#include <algorithm>
#include <cmath>

namespace berm::safety {
namespace {

constexpr Real growth = 1.5;

Real with_four_decimals(Real factor)
{
  return std::round(factor * 1e4) / 1e4;
}

/// Adds the factors that cut what lies between two of them into equal parts.
void divide(Real from, Real to, int cuts, std::vector<Real>& factors)
{
  for (int k = 1; k <= cuts; ++k) factors.push_back(with_four_decimals(std::lerp(from, to, Real(k) / (cuts + 1))));
}

/// low to high, those of them that have no trial.
std::vector<Real> first_factors(const std::vector<Trial>& trials, const SearchSettings& s)
{
  std::vector<Real> factors = {with_four_decimals(s.low)};
  if (s.at_once > 1) {
    divide(s.low, s.high, s.at_once - 2, factors);
    factors.push_back(with_four_decimals(s.high));
  }
  std::erase_if(factors, [&](Real f) { return std::any_of(trials.begin(), trials.end(), [&](const Trial& t) { return t.factor == f; }); });
  return factors;
}

/// On from a factor by steps of `growth` or 1 / growth, to `end` at most.
std::vector<Real> stepping(Real from, Real step, Real end, int count)
{
  std::vector<Real> factors;
  for (int k = 0; k < count && from != end; ++k) {
    from = step > 1 ? std::min(end, with_four_decimals(from * step)) : std::max(end, with_four_decimals(from * step));
    factors.push_back(from);
  }
  return factors;
}

}  // namespace

const char* word_of(TrialEnd end)
{
  return end == TrialEnd::stands ? "stands" : end == TrialEnd::fails ? "fails" : "undecided";
}

Bracket bracket_of(const std::vector<Trial>& trials)
{
  Bracket bracket;
  for (const Trial& t : trials)
    if (t.end == TrialEnd::fails && !(bracket.fails <= t.factor && bracket.fails)) bracket.fails = t.factor;
  for (const Trial& t : trials) {
    if (t.end != TrialEnd::stands) continue;
    if (bracket.fails && t.factor > *bracket.fails)
      bracket.stands_above.push_back(t.factor);
    else if (!bracket.stands || t.factor > *bracket.stands)
      bracket.stands = t.factor;
  }
  for (const Trial& t : trials)
    if (t.end == TrialEnd::undecided && t.factor > bracket.stands.value_or(0) && t.factor < bracket.fails.value_or(infinity))
      bracket.undecided.push_back(t.factor);
  std::sort(bracket.undecided.begin(), bracket.undecided.end());
  std::sort(bracket.stands_above.begin(), bracket.stands_above.end());
  return bracket;
}

std::vector<Real> next_factors(const std::vector<Trial>& trials, const SearchSettings& s)
{
  if (trials.empty()) return first_factors(trials, s);
  const Bracket bracket = bracket_of(trials);
  constexpr std::size_t none_tells = 3;  // of trials that are all undecided
  if (!bracket.stands && !bracket.fails && trials.size() >= none_tells) return {};
  const auto [least, most] =
      std::minmax_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.factor < b.factor; });
  if (!bracket.stands) return stepping(least->factor, 1 / growth, min_factor, s.at_once);
  if (!bracket.fails) {
    if (most->factor < s.high) return {with_four_decimals(s.high)};
    return stepping(most->factor, growth, max_factor, s.at_once);
  }
  std::vector<std::pair<Real, Real>> parts = {{*bracket.stands, *bracket.fails}};
  if (!bracket.undecided.empty()) parts = {{*bracket.stands, bracket.undecided.front()}, {bracket.undecided.back(), *bracket.fails}};
  std::erase_if(parts, [&](const auto& part) { return part.second - part.first <= s.tolerance * (1 + 1e-9); });
  std::vector<Real> factors;
  for (const auto& [from, to] : parts) {
    const int share = std::max(1, s.at_once / static_cast<int>(parts.size()));
    const int enough = static_cast<int>(std::ceil((to - from) / s.tolerance * (1 - 1e-9))) - 1;
    divide(from, to, std::min(share, enough), factors);
  }
  if (static_cast<int>(factors.size()) > s.at_once) factors.resize(static_cast<std::size_t>(s.at_once));
  return factors;
}

}  // namespace berm::safety
