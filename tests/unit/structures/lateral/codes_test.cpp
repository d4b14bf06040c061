// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/codes.hpp"

#include "formulas/pile_lateral.hpp"
#include "samples/made_pile.hpp"
#include "structures/lateral/axial_codes.hpp"
#include "structures/lateral/code_page.hpp"

#include <gtest/gtest.h>

namespace berm::lateral::this_file {
namespace {

using formulas::ClayAtPile, formulas::Formula;

constexpr Real length = 8, height = 4;  // m

/// A method with a resistance per metre.
template <class P>
CodeMethod method_of(const P& p)
{
  return {"made", "made", "", [p](Real z, Real y) { return Formula{p(z, y), {}, true}; }, {}, {}, {}};
}

TEST(RigidPile, with_a_resistance_that_only_changes_its_sign_is_that_of_statics)
{
  // (z0 + h)^2 = (h^2 + (h + L)^2)/2, H = p (2 z0 - L), examples/lateral_pile. A slice of 40 mm turns as a whole: at its middle, 20 mm of 8 m off, 0.3 %.
  const RigidPile pile = rigid_pile(method_of([](Real, Real y) { return std::copysign(1e3, y); }), length, height, infinity);
  const Real z0 = std::sqrt((16. + 144) / 2) - 4;
  EXPECT_NEAR(pile.pivot, z0, 0.021);
  EXPECT_NEAR(pile.H / (1e3 * (2 * z0 - length)), 1, 0.003);
}

TEST(RigidPile, on_straight_springs_is_that_of_statics)
{
  // Moments about the point of load: u S1 = tilt S2, with S1, S2 the integrals of z + h and its square over the length.
  const Real k = 5e6, u = 0.1, S1 = (144. - 16) / 2, S2 = (1728. - 64) / 3, tilt = u * S1 / S2;
  const RigidPile pile = rigid_pile(method_of([=](Real, Real y) { return k * y; }), length, height, u);
  EXPECT_NEAR(pile.H, k * (u * length - tilt * S1), 1e-4 * pile.H);
  EXPECT_NEAR(pile.pivot, u / tilt - height, 1e-3);
  // Loaded at the middle of its length it does not tilt.
  EXPECT_NEAR(rigid_pile(method_of([=](Real, Real y) { return k * y; }), length, -length / 2, u).H, k * u * length, 1);
}

TEST(RigidPile, base_and_moments_along_the_shaft_hold_it_too)
{
  CodeMethod method = method_of([](Real, Real) { return 0.; });
  method.m = [](Real, Real tilt) { return Formula{2e6 * tilt, {}, true}; };
  method.base_M = [](Real tilt) { return Formula{4e6 * tilt, {}, true}; };
  method.base_H = [](Real y) { return Formula{1e6 * y, {}, true}; };
  // H (L + h) = (2 MN m/m L + 4 MN m) tilt about the point of load, H = 1 MN/m (u - (L + h) tilt).
  const Real u = 0.1, arm = length + height, tilt = u * arm * 1e6 / (2e6 * length + 4e6 + arm * arm * 1e6);
  EXPECT_NEAR(rigid_pile(method, length, height, u).H, 1e6 * (u - arm * tilt), 1);
}

TEST(RigidPile, in_the_clay_of_the_template_carries_what_a_user_found_by_hand)
{
  // Sums over 8000 slices there, 200 here: 0.5 %. Pile of 2 m, 8 m deep, s_u 30 kPa, 7.8 kN/m3, loaded 4 m above the bed.
  const auto largest = [](const auto& factor) {
    return rigid_pile(method_of([&](Real z, Real y) {
                        ClayAtPile clay;
                        clay.z = z, clay.diameter = 2, clay.length = length, clay.strength = clay.strength_at_bed = 30e3;
                        clay.overburden = 7.8e3 * z, clay.adhesion = 0.5;
                        return std::copysign(factor(clay).value * 60e3, y);
                      }),
                      length, height, infinity)
        .H;
  };
  EXPECT_NEAR(largest([](const ClayAtPile& clay) { return formulas::matlock_factor(clay); }), 506.7e3, 2.5e3);
  EXPECT_NEAR(largest([](const ClayAtPile& clay) { return formulas::matlock_factor(clay, 0.25); }), 467.1e3, 2.5e3);
  EXPECT_NEAR(largest([](const ClayAtPile& clay) { return formulas::murff_hamilton_factor(clay); }), 780.3e3, 4e3);
}

TEST(CodeMethods, of_clay_stand_beside_a_run_with_what_they_choose)
{
  const record::RunRecord record = MadePile{}.record();
  const LateralRun run(record);
  ASSERT_GT(run.strength, 0);
  const std::vector<CodeMethod> codes = code_methods(run);
  ASSERT_EQ(codes.size(), 6u);
  for (const CodeMethod& code : codes) {
    EXPECT_GT(code.p(2, 0.1).value, 0) << code.name;
    EXPECT_FALSE(code.choices.empty()) << code.name;
    const RigidPile there = rigid_pile(code, 8, 4, 0.1), most = rigid_pile(code, 8, 4, infinity);
    EXPECT_LT(there.H, most.H) << code.name;
    EXPECT_GT(there.pivot, 4);
    EXPECT_LT(there.pivot, 8);
  }
  const std::string page = code_values({run}, "pile");
  for (const char* name : {"API RP 2GEO", "DNV-RP-C212", "Jeanjean 2009", "ISO 19901-4", "Cowden", "Bothkennar"})
    EXPECT_NE(page.find(name), std::string::npos) << name;
  EXPECT_EQ(page.find("Murff"), std::string::npos) << "recalled: not for clients";
  EXPECT_EQ(code_curves(run), "") << "no slices";
}

TEST(CodeMethods, of_sand_are_apis_with_friction_on_the_shaft)
{
  record::RunRecord record = MadePile{}.record();
  material::MohrCoulomb sand = MadePush::sand();
  sand.friction_angle = 35 * degree;
  record.settings.material[0].second = sand;
  record.settings.contact[0].second.friction_angle = 25 * degree;
  const LateralRun run(record);
  const std::vector<CodeMethod> codes = code_methods(run);
  ASSERT_EQ(codes.size(), 1u);
  // 5 kN/m3, 2 m deep, D = 2 m: C1 z + C2 D = 2 (3.1 + 3.4) by the figure, A = 3 - 0.8.
  EXPECT_NEAR(codes[0].p(2, 1).value, 2.2 * 2 * 6.5 * 10e3, 0.06 * 286e3);
  EXPECT_NEAR(codes[0].p(2, -1).value, -codes[0].p(2, 1).value, 1e-6);
  const std::optional<AxialCode> axial = axial_code(run);
  ASSERT_TRUE(axial);
  EXPECT_FALSE(axial->clay);
  EXPECT_NEAR(axial->shaft_force(), 0.5 * 5e3 * 64 * std::tan(25 * degree) * 2 * pi, 1) << "K = 1, the mean over 8 m";
  EXPECT_NEAR(axial->base.value, 20 * 40e3 * pi, 1) << "N_q = 20";
}

TEST(AxialCode, sums_the_friction_over_the_shaft)
{
  const record::RunRecord record = MadePile{}.record();
  const std::optional<AxialCode> code = axial_code(LateralRun(record));
  ASSERT_TRUE(code);
  Real sum = 0;
  for (const AxialCode::Slice& slice : code->shaft) sum += slice.t.value * slice.thickness;
  EXPECT_NEAR(code->shaft_force(), sum, 1e-6);
  EXPECT_TRUE(code->closed);
  EXPECT_NEAR(code->base_share(0.2), 1, 1e-12) << "D = 2 m";
}

}  // namespace
}  // namespace berm::lateral::this_file
