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
  last_ = infinity;
  for (const auto& [strain, by_average] : table) {
    const auto high = by_average.lower_bound(average);
    if (high == by_average.end() || (high == by_average.begin() && high->first != average))
      throw InputError(fmt::format("the average stress is {:.4g} s_u, and the contour of {:.4g} is known from {:.4g} to {:.4g} s_u",
                                   average, strain, by_average.begin()->first, by_average.rbegin()->first));
    const auto low = high->first == average ? high : std::prev(high);
    strains_.push_back(strain);
    curves_.push_back({low->second, high->second, line(average, low->first, high->first, 0, 1)});
    for (const ContourCurve* curve : {&low->second, &high->second}) {
      first_ = std::max(first_, curve->front().cycles);
      last_ = std::min(last_, curve->back().cycles);
    }
  }
  if (!(last_ > first_)) throw InputError("there is no range of cycles in which all contours are known at this average stress");
  for (std::size_t k = 0; k < curves_.size(); ++k)
    for (const ContourCurve* curve :
         {&curves_[k].low, &curves_[k].high, &curves_[k == 0 ? 0 : k - 1].low, &curves_[k == 0 ? 0 : k - 1].high})
      for (const ContourPoint& point : *curve) {
        const Real n = std::clamp(point.cycles, first_, last_);
        if (k == 0 && !(stress(0, n) > 0))
          throw InputError(fmt::format("at an average stress of {:.4g} s_u the contour of {:.4g} has no cyclic stress at N = {:.4g}",
                                       average, strains_[0], n));
        if (k > 0 && !(stress(k, n) > stress(k - 1, n)))
          throw InputError(
              fmt::format("at an average stress of {:.4g} s_u and N = {:.4g} the contour of {:.4g} is not above that of {:.4g}", average, n,
                          strains_[k], strains_[k - 1]));
      }
}

Real Contours::stress(std::size_t k, Real cycles) const
{
  const Between& curve = curves_[k];
  return line(curve.part, 0, 1, stress_on(curve.low, cycles), stress_on(curve.high, cycles));
}

Real Contours::strain(Real stress_, Real cycles) const
{
  if (cycles < first_) return strain(stress_, first_) * cycles / first_;
  Real below = stress(0, cycles);
  if (stress_ <= below) return strains_[0] * stress_ / below;
  for (std::size_t k = 1; k < strains_.size(); ++k) {
    const Real above = stress(k, cycles);
    if (stress_ <= above)
      return std::exp(line(std::log(stress_), std::log(below), std::log(above), std::log(strains_[k - 1]), std::log(strains_[k])));
    below = above;
  }
  return infinity;
}

Real Contours::cycles(Real stress, Real strain_) const
{
  const Real at_first = strain(stress, first_);
  if (strain_ < at_first) return first_ * strain_ / at_first;
  Real low = std::log(first_), high = std::log(last_);
  for (int step = 0; step < 60; ++step) {
    const Real middle = (low + high) / 2;
    (strain(stress, std::exp(middle)) <= strain_ ? low : high) = middle;
  }
  return std::exp(high);
}

}  // namespace berm::cyclic
