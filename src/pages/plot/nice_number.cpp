// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/record/soil_plot_test.cpp
#include "plot/nice_number.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::plot {

Real round_up(Real value)
{
  if (!(value > 0)) return 1;
  const Real exponent = std::floor(std::log10(value)), power = std::pow(10, std::abs(exponent));
  const auto scaled = [&](Real step) { return exponent < 0 ? step / power : step * power; };  // 0.3 as it is written, not 3 * 0.1
  for (const Real step : {1., 1.5, 2., 3., 4., 5., 6., 8.})
    if (value <= scaled(step) * (1 + 1e-9)) return scaled(step);
  return scaled(10);
}

Real axis_base(Real from, Real to)
{
  constexpr Real far = 1000;  // m, and lengths of the axis
  const Real length = to - from;
  if (!(std::max(std::abs(from), std::abs(to)) > far * std::max(length, Real(1)))) return 0;
  const Real power = std::pow(10, std::ceil(std::log10(10 * length)));
  return std::round((from + to) / 2 / power) * power;
}

std::string axis_title(const std::string& name, Real base, const std::string& unit)
{
  return base == 0 ? fmt::format("{} ({})", name, unit)
                   : fmt::format("{} {} {:.12g} m ({})", name, base < 0 ? "+" : "-", std::abs(base), unit);
}

}  // namespace berm::plot
