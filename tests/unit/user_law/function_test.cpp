// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/function.hpp"

#include <gtest/gtest.h>

namespace berm::user_law::this_file {
namespace {

using material::UserIncrement;

UserIncrement numbered(int dimension)
{
  UserIncrement increment;
  increment.dimension = dimension;
  increment.dt = 0.5;
  increment.time = 3;
  for (int k = 0; k < (dimension == 2 ? 4 : 6); ++k) {
    increment.strain[k] = k + 1;
    increment.stress[k] = 10 * (k + 1);
  }
  increment.state[0] = 7;
  increment.with_tangent = true;
  return increment;
}

const Constants constants{"soft clay", {2, 3}, 1};

berm_law_increment seen;

extern "C" int look(berm_law_increment* increment)
{
  seen = *increment;
  increment->stress[4] = 99;
  increment->state[0] = 8;
  if (increment->tangent != nullptr) {
    increment->tangent[6 * 1 + 2] = 12;
    increment->tangent_given = 1;
  }
  return berm_law_done;
}

extern "C" int refuse(berm_law_increment*)
{
  return berm_law_failed;
}

TEST(OwnFunction, receives_the_increment_and_what_the_input_says)
{
  UserIncrement increment = numbered(3);
  bool given = false;
  EXPECT_EQ(call(look, constants, increment, given), Answer::done);
  EXPECT_EQ(seen.version, BERM_LAW_VERSION);
  EXPECT_EQ(seen.dimension, 3);
  EXPECT_STREQ(seen.material, "soft clay");
  EXPECT_EQ(seen.property_count, 2);
  EXPECT_EQ(seen.properties[1], 3);
  EXPECT_EQ(seen.dt, 0.5);
  EXPECT_EQ(seen.time, 3);
  EXPECT_EQ(seen.strain[5], 6);
  EXPECT_EQ(seen.stress[4], 50);
  EXPECT_EQ(seen.state_count, 1);
  EXPECT_EQ(increment.stress[4], 99);
  EXPECT_EQ(increment.stress[5], 60);
  EXPECT_EQ(increment.state[0], 8);
  EXPECT_TRUE(given);
  EXPECT_EQ(increment.tangent[6 * 1 + 2], 12);
}

TEST(OwnFunction, has_no_room_for_a_tangent_that_is_not_wanted)
{
  UserIncrement increment = numbered(2);
  increment.with_tangent = false;
  bool given = true;
  call(look, constants, increment, given);
  EXPECT_EQ(seen.tangent, nullptr);
  EXPECT_FALSE(given);
}

TEST(OwnFunction, may_fail)
{
  UserIncrement increment = numbered(2);
  bool given = false;
  EXPECT_EQ(call(refuse, constants, increment, given), Answer::failed);
}

/// What the UMAT below saw.
struct SeenByUmat {
  std::vector<double> stress, strain;
  std::string name;
  int normal = 0, shear = 0, size = 0, state = 0, properties = 0, step = 0, increment = 0;
  double time[2] = {}, turn[9] = {}, total = 0;
} umat_saw;

/// Answers with numbers that tell their places: stress 11 ... 23 becomes 1 ... 6, and DDSDDE(a, b) 10 a + b, from 1.
extern "C" void umat(double* stress, double* statev, double* ddsdde, double*, double*, double*, double*, double*, double*, double*,
                     const double* stran, const double* dstran, const double* time, const double*, const double*, const double*,
                     const double*, const double*, const char* cmname, const int* ndi, const int* nshr, const int* ntens, const int* nstatv,
                     const double*, const int* nprops, const double*, const double* drot, double* pnewdt, const double*, const double*,
                     const double*, const int*, const int*, const int*, const int*, const int* kstep, const int* kinc, std::size_t length)
{
  umat_saw.stress.assign(stress, stress + *ntens);
  umat_saw.strain.assign(dstran, dstran + *ntens);
  umat_saw.name.assign(cmname, length);
  umat_saw.normal = *ndi;
  umat_saw.shear = *nshr;
  umat_saw.size = *ntens;
  umat_saw.state = *nstatv;
  umat_saw.properties = *nprops;
  umat_saw.step = *kstep;
  umat_saw.increment = *kinc;
  std::copy_n(time, 2, umat_saw.time);
  std::copy_n(drot, 9, umat_saw.turn);
  umat_saw.total = stran[0];
  for (int a = 0; a < *ntens; ++a) {
    stress[a] = a + 1;
    for (int b = 0; b < *ntens; ++b) ddsdde[a + *ntens * b] = 10 * (a + 1) + b + 1;
  }
  statev[0] = 8;
  if (statev[0] == dstran[0]) *pnewdt = 0.5;
}

TEST(Umat, has_its_components_in_the_order_of_abaqus_in_space)
{
  UserIncrement increment = numbered(3);
  bool given = false;
  EXPECT_EQ(call(Umat{umat}, constants, increment, given), Answer::done);
  // berm's xx yy zz xy yz zx are 1 ... 6: Abaqus has 13 before 23.
  EXPECT_EQ(umat_saw.strain, (std::vector<double>{1, 2, 3, 4, 6, 5}));
  EXPECT_EQ(umat_saw.stress, (std::vector<double>{10, 20, 30, 40, 60, 50}));
  EXPECT_EQ(umat_saw.size, 6);
  EXPECT_EQ(umat_saw.shear, 3);
  EXPECT_EQ(increment.stress[4], 6);  // yz is 23, the sixth
  EXPECT_EQ(increment.stress[5], 5);
  ASSERT_TRUE(given);
  EXPECT_EQ(increment.tangent[6 * 4 + 0], 61);
  EXPECT_EQ(increment.tangent[6 * 0 + 5], 15);
}

TEST(Umat, has_four_components_in_plane_strain)
{
  UserIncrement increment = numbered(2);
  bool given = false;
  call(Umat{umat}, constants, increment, given);
  EXPECT_EQ(umat_saw.strain, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(umat_saw.normal, 3);
  EXPECT_EQ(umat_saw.shear, 1);
  EXPECT_EQ(umat_saw.size, 4);
  EXPECT_EQ(increment.tangent[6 * 3 + 1], 42);
  EXPECT_EQ(increment.state[0], 8);
}

TEST(Umat, receives_name_counts_times_and_no_rotation)
{
  UserIncrement increment = numbered(2);
  bool given = false;
  call(Umat{umat}, constants, increment, given);
  EXPECT_EQ(umat_saw.name, "soft clay" + std::string(71, ' '));
  EXPECT_EQ(umat_saw.state, 1);
  EXPECT_EQ(umat_saw.properties, 2);
  EXPECT_EQ(umat_saw.step, 1);
  EXPECT_EQ(umat_saw.increment, 2);
  EXPECT_EQ(umat_saw.time[0], 3);
  EXPECT_EQ(umat_saw.time[1], 3);
  for (int k = 0; k < 9; ++k) EXPECT_EQ(umat_saw.turn[k], k % 4 == 0 ? 1 : 0);
  EXPECT_EQ(umat_saw.total, 0);
  increment.time = 0;
  call(Umat{umat}, constants, increment, given);
  EXPECT_EQ(umat_saw.increment, 1);
}

TEST(Umat, asks_for_a_smaller_increment_by_pnewdt)
{
  UserIncrement increment = numbered(2);
  increment.strain[0] = 8;
  bool given = false;
  EXPECT_EQ(call(Umat{umat}, constants, increment, given), Answer::smaller);
}

}  // namespace
}  // namespace berm::user_law::this_file
