// SPDX-License-Identifier: BSD-3-Clause
#include "structures/driven/mechanism.hpp"

#include "os/error.hpp"

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

/// Finite elements from x = -5 D to 5 D and D deep, D/20 wide; corners and middles of sides rise.
template <class Rise>
run_folder::SavedSoil elements(const Rise& rise)
{
  run_folder::SavedSoil made;
  constexpr int columns = 200, width = 2 * columns + 1;
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < width; ++k) {
      const Real x = (k - columns) * side / 2;
      made.x.push_back(x), made.y.push_back((row / 2. - 1) * D + (row == 2 ? rise(x) : 0));
    }
  for (int k = 0; k < width - 1; k += 2) {
    const auto at = [&](int column, int row) { return row * width + k + column; };
    made.triangles.push_back({at(0, 0), at(2, 0), at(2, 2), at(1, 0), at(2, 1), at(1, 1)});
    made.triangles.push_back({at(0, 0), at(2, 2), at(0, 2), at(1, 1), at(1, 2), at(0, 1)});
  }
  return made;
}

TEST(Mechanism, heave_of_finite_elements_is_that_of_their_ground)
{
  const run_folder::SavedSoil start = elements(flat);
  const auto hill = [](Real x) { return std::max(0., 0.4 * D - std::abs(x - 1.05 * D)) - (x < -0.95 * D ? 0.1 * D : 0); };
  const Heave heave = heave_of(start, elements(hill), 0, {0, 0, 0}, D);
  EXPECT_NEAR(heave.berm, 0.16 * D * D, 1e-3 * D * D);
  EXPECT_NEAR(heave.ahead, 0.375 * D, 1e-3 * D) << "the mean of the highest column";
  EXPECT_NEAR(heave.behind, 0, 1e-3 * D) << "a hollow is no soil above the surface";
  const Berm berm = berm_of(start, elements(hill), 0, {0, 0, 0}, 1, D);
  EXPECT_NEAR(berm.height, 0.375 * D, 1e-3 * D);
  EXPECT_NEAR(berm.distance, 1.05 * D, 1e-3 * D);
}

TEST(Mechanism, soil_below_an_overhang_of_finite_elements_does_not_count_twice)
{
  // One node above the surface leans over the ground ahead of it: the triangle (0.1, 0), (0.5, 0.4), (0.3, 0) D is all that has risen.
  run_folder::SavedSoil now = elements(flat);
  for (std::size_t k = 0; k < now.x.size(); ++k) {
    if (now.y[k] < -side / 4) continue;
    const Real x = now.x[k] / D;
    if (x > 0.11 && x < 0.29) {
      const Real s = (x - 0.1) / 0.1, along = s < 1 ? s : 2 - s, foot = s < 1 ? 0.1 : 0.3;
      now.x[k] = (foot + along * (0.5 - foot)) * D, now.y[k] = along * 0.4 * D;
    }
  }
  EXPECT_NEAR(heave_of(elements(flat), now, 0, {0, 0, 0}, D).berm, 0.04 * D * D, 1e-3 * D * D);
}

TEST(Mechanism, of_frames_with_other_points_is_refused)
{
  run_folder::SavedSoil after = elements(flat);
  after.triangles.pop_back();
  EXPECT_THROW(mechanism_of(elements(flat), after, 0, {0, 0, 0}, {0, 0, 0}, D), RunError);
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
