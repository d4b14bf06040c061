// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/contours.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace berm::cyclic {
namespace {

/// From y_0 at x_0 to y_1 at x_1.
Real line(Real x, Real x0, Real x1, Real y0, Real y1)
{
  return x1 == x0 ? y0 : y0 + (y1 - y0) * (x - x0) / (x1 - x0);
}

Real stress_on(const ContourCurve& curve, Real cycles)
{
  const auto next = std::lower_bound(curve.begin(), curve.end(), cycles, [](const ContourPoint& p, Real n) { return p.cycles < n; });
  if (next == curve.end()) return curve.back().stress;
  if (next == curve.begin()) return next->stress;
  const ContourPoint &a = *std::prev(next), &b = *next;
  return line(std::log(cycles), std::log(a.cycles), std::log(b.cycles), a.stress, b.stress);
}

}  // namespace

Contours::Contours(const ContourTable& table, Real average)
{
  constexpr Real rounding = 1e-9;
  std::vector<Real> all_cycles;
  last_ = infinity;
  for (const auto& [strain, by_average] : table) {
    const auto high = by_average.lower_bound(average - rounding);
    const bool on_high = high != by_average.end() && high->first <= average + rounding;
    if (high == by_average.end() || (high == by_average.begin() && !on_high))
      throw InputError(fmt::format("the average stress is {:.4g} s_u, and the contour of {:.4g} is known from {:.4g} to {:.4g} s_u",
                                   average, strain, by_average.begin()->first, by_average.rbegin()->first));
    const auto low = on_high ? high : std::prev(high);
    strains_.push_back(strain);
    curves_.push_back({low->second, high->second, line(average, low->first, high->first, 0, 1)});
    for (const ContourCurve* curve : {&low->second, &high->second}) {
      first_ = std::max(first_, curve->front().cycles);
      last_ = std::min(last_, curve->back().cycles);
      for (const ContourPoint& point : *curve) all_cycles.push_back(point.cycles);
    }
  }
  if (!(last_ > first_)) throw InputError("there is no range of cycles in which all contours are known at this average stress");
  for (Real cycles : all_cycles)
    for (std::size_t k = 0; k < strains_.size(); ++k) {
      cycles = std::clamp(cycles, first_, last_);
      if (!(stress(k, cycles) > (k == 0 ? 0 : stress(k - 1, cycles))))
        throw InputError(fmt::format("at an average stress of {:.4g} s_u and N = {:.4g} the contour of {:.4g} is not above {}", average,
                                     cycles, strains_[k], k == 0 ? "0" : fmt::format("that of {:.4g}", strains_[k - 1])));
    }
}

Real Contours::stress(std::size_t k, Real cycles) const
{
  const Between& curve = curves_[k];
  return line(curve.part, 0, 1, stress_on(curve.low, cycles), stress_on(curve.high, cycles));
}

Real Contours::strain(Real tau, Real cycles) const
{
  if (cycles < first_) return strain(tau, first_) * cycles / first_;
  Real below = stress(0, cycles);
  if (tau <= below) return strains_[0] * tau / below;
  for (std::size_t k = 1; k < strains_.size(); ++k) {
    const Real above = stress(k, cycles);
    if (tau <= above)
      return std::exp(line(std::log(tau), std::log(below), std::log(above), std::log(strains_[k - 1]), std::log(strains_[k])));
    below = above;
  }
  return infinity;
}

Real Contours::cycles(Real tau, Real gamma) const
{
  const Real at_first = strain(tau, first_);
  if (gamma < at_first) return first_ * gamma / at_first;
  Real low = std::log(first_), high = std::log(last_);
  for (int step = 0; step < 60; ++step) {
    const Real middle = (low + high) / 2;
    (strain(tau, std::exp(middle)) <= gamma ? low : high) = middle;
  }
  return std::exp(high);
}

}  // namespace berm::cyclic
