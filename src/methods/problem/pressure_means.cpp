// SPDX-License-Identifier: BSD-3-Clause
#include "problem/pressure_means.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berm::problem {

Real weight_in_window(Real since, Real window)
{
  return 1 - std::cos(2 * std::numbers::pi * since / window);
}

namespace {

/// Of means in the middle of windows, the pressure where their stage began, if it fell as the square root of the time: a is that of this window, b of the next.
Real at_begin(Real a, Real b, int window)
{
  const Real of_a = std::sqrt(window - 0.5), of_b = std::sqrt(window + 0.5);
  return a + (a - b) * of_a / (of_b - of_a);
}

}  // namespace

// The first mean of a pressure that falls from the beginning on is less than the largest was; and what damping leaves of a sudden load may raise it, but not the next ones.
void end_window(PressureMeans& means, Real mean, Real time)
{
  const Real first = means.largest, second = means.last;
  ++means.count;
  if (means.count == 3 && first > second)
    means.largest = std::max({second, mean, std::min(at_begin(first, second, 1), at_begin(second, mean, 2))});
  else
    means.largest = std::max(means.largest, mean);
  means.before = means.last;
  means.last = mean;
  means.begin = time;
  means.weight = 0;
}

// The means are those of the middles of their windows.
Real mean_now(const PressureMeans& means, Real since_stage, Real window)
{
  if (means.count < 2 || !(means.last < means.before)) return means.last;
  const Real of_last = (static_cast<Real>(means.count) - 0.5) * window, of_before = of_last - window;
  return means.last * std::pow(means.last / means.before, std::log(since_stage / of_last) / std::log(of_last / of_before));
}

void note_without_waves(PressureMeans& means, Real pressure)
{
  means.now = pressure;
  means.largest = std::max(means.largest, pressure);
}

Real degree_of_consolidation(const PressureMeans& means)
{
  return means.largest > 0 ? std::clamp(1 - means.now / means.largest, Real(0), Real(1)) : 0;
}

}  // namespace berm::problem
