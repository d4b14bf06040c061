// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/cone.hpp"

#include <algorithm>
#include <cmath>

namespace berm::formulas {
namespace {

constexpr Real p_a = 100e3;

/// I_c at an exponent n.
Real index_at(Real n, Real net, Real F_r, Real effective_stress)
{
  const Real Q_tn = net / p_a * std::pow(p_a / effective_stress, n);
  return std::hypot(3.47 - std::log10(Q_tn), std::log10(100 * F_r) + 1.22);
}

}  // namespace

SoilBehaviour soil_behaviour(Real q_t, Real f_s, Real sigma_v0, Real effective_stress)
{
  constexpr Source source{Label::fit, "Robertson 2009", "q_t > sigma_v0, f_s > 0, sigma'_v0 > 0"};
  const Real net = q_t - sigma_v0;
  if (!(net > 0 && f_s > 0 && effective_stress > 0)) return {nan, nan, nan, formula(nan, source, false)};
  const Real F_r = f_s / net;
  const auto excess = [&](Real n) {
    return std::min(0.381 * index_at(n, net, F_r, effective_stress) + 0.05 * effective_stress / p_a - 0.15, Real(1)) - n;
  };
  // By halves: repeated substitution need not converge at low stresses.
  Real low = -1, high = 1;
  for (int k = 0; k < 60; ++k) (excess((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
  const Real n = excess(1) >= 0 ? 1 : (low + high) / 2;
  return {net / p_a * std::pow(p_a / effective_stress, n), F_r, n, formula(index_at(n, net, F_r, effective_stress), source, true)};
}

int zone_of(Real I_c)
{
  return 7 - static_cast<int>(std::upper_bound(std::begin(zone_ends), std::end(zone_ends), I_c) - std::begin(zone_ends));
}

const char* name_of_zone(int zone)
{
  constexpr const char* names[] = {"organic soil and peat", "clay", "silt mixture", "sand mixture", "sand", "dense to gravelly sand"};
  return names[std::clamp(zone, 2, 7) - 2];
}

Formula cone_unit_weight(Real q_t, Real f_s, Real gamma_w)
{
  constexpr Source source{Label::fit, "Robertson and Cabal 2010", "q_t > 0, f_s > 0"};
  return formula(gamma_w * (0.27 * std::log10(100 * f_s / q_t) + 0.36 * std::log10(q_t / p_a) + 1.236), source, q_t > 0 && f_s > 0);
}

Formula cone_relative_density(Real q_t, Real effective_stress)
{
  constexpr Source source{Label::fit, "Jamiolkowski and others 2001", "sand of medium compressibility; 0 <= D_r <= 1"};
  const Real D_r = 0.268 * std::log(q_t / std::sqrt(effective_stress * p_a)) - 0.675;
  return formula(D_r, source, within(D_r, 0, 1));
}

Formula cone_modulus(Real I_c, Real net_resistance)
{
  constexpr Source source{Label::fit, "Robertson 2009", "I_c < 2.60, q_t > sigma_v0"};
  return formula(0.015 * std::pow(10, 0.55 * I_c + 1.68) * net_resistance, source, I_c < end_of_sand && net_resistance > 0);
}

}  // namespace berm::formulas
