// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/foundation_test.cpp
#include "envelope/foundation.hpp"

#include "fit/least_squares.hpp"
#include "io/revision.hpp"
#include "os/error.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::envelope {
namespace {

using Unknowns = Eigen::VectorXd;  // log H_max, log M_max, atanh cross, logit b1 and b2
constexpr int unknowns = 5;

Real between_0_and_1(Real x)
{
  return 1 / (1 + std::exp(-x));
}

Foundation with(Foundation f, const Unknowns& x)
{
  f.H_max = std::exp(x[0]), f.M_max = std::exp(x[1]), f.cross = std::tanh(x[2]);
  f.b1 = between_0_and_1(x[3]), f.b2 = between_0_and_1(x[4]);
  return f;
}

/// How far a load is from the yield surface.
Real distance(const Foundation& f, const EnvelopePoint& load)
{
  constexpr Real least = 1e-9;
  const Real s = std::clamp((load.V / f.V_max + f.tension) / (1 + f.tension), least, 1 - least), peak = f.b1 / (f.b1 + f.b2);
  const Real h = load.H / f.H_max, m = load.M / f.M_max;
  return std::sqrt(std::max<Real>(0, h * h + m * m - 2 * f.cross * h * m)) -
         std::pow(s / peak, f.b1) * std::pow((1 - s) / (1 - peak), f.b2);
}

[[noreturn]] void refuse(const char* why)
{
  throw RunError(fmt::format("no macro-element of the footing: {}", why));
}

/// V over w of all probes that go down; H and M over u and theta.
void fit_stiffness(Foundation& f, const std::vector<EnvelopeRow>& rows, Real width)
{
  Real V_w = 0, w_w = 0;
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  bool turns = false;
  for (const EnvelopeRow& row : rows) {
    if (row.probe.kind == ProbeKind::swipe || !row.result.first) continue;  // a swipe begins on the surface
    const FirstMotion& m = *row.result.first;
    const Real turn = width * m.theta, length = m.w * m.w + m.u * m.u + turn * turn;
    if (m.w < std::abs(turn) / 2 || !(length > 0)) continue;
    turns = turns || turn != 0;
    V_w += m.load.V * m.w / length, w_w += m.w * m.w / length;
    const Eigen::Vector3d h(m.u, turn, 0), t(0, m.u, turn);  // of k_h, k_hm / D, k_m / D^2
    A += (h * h.transpose() + t * t.transpose()) / length;
    b += (h * m.load.H + t * m.load.M / width) / length;
  }
  if (!turns) refuse("no probe rotates it while both its edges move down: take --turns 3 or more");
  const Eigen::Vector3d k = A.ldlt().solve(b);
  f.k_v = V_w / w_w, f.k_h = k[0], f.k_hm = k[1] * width, f.k_m = k[2] * width * width;
  if (!(f.k_v > 0 && f.k_h > 0 && f.k_m > 0 && f.k_hm * f.k_hm < f.k_h * f.k_m))
    refuse("the first rows of the probes give no positive stiffness: write more rows of history at the start");
}

}  // namespace

Foundation fit_foundation(const std::vector<EnvelopeRow>& rows, Real width)
{
  const EnvelopeExtremes extremes = extremes_of(rows);
  for (const EnvelopeRow& row : rows)
    if (row.state != "finished") refuse("a probe is not finished");
  if (!(extremes.V_max > 0 && extremes.H_max > 0 && extremes.M_max > 0 && rows.size() > unknowns)) refuse("too few probes for V, H and M");
  Foundation f;
  f.V_max = extremes.V_max;
  fit_stiffness(f, rows, width);
  std::vector<EnvelopePoint> ends;
  for (const EnvelopeRow& row : rows) {
    ends.push_back(row.result.end);
    f.tension = std::max(f.tension, -row.result.end.V / f.V_max);
    if (row.probe.angle == 90 && row.result.first && row.result.growth > 0) {
      const Real slope = row.result.growth * f.V_max / (last_part * row.result.travel);
      if (slope < f.k_v) f.hardening = slope / (1 - slope / f.k_v);
    }
  }
  const auto distances = [&](const Unknowns& x, Eigen::VectorXd& left) {
    const Foundation tried = with(f, x);
    for (std::size_t k = 0; k < ends.size(); ++k) left[static_cast<Eigen::Index>(k)] = distance(tried, ends[k]);
  };
  Unknowns x(unknowns);
  x << std::log(extremes.H_max), std::log(extremes.M_max), 0, 0, 0;
  f.ends = static_cast<int>(ends.size());
  f = with(f, fit::least_squares(distances, x, f.ends).unknowns);
  for (const EnvelopeRow& row : rows) {
    const Real d = distance(f, row.result.end);
    f.rms += d * d / f.ends;
    if (std::abs(d) >= std::abs(f.largest)) f.largest = d, f.farthest = row.probe.name;
  }
  f.rms = std::sqrt(f.rms);
  if (!std::isfinite(f.rms)) refuse("its surface cannot be fitted to the ends of the probes");
  return f;
}

std::string foundation_properties(const Foundation& f, int force_dimension)
{
  const bool plane = force_dimension == 2;
  std::string text =
      fmt::format("# Properties of a footing for redwin.so, by berm {}.\n"
                  "# Yield surface fitted to {} ends of probes: {:.1f} % rms, {:.1f} % at most ({}). Fields and axes: redwin.c.\n",
                  io::version_words(), f.ends, 100 * f.rms, 100 * std::abs(f.largest), f.farthest);
  const auto line = [&](const char* name, Real value, const char* words) {
    text += fmt::format("{:<21} {:<24.17g} # {}\n", name, value, words);
  };
  line("length", 1, plane ? "m of the strip: all forces are multiplied by it" : "forces of the whole footing");
  line("vertical_stiffness", f.k_v, "N/m");
  line("horizontal_stiffness", f.k_h, "N/m");
  line("coupling_stiffness", f.k_hm, "N, H per rotation");
  line("rotational_stiffness", f.k_m, "N m");
  line("torsional_stiffness", f.k_m, "N m, not computed: a disk on elastic soil without change of volume has as much as in rotation");
  line("V_max", f.V_max, "N");
  line("H_max", f.H_max, "N");
  line("M_max", f.M_max, "N m");
  line("cross", f.cross, "of H and M");
  line("tension", f.tension, "over V_max");
  line("b1", f.b1, "");
  line("b2", f.b2, "");
  line("hardening", f.hardening, "N/m, V_max per plastic settlement");
  return text;
}

}  // namespace berm::envelope
