// SPDX-License-Identifier: BSD-3-Clause
#include "os/error.hpp"
#include "samples/macro_element_parameters.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace berm::macro_element_fit::this_file {
namespace {

/// What the macro-element itself does: pushed to 0.1 m, unloaded to V (N/m), dragged by `way` (m), and back where it is to return.
Path made_path(const Parameters& p, Real V, Real way, bool back)
{
  Path path;
  path.name = "made";
  path.diameter = p.diameter;
  for (int k = 1; k <= 25; ++k) path.points.push_back({0, 0.004 * k, 0, 0, false});
  const std::size_t push = path.points.size();
  path.points.push_back({0, nan, 0, V, true});
  for (int k = 1; k <= 20; ++k) path.points.push_back({way * k / 20, nan, 0, V, true});
  for (int k = 1; back && k <= 20; ++k) path.points.push_back({way * (1 - k / 20.), nan, 0, V, true});
  const Response response = follow(p, path);
  for (std::size_t k = 0; k < path.points.size(); ++k) {
    path.points[k].H = response.H[k];
    path.points[k].V = response.V[k];
    path.points[k].w = response.w[k];
  }
  path.push.assign(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(push));
  return path;
}

TEST(Follow, meets_the_force_that_is_given)
{
  const Parameters p = macro_element::sample_parameters();
  const Path path = made_path(p, 2000, 0.5, true);
  for (std::size_t k = 25; k < path.points.size(); ++k) EXPECT_NEAR(path.points[k].V, 2000, 1e-2) << "1e-7 of V and k_v D/1000";
}

TEST(Misfit, of_a_path_and_itself_is_none)
{
  const Parameters p = macro_element::sample_parameters();
  const Path path = made_path(p, 2000, 0.5, false);
  Response same = follow(p, path);
  const Misfit none = misfit_of(path, same);
  EXPECT_LT(none.H, 1e-4);
  EXPECT_LT(none.V, 1e-9);
  EXPECT_LT(none.w, 1e-6);
  EXPECT_NEAR(none.largest, 1, 1e-4);
  for (Real& H : same.H) H += 0.1 * path.largest_H();
  EXPECT_NEAR(misfit_of(path, same).H, 0.1, 1e-3);
  EXPECT_NEAR(misfit_of(path, same).largest, 1.1, 1e-3);
}

TEST(Fit, finds_again_what_made_the_paths)
{
  Parameters p = macro_element::sample_parameters();
  p.uplift_ratio = 0;
  std::vector<Path> paths = {made_path(p, 1500, 0.5, true), made_path(p, 3500, 0.5, false)};
  paths[0].friction = 0.4;
  const Parameters found = fit(paths);
  EXPECT_EQ(found.axial_friction, 0.4) << "that of the contact: no path tells it";
  EXPECT_DOUBLE_EQ(found.axial_mobilisation, 0.005) << "D/100";
  for (const Path& path : paths) {
    const Misfit misfit = misfit_of(path, follow(found, path));
    EXPECT_LT(misfit.H, 0.03) << "V0 is a polygon of its curve, and the search ends at changes of 1e-5";
    EXPECT_LT(misfit.w, 0.03);
  }
  const Path other = made_path(p, 2500, 0.7, true);
  EXPECT_LT(misfit_of(other, follow(found, other)).H, 0.05) << "a path between those that it was fitted to";
}

TEST(Fit, refuses_paths_that_do_not_determine_it)
{
  const Parameters p = macro_element::sample_parameters();
  Path no_push = made_path(p, 1500, 0.5, false);
  no_push.push.clear();
  EXPECT_THROW(fit({no_push}), RunError);
  Path no_drag = made_path(p, 1500, 0.5, false);
  no_drag.points.resize(25);
  EXPECT_THROW(fit({no_drag}), RunError);
  Path larger = made_path(p, 1500, 0.5, false);
  larger.diameter = 0.6;
  EXPECT_THROW(fit({made_path(p, 1500, 0.5, false), larger}), RunError);
}

}  // namespace
}  // namespace berm::macro_element_fit::this_file
