// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/mechanism.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

constexpr Real D = 0.02, side = 0.001;

/// Soil from x = -5 D to 5 D and D deep, in squares of D/20; its strain since the frame before and its rise are given.
template <class Strain, class Rise>
run_folder::SavedSoil soil(const Strain& strain, const Rise& rise, Real shift = 0)
{
  run_folder::SavedSoil made;
  made.fields = {{{"incremental_deviatoric_strain", "", ""}, {}}};
  for (int row = 0; row < 20; ++row)
    for (int column = -100; column < 100; ++column) {
      const Real x = (column + 0.5) * side, y = -(row + 0.5) * side;
      made.x.push_back(static_cast<float>(x + shift));
      made.y.push_back(static_cast<float>(y + rise(x)));
      made.volume.push_back(static_cast<float>(side * side));
      made.fields[0].values.push_back(static_cast<float>(strain(x, y)));
    }
  return made;
}

const auto nothing = [](Real, Real) { return 0.; };
const auto flat = [](Real) { return 0.; };

TEST(Mechanism, heave_is_the_rise_of_the_surface_on_either_side)
{
  const run_folder::SavedSoil start = soil(nothing, flat);
  const run_folder::SavedSoil now = soil(nothing, [](Real x) { return x < 0 ? 0.1 * D : 0.2 * D; });
  const Heave heave = heave_of(start, now, 0, {0, 0, 0}, D);
  EXPECT_NEAR(heave.behind, 0.1 * D, 1e-3 * D);
  EXPECT_NEAR(heave.ahead, 0.2 * D, 1e-3 * D);
  EXPECT_NEAR(heave.berm, 0.2 * D * 5 * D, 1e-2 * D * D);
}

TEST(Mechanism, a_flat_bed_has_no_heave_whatever_its_lattice)
{
  const run_folder::SavedSoil start = soil(nothing, [](Real) { return 0.3 * side; });
  const Heave heave = heave_of(start, start, 0, {0.0003, 0, 0}, D);
  EXPECT_EQ(heave.behind, 0);
  EXPECT_EQ(heave.ahead, 0);
  EXPECT_EQ(heave.berm, 0);
}

TEST(Mechanism, remoulded_clay_is_that_beyond_the_limit_and_its_depth_counts_from_the_invert)
{
  run_folder::SavedSoil now = soil([](Real x, Real y) { return std::abs(x) < 2 * D && y > -0.6 * D ? 5. : 1.; }, flat);
  now.fields[0].info.name = "plastic_shear";
  const RemouldedClay clay = remoulded_clay(now, 4, -0.2 * D, {0, 0, 0.2 * D}, D);
  EXPECT_NEAR(clay.area, 4 * D * 0.6 * D, 1e-6 * D * D);
  EXPECT_NEAR(clay.depth, 0.4 * D, side);
  const RemouldedClay none = remoulded_clay(now, 6, -0.2 * D, {0, 0, 0.2 * D}, D);
  EXPECT_EQ(none.area, 0);
  EXPECT_EQ(none.depth, 0);
}

TEST(Mechanism, the_berm_is_the_highest_soil_ahead_whichever_way_the_pipe_goes)
{
  const run_folder::SavedSoil start = soil(nothing, flat);
  const run_folder::SavedSoil now = soil(nothing, [](Real x) {
    return x > 1.2 * D && x < 1.6 * D ? 0.4 * D : x < -0.5 * D && x > -D ? 0.3 * D : 0;
  });
  const Berm ahead = berm_of(start, now, 0, {0, 0, 0}, 1, D), back = berm_of(start, now, 0, {0, 0, 0}, -1, D);
  EXPECT_NEAR(ahead.height, 0.4 * D, 1e-3 * D);
  EXPECT_GT(ahead.distance, 1.2 * D);
  EXPECT_LT(ahead.distance, 1.6 * D);
  EXPECT_NEAR(back.height, 0.3 * D, 1e-3 * D);
  EXPECT_GT(back.distance, 0.5 * D);
  EXPECT_LT(back.distance, D);
  EXPECT_EQ(berm_of(start, start, 0, {0, 0, 0}, 1, D).height, 0);
}

TEST(Mechanism, shearing_is_shared_out_by_the_side_of_the_pipes_centre)
{
  const run_folder::SavedSoil before = soil(nothing, flat);
  const auto strain = [](Real x, Real) { return x > -0.5 * D && x < 0 ? 0.1 : x >= 0 && x < 1.5 * D ? 0.1 : 0; };
  const Mechanism m = mechanism_of(before, soil(strain, flat), 0, {0, 0, 0}, {0, 0, 0}, D);
  EXPECT_NEAR(m.behind, 0.25, 1e-6);
  EXPECT_NEAR(m.reach, 0.9 * 1.5 * D, side);
}

TEST(Mechanism, a_little_shaking_of_all_soil_does_not_count)
{
  const run_folder::SavedSoil before = soil(nothing, flat);
  const auto strain = [](Real x, Real) { return x >= 0 && x < D ? 0.1 : 0.005; };
  EXPECT_EQ(mechanism_of(before, soil(strain, flat), 0, {0, 0, 0}, {0, 0, 0}, D).behind, 0);
}

TEST(Mechanism, heaped_soil_that_moves_with_the_pipe_is_dragged)
{
  const auto heap = [](Real x) { return x > 0 && x < D ? 0.25 * D : 0.; };
  const run_folder::SavedSoil before = soil(nothing, heap), along = soil(nothing, heap, 0.05 * D);
  EXPECT_NEAR(mechanism_of(before, along, 0, {0, 0, 0}, {0.1 * D, 0, 0}, D).dragged, 1, 1e-6);
  EXPECT_NEAR(mechanism_of(before, before, 0, {0, 0, 0}, {0.1 * D, 0, 0}, D).dragged, 0, 1e-6);
}

}  // namespace
}  // namespace berm::driven::this_file
