// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/footing.hpp"

namespace berm::formulas {
namespace {

/// ln N_q, with tan(pi/4 + phi/2) = exp(asinh(tan phi)).
Real log_n_q(Real friction_angle)
{
  const Real t = std::tan(friction_angle);
  return pi * t + 2 * std::asinh(t);
}

bool is_friction_angle(Real phi)
{
  return phi >= 0 && phi < pi / 2;
}

}  // namespace

Formula n_q(Real friction_angle)
{
  constexpr Source source{Label::exact, "Reissner 1924", "0 <= phi < 90 deg"};
  return formula(std::exp(log_n_q(friction_angle)), source, is_friction_angle(friction_angle));
}

Formula n_c(Real friction_angle)
{
  constexpr Source source{Label::exact, "Prandtl 1921", "0 <= phi < 90 deg"};
  const Real t = std::tan(friction_angle);
  const Real value = t == 0 ? 2 + pi : std::expm1(log_n_q(friction_angle)) / t;
  return formula(value, source, is_friction_angle(friction_angle));
}

Formula n_gamma(Real friction_angle, Base base)
{
  constexpr Source source{Label::exact, "characteristics, associated soil, table at 30 and 35 deg", "30 <= phi <= 35 deg"};
  const Real at_30 = base == Base::rough ? 14.754 : 7.653, at_35 = base == Base::rough ? 34.476 : 17.577;
  const Real part = (friction_angle / degree - 30) / 5;
  return formula(at_30 * std::pow(at_35 / at_30, part), source, within(friction_angle, 30 * degree, 35 * degree));
}

namespace {

constexpr const char* code_range = "15 <= phi <= 50 deg";

bool is_of_codes(Real friction_angle)
{
  return within(friction_angle, 15 * degree, 50 * degree);
}

}  // namespace

Formula n_gamma_hansen(Real friction_angle)
{
  constexpr Source source{Label::fit, "Brinch Hansen 1970", code_range};
  return formula(1.5 * std::expm1(log_n_q(friction_angle)) * std::tan(friction_angle), source, is_of_codes(friction_angle));
}

Formula n_gamma_vesic(Real friction_angle)
{
  constexpr Source source{Label::fit, "Vesic 1973", code_range};
  return formula(2 * (std::exp(log_n_q(friction_angle)) + 1) * std::tan(friction_angle), source, is_of_codes(friction_angle));
}

}  // namespace berm::formulas
