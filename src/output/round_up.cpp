// SPDX-License-Identifier: BSD-3-Clause
#include "output/round_up.hpp"

namespace berm {

Real round_up(Real value)
{
  if (!(value > 0)) return 1;
  const Real power = std::pow(10, std::floor(std::log10(value)));
  for (const Real step : {1., 1.5, 2., 3., 4., 5., 6., 8.})
    if (value <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

}  // namespace berm
