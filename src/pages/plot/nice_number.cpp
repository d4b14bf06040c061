// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/record/soil_plot_test.cpp
#include "plot/nice_number.hpp"

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

}  // namespace berm::plot
