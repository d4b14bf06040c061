// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_footing_test.cpp
#include "structures/penetration/code_envelope.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace berm::penetration {
namespace {

using base::PublishedCurve, base::PublishedEnvelope;
using formulas::Formula;

constexpr int code_curve_points = 60;

/// The largest x of [0, most] with a condition that holds up to some x; NaN where it does not hold at 0.
Real largest_with(const std::function<bool(Real)>& holds, Real most)
{
  if (!holds(0)) return nan;
  if (holds(most)) return most;
  Real low = 0, high = most;
  for (int k = 0; k < 60; ++k) {
    const Real middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

Formula with_value(Formula formula, Real value)
{
  formula.value = value;
  return formula;
}

/// V and M = V e by eccentricity, and the largest M.
void add_moments(const std::function<Formula(Real e)>& V_at, Real width, PublishedEnvelope& published)
{
  const Formula upright = V_at(0);
  PublishedCurve moments{base::titled("ISO 19901-4, effective area", upright), {}, {}, {}, true};
  Real largest = 0;
  for (int k = 0; k <= code_curve_points; ++k) {
    const Real e = width / 2 * k / code_curve_points, V = k == code_curve_points ? 0 : V_at(e).value;
    moments.V.push_back(V), moments.M.push_back(V * e);
    largest = std::max(largest, V * e);
  }
  published.curves.push_back(std::move(moments));
  published.numbers.push_back({"M_max_code", with_value(upright, largest), true});
}

}  // namespace

void add_code_on_clay(const formulas::FoundationBase& base, const formulas::ClayOfFoundation& clay, PublishedEnvelope& published)
{
  const auto V_at = [&](Real H, Real e) { return code_bearing_clay(base, clay, H, e); };
  const Formula upright = V_at(0, 0), sliding = code_sliding_clay(base, clay);
  published.numbers.push_back({"V_max_code", upright});
  published.numbers.push_back({"H_max_code", sliding});
  PublishedCurve inclined{base::titled("ISO 19901-4", upright), {}, {}, {}, true};
  for (int k = 0; k <= code_curve_points; ++k) {
    const Real H = sliding.value * std::sin(pi / 2 * k / code_curve_points);
    inclined.V.push_back(V_at(H, 0).value), inclined.H.push_back(H);
  }
  inclined.V.push_back(0), inclined.H.push_back(sliding.value);
  published.curves.push_back(std::move(inclined));
  add_moments([&](Real e) { return V_at(0, e); }, base.width, published);
  for (const Real level : base::section_levels) {
    const Real V = level * upright.value;
    const Real most = largest_with([&](Real H) { return V_at(H, 0).value >= V; }, sliding.value);
    PublishedCurve section{base::titled(fmt::format("ISO 19901-4, V = {:g} Vmax", level), upright), {}, {}, {}, true};
    for (int k = -code_curve_points; k <= code_curve_points; ++k) {
      const Real H = most * k / code_curve_points;
      section.H.push_back(H);
      section.M.push_back(V * largest_with([&](Real e) { return V_at(H, e).value >= V * (1 - 1e-9); }, base.width / 2));
    }
    published.curves.push_back(std::move(section));
  }
}

void add_code_on_sand(const formulas::FoundationBase& base, const formulas::SandOfFoundation& sand, Real interface_angle,
                      PublishedEnvelope& published)
{
  const Formula upright = code_bearing_sand(base, sand, 0, 0);
  published.numbers.push_back({"V_max_code", upright});
  PublishedCurve inclined{base::titled("ISO 19901-4", upright), {}, {}, {}, true};
  const Real steepest = std::tan(interface_angle);
  for (int k = 0; k <= code_curve_points; ++k) {
    const Real t = steepest * k / code_curve_points, V = code_bearing_sand(base, sand, t, 0).value;
    inclined.V.push_back(V), inclined.H.push_back(t * V);
  }
  inclined.V.push_back(0), inclined.H.push_back(0);  // it slides
  published.curves.push_back(std::move(inclined));
  add_moments([&](Real e) { return code_bearing_sand(base, sand, 0, e); }, base.width, published);
}

}  // namespace berm::penetration
