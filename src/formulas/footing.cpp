// SPDX-License-Identifier: BSD-3-Clause
#include "formulas/footing.hpp"

#include <array>

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

namespace {

/// The straight line through the entries beside x, and beyond the ends that of the last two.
template <std::size_t n>
Real in_table(const std::array<Real, n>& x, const std::array<Real, n>& y, Real at)
{
  std::size_t k = 0;
  while (k + 2 < n && at > x[k + 1]) ++k;
  return y[k] + (at - x[k]) * (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
}

constexpr std::array growths{0., 1., 2., 4., 8.};

Formula with_growth(Real growth, const std::array<Real, 5>& factors, const char* work)
{
  std::array<Real, 5> logs{};
  for (std::size_t k = 0; k < growths.size(); ++k) logs[k] = std::log1p(growths[k]);
  return formula(in_table(logs, factors, std::log1p(growth)), {Label::exact, work, "at the surface, 0 <= kD/s_u0 <= 8"},
                 within(growth, 0, growths.back()));
}

}  // namespace

Formula n_c_circle(Real kD_over_strength, Base base)
{
  constexpr std::array smooth{5.689, 6.246, 6.724, 7.557, 8.994}, rough{6.048, 6.945, 7.643, 8.742, 10.56};
  return with_growth(kD_over_strength, base == Base::rough ? rough : smooth, "characteristics, round footing");
}

Formula n_c_strip(Real kB_over_strength, Base base)
{
  constexpr std::array smooth{2 + pi, 5.982, 6.661, 7.819, 9.782}, rough{2 + pi, 6.609, 7.596, 9.128, 11.58};
  return with_growth(kB_over_strength, base == Base::rough ? rough : smooth, "characteristics, strip footing");
}

Formula n_c_skempton(Real z_over_B, bool round)
{
  constexpr Source source{Label::fit, "Skempton 1951", "uniform clay, z >= 0"};
  return formula((round ? 6 : 5) * (1 + 0.2 * std::min(z_over_B, Real(2.5))), source, z_over_B >= 0);
}

Formula n_c_inclined(Real h)
{
  constexpr Source source{Label::exact, "Green 1954", "uniform clay, at the surface, 0 <= H <= B s_u"};
  return formula(1 + pi / 2 + std::acos(h) + std::sqrt(1 - h * h), source, within(h, 0, 1));
}

Formula strip_moment_on_effective_width(Real v, Real h)
{
  constexpr Source source{Label::exact, "Green's load on the effective width B - 2 M/V, a lower bound",
                          "uniform clay, at the surface, V and H that the whole width carries"};
  constexpr int halvings = 60;
  if (!(h >= 0 && h <= 1 && v >= 0)) return formula(nan, source, false);
  // The load that a width carries grows with it.
  const auto carried = [&](Real width) { return width > 0 ? width * n_c_inclined(std::min(Real(1), h / width)).value : 0; };
  Real low = h, high = 1;
  if (carried(low) >= v) high = low;
  for (int k = 0; k < halvings; ++k) {
    const Real middle = (low + high) / 2;
    (carried(middle) < v ? low : high) = middle;
  }
  return formula(v * (1 - high) / 2, source, v <= carried(1) * (1 + 1e-9));
}

Formula strip_moment_of_arc()
{
  constexpr Source source{Label::exact, "circular arc through both edges, an upper bound",
                          "uniform clay, at the surface, V = H = 0, full tension at the base"};
  constexpr Real half_angle = 1.16556118520721;  // tan a = 2 a
  const Real sine = std::sin(half_angle);
  return formula(half_angle / (2 * sine * sine), source, true);
}

Formula n_gamma_circle(Real friction_angle, Base base)
{
  constexpr Source source{Label::exact, "characteristics, round footing, associated soil", "20 <= phi <= 35 deg, psi = phi"};
  constexpr std::array angles{20., 30., 35.};
  const std::array<Real, 3> logs = base == Base::rough ? std::array{std::log(2.416), std::log(15.53), std::log(41.88)}
                                                       : std::array{std::log(1.271), std::log(7.11), std::log(18.03)};
  return formula(std::exp(in_table(angles, logs, friction_angle / degree)), source, within(friction_angle, 20 * degree, 35 * degree));
}

}  // namespace berm::formulas
