// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_rigids.hpp"

#include "samples/film_decoding.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <set>

namespace berm::report::this_file {
namespace {

/// A unit cube, as a hexahedron whose corners are not the first points, and a lid of another body.
FilmFrame frame_at(Real x)
{
  FilmFrame frame;
  run_folder::SavedRigids& r = frame.rigid_bodies;
  r.x = {9, x, x + 1, x + 1, x, x, x + 1, x + 1, x, 9};
  r.y = {9, 0, 0, 1, 1, 0, 0, 1, 1, 9};
  r.z = {9, 0, 0, 0, 0, 1, 1, 1, 1, 8};
  r.cells = {{1, 2, 3, 4, 5, 6, 7, 8}, {0, 5, 6, 9}, {0, 9}};
  r.types = {run_folder::VtkCell::hexahedron, run_folder::VtkCell::quad, run_folder::VtkCell::line};
  r.rigid = {2, 5, 5};
  return frame;
}

/// Six times the volume that triangles enclose, positive where they are counter-clockwise from outside.
Real six_volumes(const FilmSurface& surface, std::size_t f)
{
  Real sum = 0;
  const auto corner = [&](std::size_t k) {
    const auto& [x, y, z] = surface.corners[f];
    const std::uint32_t point = surface.triangles[k];
    return Vec<3>(x[point], y[point], z[point]);
  };
  for (std::size_t k = 0; k < surface.triangles.size(); k += 3) sum += corner(k).dot(corner(k + 1).cross(corner(k + 2)));
  return sum;
}

TEST(film_surface, hexahedron_is_twelve_triangles_that_close_its_volume)
{
  const FilmFrame first = frame_at(0), second = frame_at(3);
  const std::vector<FilmSurface> surfaces = film_surfaces({&first, &second});
  ASSERT_EQ(surfaces.size(), 2u);
  EXPECT_EQ(surfaces[0].rigid, 2);
  EXPECT_EQ(surfaces[0].points, 8);
  EXPECT_EQ(surfaces[0].triangles.size(), 36u);
  EXPECT_NEAR(six_volumes(surfaces[0], 0), 6, 1e-12);
  EXPECT_NEAR(six_volumes(surfaces[0], 1), 6, 1e-12);
  EXPECT_EQ(surfaces[1].rigid, 5);
  EXPECT_EQ(surfaces[1].triangles.size(), 6u);  // of the lid; a line has no surface
}

TEST(film_surface, body_stays_where_it_was_in_a_frame_without_it)
{
  const FilmFrame first = frame_at(0), none, last = frame_at(3);
  const std::vector<FilmSurface> surfaces = film_surfaces({&first, &none, &last});
  EXPECT_EQ(surfaces[0].corners[1], surfaces[0].corners[0]);
  EXPECT_EQ(surfaces[0].corners[2][0][0], 3);
}

TEST(film_surface, corners_decode_within_half_a_step)
{
  const FilmFrame first = frame_at(0), second = frame_at(3);
  const FilmSurface surface = film_surfaces({&first, &second}).front();
  const SurfaceGrid grid(surface);
  EXPECT_NEAR(grid.step, 4. / 65535, 1e-12);  // from 0 to 4 m along x
  const std::string bytes = grid.bytes(surface);
  ASSERT_EQ(bytes.size(), 6u * 2 * 8);
  const auto codes = decoded_places(bytes, 2, 8, 3);
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t k = 0; k < 8; ++k)
      for (std::size_t d = 0; d < 3; ++d)
        EXPECT_NEAR(grid.lower[static_cast<int>(d)] + grid.step * codes[d][f][k], surface.corners[f][d][k], grid.step / 2 * 1.001);
}

}  // namespace
}  // namespace berm::report::this_file
