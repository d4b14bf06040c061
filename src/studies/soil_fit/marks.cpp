// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/fit_soil_test.cpp
#include "soil_fit/marks.hpp"

#include <algorithm>

namespace berm::soil_fit {
namespace {

using Curves = std::vector<const std::vector<Real>*>;  ///< as MeasuredTest::curves

const std::vector<Real>* curve_of(const MeasuredTest& test, const Curves& curves, Compared what)
{
  for (std::size_t k = 0; k < test.curves.size(); ++k)
    if (test.curves[k].what == what) return curves[k];
  return nullptr;
}

/// Slope of a line through y(x) within `reach` of x[at], or through the nearest five rows.
Real slope_about(const std::vector<Real>& x, const std::vector<Real>& y, std::size_t at, Real reach)
{
  constexpr std::size_t least_rows = 5;
  std::vector<Real> distances;
  for (const Real each : x) distances.push_back(std::abs(each - x[at]));
  std::sort(distances.begin(), distances.end());
  reach = std::max(reach, distances[std::min(least_rows, distances.size()) - 1]);
  Real n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (const Real d = x[k] - x[at]; std::abs(d) <= reach && std::isfinite(y[k]))
      n += 1, sx += d, sy += y[k], sxx += d * d, sxy += d * y[k];
  const Real var = n * sxx - sx * sx;
  return n > 2 && var > 0 ? (n * sxy - sx * sy) / var : nan;
}

/// The strain at which y first reaches a value, over that, from the first row.
Real secant(const std::vector<Real>& x, const std::vector<Real>& y, Real rise)
{
  for (std::size_t k = 1; k < x.size(); ++k) {
    if (!(std::abs(y[k] - y[0]) >= std::abs(rise))) continue;
    const Real part = (rise - (y[k - 1] - y[0])) / (y[k] - y[k - 1]);
    return std::abs(rise) / (x[k - 1] + part * (x[k] - x[k - 1]));
  }
  return nan;
}

constexpr Real plateau = 1e-3;  // of the largest stress ratio: rows that are so near to it are at the peak

Marks marks_of(const MeasuredTest& test, const Curves& curves)
{
  Marks marks;
  if (const auto* tau = curve_of(test, curves, Compared::tau); tau != nullptr && !element::drained(test.settings.kind))
    for (const Real t : *tau) marks.s_u = std::isfinite(t) ? std::fmax(marks.s_u, std::abs(t)) : marks.s_u;
  const auto* q = curve_of(test, curves, Compared::q);
  if (q == nullptr) return marks;
  const bool drained = element::drained(test.settings.kind);
  const auto lateral = [&](std::size_t row) {
    return test.held.empty() ? element::start_of(test.settings.kind).horizontal() : test.held[row];
  };
  const auto size = [&](std::size_t row) {
    const Real vertical = lateral(row) + (*q)[row];
    return drained ? std::max(vertical, lateral(row)) / std::max(std::min(vertical, lateral(row)), Real(1)) : std::abs((*q)[row]);
  };
  std::size_t first = 0;
  while (first < test.rows() && !std::isfinite((*q)[first])) ++first;
  if (first == test.rows()) return marks;
  std::size_t peak = first, most = first;
  for (std::size_t row = first + 1; row < test.rows(); ++row) {
    if (!std::isfinite((*q)[row])) continue;
    if (size(row) > size(peak)) peak = row;
    if (std::abs((*q)[row]) > std::abs((*q)[most])) most = row;
  }
  std::vector<std::size_t> at_peak;  // of a plateau the middle
  for (std::size_t row = 0; row < test.rows(); ++row)
    if (size(row) >= (1 - plateau) * size(peak)) at_peak.push_back(row);
  peak = at_peak[at_peak.size() / 2];
  marks.E50 = secant(test.driven, *q, ((*q)[most] - (*q)[first]) / 2);
  if (!drained) {
    marks.s_u = std::abs((*q)[most]) / 2;
    return marks;
  }
  const Real ratio = size(peak);
  marks.friction_angle_peak = std::asin(std::clamp((ratio - 1) / (ratio + 1), Real(-1), Real(1)));
  constexpr Real reach = 0.01;
  const auto* volume = curve_of(test, curves, Compared::volumetric_strain);
  if (volume == nullptr || !std::holds_alternative<element::Triaxial>(test.settings.kind)) return marks;
  const Real s = slope_about(test.driven, *volume, peak, reach);
  marks.dilation_angle_peak = std::asin(std::clamp(-s / (2 - element::sense(test.settings.kind) * s), Real(-1), Real(1)));
  return marks;
}

}  // namespace

Marks marks_measured(const FittedTest& test)
{
  Curves curves;
  for (const MeasuredCurve& curve : test.measured.curves) curves.push_back(&curve.values);
  return marks_of(test.measured, curves);
}

Marks marks_computed(const FittedTest& test)
{
  Curves curves;
  for (const std::vector<Real>& values : test.computed) curves.push_back(&values);
  return marks_of(test.measured, curves);
}

}  // namespace berm::soil_fit
