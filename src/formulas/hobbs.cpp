// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/hobbs.hpp"

#include <algorithm>

namespace berm::formulas {
namespace {

struct HobbsConstants {
  Real force, feed_in, half_length, amplitude, moment;
};
constexpr HobbsConstants of_modes[] = {{80.76, 6.391e-5, 0.5, 2.407e-3, 0.06938},
                                       {4 * pi * pi, 1.743e-4, 1, 5.532e-3, 0.1088},
                                       {34.06, 1.668e-4, 1.294, 1.032e-2, 0.1434},
                                       {28.20, 2.144e-4, 1.608, 1.047e-2, 0.1483}};

constexpr int halvings = 100;

/// The compression at which the constrained force is smallest, by thirds between two that hold it; it has one minimum over the logarithm of P.
Real weakest(HobbsMode mode, const HotLine& line, Real low, Real high)
{
  const auto force = [&](Real log_P) { return hobbs_buckle(mode, line, std::exp(log_P)).constrained_force; };
  Real a = std::log(low), b = std::log(high);
  for (int k = 0; k < halvings; ++k) {
    const Real third = (b - a) / 3;
    if (force(a + third) < force(b - third))
      b -= third;
    else
      a += third;
  }
  return std::exp((a + b) / 2);
}

}  // namespace

Source hobbs_source()
{
  return {Label::exact, "Hobbs 1984", "EI, EA, h, f > 0; slopes below 0.1; a line that is longer than its slip"};
}

HobbsBuckle hobbs_buckle(HobbsMode mode, const HotLine& line, Real P)
{
  const auto& [EI, EA, h, f] = line;
  if (!(EI > 0 && EA > 0 && h > 0 && f > 0 && P > 0)) return {};
  const HobbsConstants& k = of_modes[static_cast<int>(mode)];
  const Real L = std::sqrt(k.force * EI / P);
  const Real missing = k.half_length * f * L * (std::sqrt(1 + k.feed_in * EA * h * h * std::pow(L, 5) / (f * EI * EI)) - 1);
  return {.lobe = L,
          .half_length = k.half_length * L,
          .amplitude = k.amplitude * h * std::pow(L, 4) / EI,
          .moment = k.moment * h * L * L,
          .compression = P,
          .constrained_force = P + missing,
          .slip_length = k.half_length * L + missing / f};
}

Real hobbs_smallest_force(HobbsMode mode, const HotLine& line)
{
  const Real EA = line.axial_stiffness;  // compression in a buckle is a small part of it
  if (std::isnan(hobbs_buckle(mode, line, EA).lobe)) return nan;
  return hobbs_buckle(mode, line, weakest(mode, line, 1e-9 * EA, EA)).constrained_force;
}

HobbsBuckle hobbs_buckle_at(HobbsMode mode, const HotLine& line, Real P0)
{
  // A buckle carries less than P0; one with a millionth of it is longer than any.
  Real low = 1e-6 * P0, high = P0;
  if (std::isnan(hobbs_buckle(mode, line, P0).lobe)) return {};
  high = weakest(mode, line, low, high);
  if (hobbs_buckle(mode, line, high).constrained_force > P0 || hobbs_buckle(mode, line, low).constrained_force < P0) return {};
  for (int k = 0; k < halvings; ++k) {
    const Real middle = std::sqrt(low * high);
    (hobbs_buckle(mode, line, middle).constrained_force > P0 ? low : high) = middle;
  }
  return hobbs_buckle(mode, line, std::sqrt(low * high));
}

}  // namespace berm::formulas
