// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/loaded_law.hpp"

#include "material/linear_elastic.hpp"
#include "material/tangent.hpp"
#include "samples/trial_law.hpp"

#include <gtest/gtest.h>

namespace berm::user_law::this_file {
namespace {

using material::UserIncrement;
using samples::trial_law;

const material::LinearElastic elastic{.density = 2000, .inertia_density = {}, .young_modulus = 1e7, .poisson_ratio = 0.25};

material::PreparedUserLaw prepared(const LoadedLaw& law)
{
  return {elasticity(elastic), 1, &law};
}

// Equal but for round-off: the terms are added in another order. 1e-12 of the stress is some thousand times that.
constexpr Real round_off = 1e-12;

template <int dim, class A, class B>
void expect_same(const A& a, const B& b)
{
  for (int k = 0; k < tensor_size<dim>; ++k) EXPECT_NEAR(a[k], b[k], round_off * 1e5) << k;
}

TEST(LoadedLaw, that_is_elastic_gives_the_stress_of_linear_elastic)
{
  const LoadedLaw law = trial_law("berm_law");
  const material::Increment<3, Real> increment{{{1e-3, -2e-3, 5e-4, 3e-4, -7e-4, 2e-4}}, 0.1};
  SymTensor<3> own{{-1e4, -2e4, -1e4, 1e3, 2e3, 3e3}}, built_in = own;
  Real calls = 0, *none_kept = nullptr;
  update(prepared(law), own, increment, &calls);
  update(prepare(elastic), built_in, increment, none_kept);
  expect_same<3>(own, built_in);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(law.failure(), "");
}

TEST(LoadedLaw, is_called_for_active_lanes_only)
{
  const LoadedLaw law = trial_law("berm_law");
  SymTensor<2, Lanes> own{}, built_in{};
  material::Increment<2, Lanes> increment{{}, 0.1};
  for (int k = 0; k < 4; ++k) increment.strain[k] = Lanes{1e-3, 2e-3, -1e-3, 4e-3} * (k + 1.);
  increment.active = lane_numbers < all_lanes(3);
  Lanes calls = {5, 6, 7, 8};
  update(prepared(law), own, increment, &calls);
  update(prepare(elastic), built_in, increment, static_cast<Lanes*>(nullptr));
  for (int l = 0; l < 3; ++l)
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(own[k][l], built_in[k][l], round_off * 1e5);
  EXPECT_EQ(own[0][3], 0);
  for (int l = 0; l < 4; ++l) EXPECT_EQ(calls[l], 5 + l + (l < 3 ? 1 : 0));
}

TEST(LoadedLaw, without_a_tangent_of_its_own_gets_that_of_differences)
{
  const LoadedLaw law = trial_law("berm_law");
  SymTensor<2> own{{-1e4, -2e4, -1e4, 1e3}}, built_in = own;
  Real calls = 0;
  material::Tangent tangent, expected;
  const material::Increment<2, Real> increment{{{1e-3, -2e-3, 0, 3e-4}}, 0.1};
  update_stress_and_tangent(prepared(law), own, increment, &calls, tangent);
  update_stress_and_tangent(prepare(elastic), built_in, increment, nullptr, expected);
  expect_same<2>(own, built_in);
  EXPECT_EQ(calls, 1);  // the state is not that of the differences
  // Round-off of 2e-12 Pa in the stress over a step of 2e-7 is 1e-12 of E.
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(tangent(i, j), expected(i, j), 1e-9 * 1e7) << i << j;
}

TEST(LoadedLaw, that_asks_for_smaller_increments_gets_halves)
{
  const LoadedLaw patient = trial_law("patient"), law = trial_law("berm_law");
  UserIncrement increment;
  increment.dt = 1;
  increment.time = 2;
  increment.strain[1] = -3.5e-3;
  increment.state[0] = 0;
  UserIncrement whole = increment;
  patient.advance(increment);
  law.advance(whole);
  EXPECT_EQ(increment.state[0], 4);
  expect_same<3>(increment.stress, whole.stress);
  EXPECT_EQ(increment.strain[1], -3.5e-3);
  EXPECT_EQ(increment.dt, 1);
  EXPECT_EQ(increment.time, 2);
}

TEST(LoadedLaw, that_is_never_content_fails_by_name_after_ten_halvings)
{
  const LoadedLaw law = trial_law("never_content");
  UserIncrement increment;
  increment.strain[1] = -3.5e-3;
  increment.state[0] = 3;
  law.advance(increment);
  EXPECT_TRUE(std::isnan(increment.stress[0]));
  EXPECT_EQ(law.failure().find("the law never_content still asks for a smaller increment after ten halvings"), 0u) << law.failure();
  EXPECT_NE(law.failure().find("(0, -0.0035, 0, 0, 0, 0)"), std::string::npos) << law.failure();
  EXPECT_NE(law.failure().find("state variables before: 3"), std::string::npos) << law.failure();
  law.forget_failure();
  EXPECT_EQ(law.failure(), "");
}

TEST(LoadedLaw, tells_of_the_first_stress_that_is_not_a_number)
{
  const LoadedLaw law = trial_law("not_a_number");
  UserIncrement increment;
  increment.state[0] = 0;
  law.advance(increment);
  EXPECT_EQ(law.failure(), "");
  increment.time = 0.2;
  law.advance(increment);
  EXPECT_NE(law.failure().find("not a number or infinite"), std::string::npos);
  EXPECT_NE(law.failure().find("t = 0.2 s"), std::string::npos) << law.failure();
}

TEST(LoadedLaw, may_say_that_it_failed)
{
  const LoadedLaw law = trial_law("fails");
  UserIncrement increment;
  increment.state[0] = 0;
  law.advance(increment);
  EXPECT_NE(law.failure().find("reports failure"), std::string::npos);
}

}  // namespace
}  // namespace berm::user_law::this_file
