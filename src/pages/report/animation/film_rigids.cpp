// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_rigids.hpp"

#include "report/animation/film_quantization.hpp"

#include <algorithm>
#include <map>

namespace berm::report {
namespace {

using Outlines = std::vector<std::vector<Index>>;

/// The outlines of each rigid body in one frame, as points of the frame.
std::map<std::int32_t, Outlines> outlines_in(const run_folder::SavedRigids& rigid_bodies, int dimension)
{
  std::map<std::int32_t, Outlines> outlines;
  for (std::size_t cell = 0; cell < rigid_bodies.cells.size(); ++cell) {
    const std::vector<Index>& points = rigid_bodies.cells[cell];
    if (points.size() < 2) continue;
    Outlines& own = outlines[rigid_bodies.rigid[cell]];
    if (dimension == 2) {
      own.push_back(points);
    } else if (rigid_bodies.types[cell] == run_folder::VtkCell::quad) {
      // A side of an extruded body; its first corner is one of the lower end.
      if (own.empty()) own.emplace_back();
      own.front().push_back(points.front());
    }
  }
  return outlines;
}

}  // namespace

std::vector<FilmOutline> film_outlines(const std::vector<const FilmFrame*>& frames, int dimension)
{
  // The number of a body's outlines may change: a circle that turns gets a spoke.
  std::map<std::pair<std::int32_t, std::size_t>, FilmOutline> films;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const run_folder::SavedRigids& rigid_bodies = frames[f]->rigid_bodies;
    for (const auto& [rigid, outlines] : outlines_in(rigid_bodies, dimension))
      for (std::size_t number = 0; number < outlines.size(); ++number) {
        const std::vector<Index>& outline = outlines[number];
        const std::size_t size = 2 * outline.size();
        FilmOutline& film = films[{rigid, number}];
        if (film.corners.empty()) film = {rigid, static_cast<Index>(outline.size()), std::vector<Real>(size * frames.size(), nan)};
        if (film.points != static_cast<Index>(outline.size())) continue;
        auto corner = film.corners.begin() + static_cast<std::ptrdiff_t>(f * size);
        for (const Index point : outline) {
          *corner++ = rigid_bodies.x[point];
          *corner++ = rigid_bodies.y[point];
        }
      }
  }
  std::vector<FilmOutline> list;
  for (auto& [key, film] : films) list.push_back(std::move(film));
  return list;
}

namespace {

/// Faces of a hexahedron, whose corners are in the order of VTK.
constexpr int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

void add_polygon(std::vector<Index>& triangles, const std::vector<Index>& corners)
{
  for (std::size_t k = 2; k < corners.size(); ++k)
    for (const std::size_t corner : {std::size_t(0), k - 1, k}) triangles.push_back(corners[corner]);
}

/// Corners of the triangles of each rigid body in a frame, as points of the frame.
std::map<std::int32_t, std::vector<Index>> triangles_in(const run_folder::SavedRigids& rigid_bodies)
{
  std::map<std::int32_t, std::vector<Index>> triangles;
  for (std::size_t cell = 0; cell < rigid_bodies.cells.size(); ++cell) {
    const std::vector<Index>& points = rigid_bodies.cells[cell];
    std::vector<Index>& own = triangles[rigid_bodies.rigid[cell]];
    if (rigid_bodies.types[cell] == run_folder::VtkCell::hexahedron && points.size() == 8)
      for (const auto& face : faces) add_polygon(own, {points[face[0]], points[face[1]], points[face[2]], points[face[3]]});
    else if (rigid_bodies.types[cell] != run_folder::VtkCell::line)
      add_polygon(own, points);
  }
  return triangles;
}

/// Each point once, ascending.
std::vector<Index> points_of(std::vector<Index> triangles)
{
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

std::array<std::vector<Real>, 3> corners_at(const run_folder::SavedRigids& rigid_bodies, const std::vector<Index>& points)
{
  std::array<std::vector<Real>, 3> corners;
  for (const Index point : points) {
    corners[0].push_back(rigid_bodies.x[point]);
    corners[1].push_back(rigid_bodies.y[point]);
    corners[2].push_back(rigid_bodies.z[point]);
  }
  return corners;
}

std::vector<const std::vector<Real>*> axis_of(const FilmSurface& surface, std::size_t d)
{
  std::vector<const std::vector<Real>*> lists;
  for (const auto& corners : surface.corners) lists.push_back(&corners[d]);
  return lists;
}

}  // namespace

std::vector<FilmSurface> film_surfaces(const std::vector<const FilmFrame*>& frames)
{
  std::map<std::int32_t, FilmSurface> surfaces;
  for (std::size_t f = 0; f < frames.size(); ++f)
    for (const auto& [rigid, triangles] : triangles_in(frames[f]->rigid_bodies)) {
      const std::vector<Index> points = points_of(triangles);
      if (points.empty()) continue;
      FilmSurface& surface = surfaces[rigid];
      if (surface.corners.empty()) {
        surface.rigid = rigid;
        surface.points = static_cast<Index>(points.size());
        for (const Index point : triangles)
          surface.triangles.push_back(static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), point) - points.begin()));
        surface.corners.assign(frames.size(), corners_at(frames[f]->rigid_bodies, points));
      }
      if (surface.points != static_cast<Index>(points.size())) continue;
      std::fill(surface.corners.begin() + static_cast<std::ptrdiff_t>(f), surface.corners.end(),
                corners_at(frames[f]->rigid_bodies, points));
    }
  std::vector<FilmSurface> list;
  for (auto& [rigid, surface] : surfaces) list.push_back(std::move(surface));
  return list;
}

SurfaceGrid::SurfaceGrid(const FilmSurface& surface) : step(1e-9)
{
  for (std::size_t d = 0; d < 3; ++d) {
    const auto [low, high] = ends_of(axis_of(surface, d));
    lower[static_cast<int>(d)] = low;
    step = std::max(step, (high - low) / max_code);
  }
}

std::string SurfaceGrid::bytes(const FilmSurface& surface) const
{
  std::string all;
  for (std::size_t d = 0; d < 3; ++d) all += axis_bytes(axis_of(surface, d), lower[static_cast<int>(d)], step);
  return all;
}

std::string outline_bytes(const FilmOutline& outline, const Vec<2>& from)
{
  std::vector<float> corners;
  for (std::size_t k = 0; k < outline.corners.size(); ++k) corners.push_back(static_cast<float>(outline.corners[k] - from[k % 2]));
  return bytes_of(corners);
}

}  // namespace berm::report
