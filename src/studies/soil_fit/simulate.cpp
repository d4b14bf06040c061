// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/fit_soil_test.cpp
#include "soil_fit/simulate.hpp"

#include "element/course.hpp"
#include "element/run_test.hpp"

#include <algorithm>

namespace berm::soil_fit {
namespace {

constexpr Real stress_step = 0.05;  // of the logarithm of the stress, in tests by their stress

Real value_of(const element::TestSettings& settings, Compared what, const element::TestRow& row)
{
  switch (what) {
  case Compared::q:
    return element::deviator_stress(row);
  case Compared::tau:
    return element::shear_stress(row);
  case Compared::p:
    return element::mean_stress(row);
  case Compared::vertical_stress:
    return element::vertical_stress(row);
  case Compared::volumetric_strain:
    return element::volumetric_strain(row);
  case Compared::axial_strain:
    return element::driven_strain(settings, row);
  case Compared::resistance:  // of penetrometers, which drive no specimen
    break;
  }
  return nan;
}

constexpr int most_halvings = 8;

/// One step by a driven strain to a held stress, in smaller ones where the law has no state at its end; false where it has none then either.
bool go_step(element::Course& course, Real driven, Real from, Real to, int halvings = 0)
{
  if (course.step(driven, to)) return true;
  if (halvings == most_halvings) return false;
  const Real middle = (from + to) / 2;
  return go_step(course, driven / 2, from, middle, halvings + 1) && go_step(course, driven / 2, middle, to, halvings + 1);
}

/// Goes from one row to the next; false where the law has no state there.
bool go(element::Course& course, const MeasuredTest& test, std::size_t row, Real largest_step)
{
  const Real from = test.driven[row - 1], to = test.driven[row];
  if (test.by_stress()) {
    const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(std::log(to / from)) / stress_step)));
    const auto stress = [&](int n) { return -from * std::pow(to / from, static_cast<Real>(n) / steps); };
    for (int n = 1; n <= steps; ++n)
      if (!go_step(course, 0, stress(n - 1), stress(n))) return false;
    return true;
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / largest_step)));
  const Real start = course.held_stress(), end = test.held.empty() ? start : -test.held[row];
  const auto stress = [&](int n) { return start + n * (end - start) / steps; };
  for (int n = 1; n <= steps; ++n)
    if (!go_step(course, (to - from) / steps, stress(n - 1), stress(n))) return false;
  return true;
}

}  // namespace

std::vector<std::vector<Real>> simulate(const MeasuredTest& test, const material::Material& material, Real largest_step)
{
  std::vector<std::vector<Real>> values(test.curves.size(), std::vector<Real>(test.rows(), nan));
  element::Course course(test.settings, material);
  for (std::size_t row = 0; row < test.rows(); ++row) {
    if (row > 0 && !go(course, test, row, largest_step)) break;
    const element::TestRow now{0, 0, course.specimen().strain(), course.specimen().stress(), {}};
    for (std::size_t k = 0; k < test.curves.size(); ++k) values[k][row] = value_of(test.settings, test.curves[k].what, now);
  }
  return values;
}

}  // namespace berm::soil_fit
