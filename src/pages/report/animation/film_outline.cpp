// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_outline.hpp"

#include "report/animation/film_quantization.hpp"

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
    } else if (rigid_bodies.types[cell] == io::VtkCell::quad) {  // a side of an extruded body; its first corner is one of the lower end
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

std::string outline_bytes(const FilmOutline& outline, const Vec<2>& from)
{
  std::vector<float> corners;
  for (std::size_t k = 0; k < outline.corners.size(); ++k) corners.push_back(static_cast<float>(outline.corners[k] - from[k % 2]));
  return bytes_of(corners);
}

}  // namespace berm::report
