// SPDX-License-Identifier: BSD-3-Clause
#include "envelope/foundation.hpp"

#include "os/error.hpp"

#include <gtest/gtest.h>

namespace berm::envelope::this_file {
namespace {

constexpr Real width = 2, V_max = 1000;

/// What the rows of a made envelope lie on.
Foundation made()
{
  Foundation f;
  f.k_v = 4e5, f.k_h = 2e5, f.k_hm = -3e4, f.k_m = 1.5e5;
  f.V_max = V_max, f.H_max = 150, f.M_max = 200, f.cross = 0.3, f.b1 = 0.6, f.b2 = 0.8;
  return f;
}

/// The load at V with H and M in the direction of an angle.
EnvelopePoint load_at(const Foundation& f, Real V, Real angle)
{
  const Real s = V / V_max, peak = f.b1 / (f.b1 + f.b2), y = std::pow(s / peak, f.b1) * std::pow((1 - s) / (1 - peak), f.b2);
  const Real h = std::cos(angle), m = std::sin(angle), r = y / std::sqrt(h * h + m * m - 2 * f.cross * h * m);
  return {V, r * h * f.H_max, 0, r * m * f.M_max};
}

FirstMotion first_of(const Foundation& f, Real w, Real u, Real theta)
{
  return {w, u, theta, {f.k_v * w, f.k_h * u + f.k_hm * theta, w, f.k_hm * u + f.k_m * theta}};
}

/// Probes that go down, sideways and turn, and whose first motions are elastic; the one that turns without going down begins softer.
std::vector<EnvelopeRow> made_rows(const Foundation& f, Real growth = 0)
{
  std::vector<EnvelopeRow> rows;
  const auto add = [&](const char* name, Real angle, Real turn, const EnvelopePoint& end, const FirstMotion& first) {
    Probe probe{name, ProbeKind::direction, angle, {}, "", turn, turn == 90};
    ProbeResult result;
    result.end = end, result.growth = angle == 90 ? growth : 0, result.travel = 0.2, result.first = first;
    rows.push_back({probe, "finished", result});
  };
  add("down", 90, 0, {V_max, 0, 0, 0}, first_of(f, 1e-4, 0, 0));
  add("direction_45", 45, 0, load_at(f, 900, 0), first_of(f, 1e-4, 1e-4, 0));
  add("direction_18", 18, 0, load_at(f, 600, 0), first_of(f, 3e-5, 1e-4, 0));
  add("turn_60", 60, 90, load_at(f, 800, pi / 2), first_of(f, 1e-4, 1e-5, 3e-5));
  add("turn_0", 0, 90, load_at(f, 450, pi / 2), {0, 1e-5, 1e-4, {2, 0, 0, 5}});
  for (const Real angle : {0.4, 0.9, 1.9, 2.6})
    add("swipe", nan, 30, load_at(f, 430, angle), first_of(f, 0, 0, 0)), rows.back().probe.kind = ProbeKind::swipe;
  return rows;
}

TEST(Foundation, is_the_surface_that_the_ends_lie_on_and_the_stiffness_of_first_motions_without_a_rising_edge)
{
  const Foundation given = made(), f = fit_foundation(made_rows(given), width);
  EXPECT_NEAR(f.k_v, given.k_v, 1e-6 * given.k_v);
  EXPECT_NEAR(f.k_h, given.k_h, 1e-6 * given.k_h);
  EXPECT_NEAR(f.k_hm, given.k_hm, 1e-6 * given.k_h);
  EXPECT_NEAR(f.k_m, given.k_m, 1e-6 * given.k_m) << "turn_0 would make it softer";
  EXPECT_NEAR(f.H_max, given.H_max, 1e-4 * given.H_max);
  EXPECT_NEAR(f.M_max, given.M_max, 1e-4 * given.M_max);
  EXPECT_NEAR(f.cross, given.cross, 1e-4);
  EXPECT_NEAR(f.b1, given.b1, 1e-3);
  EXPECT_NEAR(f.b2, given.b2, 1e-3);
  EXPECT_LT(f.rms, 1e-4);
  EXPECT_EQ(f.hardening, 0);
  EXPECT_EQ(f.ends, 9);
}

TEST(Foundation, hardens_by_the_slope_of_the_last_quarter_of_the_probe_that_goes_down)
{
  // 0.1 of V_max over a quarter of 0.2 m is V over w, of which w/k_v is elastic.
  const Real slope = 100 / 0.05;
  EXPECT_NEAR(fit_foundation(made_rows(made(), 0.1), width).hardening, 1 / (1 / slope - 1 / made().k_v), 1e-6 * slope);
}

TEST(Foundation, says_why_there_is_none)
{
  const auto refusal = [](const std::vector<EnvelopeRow>& rows) {
    try {
      fit_foundation(rows, width);
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  std::vector<EnvelopeRow> rows = made_rows(made());
  rows[2].state = "failed";
  EXPECT_NE(refusal(rows).find("not finished"), std::string::npos);
  rows = made_rows(made());
  rows.erase(rows.begin() + 3);
  EXPECT_NE(refusal(rows).find("--turns 3"), std::string::npos);
  rows = made_rows(made());
  rows.resize(4);
  EXPECT_NE(refusal(rows).find("too few probes"), std::string::npos);
  rows = made_rows(made());
  for (EnvelopeRow& row : rows)
    if (row.result.first) row.result.first->load.H *= -1;
  EXPECT_NE(refusal(rows).find("no positive stiffness"), std::string::npos);
}

}  // namespace
}  // namespace berm::envelope::this_file
