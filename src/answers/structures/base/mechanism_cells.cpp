// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/base/mechanism_cells_test.cpp
#include "structures/base/mechanism_cells.hpp"

#include "os/error.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>

namespace berm::base {
namespace {

constexpr Real a_tenth = 0.1, a_hundredth = 0.01;

/// The interval that holds the middle 98 % of the values.
struct Interval {
  Real low, high;

  explicit Interval(std::vector<Real> values)
  {
    const auto value_at = [&](Real part) {
      const auto place = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<Real>(values.size() - 1));
      std::nth_element(values.begin(), place, values.end());
      return *place;
    };
    low = value_at(a_hundredth);
    high = value_at(1 - a_hundredth);
  }
  Real length() const { return high - low; }
  /// Whether both ends are those of another, but for a twentieth of its length.
  bool is_about(const Interval& other) const
  {
    constexpr Real a_twentieth = 0.05;
    return std::max(std::abs(low - other.low), std::abs(high - other.high)) < a_twentieth * other.length();
  }
};

/// Coordinates along an axis of those points that are wanted.
std::vector<Real> places(const run_folder::SavedSoil& soil, const std::vector<std::size_t>& points, int axis)
{
  const std::vector<Real>& all = axis == 0 ? soil.x : axis == 1 ? soil.y : soil.z;
  std::vector<Real> chosen;
  for (const std::size_t k : points) chosen.push_back(all[k]);
  return chosen;
}

/// The points of the bodies that count.
std::vector<std::size_t> counted_points(const run_folder::SavedSoil& soil, const std::vector<Real>& points_of_cell)
{
  std::vector<std::size_t> points;
  for (std::size_t k = 0; k < soil.x.size(); ++k)
    if (!std::isnan(points_of_cell.at(static_cast<std::size_t>(soil.body[k])))) points.push_back(k);
  return points;
}

/// Points that a cell of each body had at the start: NaN of bodies without a strength and of those on a lattice of their own.
std::vector<Real> points_of_cell(const settings::Case& c)
{
  std::vector<Real> points;
  for (const auto& [name, body] : c.body) {
    const Index material = index_of(c.material, body.material);
    const bool counts = !body.block && !body.disk && material != none && yields(c.material[material].second);
    points.push_back(counts ? filled_particles(body, c.dimension()) : nan);
  }
  return points;
}

/// The same of bodies whose shear bands have a width; NaN also where regions have numbers of their own.
std::vector<Real> points_of_banded_cell(const settings::Case& c)
{
  std::vector<Real> points = points_of_cell(c);
  for (std::size_t b = 0; b < points.size(); ++b) {
    const bodies::BodySettings& body = c.body[b].second;
    if (std::isnan(points[b]) || !body.region_particles_per_cell.empty() ||
        !band_width(c.material[index_of(c.material, body.material)].second))
      points[b] = nan;
  }
  return points;
}

/// Those of them that have sheared.
std::vector<std::size_t> sheared_points(const run_folder::SavedSoil& soil, const std::vector<Real>& points_of_cell)
{
  std::vector<std::size_t> sheared = counted_points(soil, points_of_cell);
  if (sheared.empty()) return sheared;
  const std::vector<float>& strain = soil["deviatoric_strain"];
  std::vector<Real> strains;
  for (const std::size_t k : sheared) strains.push_back(strain[k]);
  const Real least = a_tenth * Interval(std::move(strains)).high;
  std::erase_if(sheared, [&](std::size_t k) { return !(strain[k] >= least); });
  return sheared;
}

/// The area (volume) of the cell that a point came from.
Real cell_of(const run_folder::SavedSoil& soil, std::size_t point, const std::vector<Real>& points_of_cell)
{
  return soil.volume[point] * points_of_cell[static_cast<std::size_t>(soil.body[point])];
}

/// Mesh::size of such a cell.
Real size_of(Real cell, int dim)
{
  return dim == 2 ? std::sqrt(2 * cell) : std::cbrt(6 * cell);
}

}  // namespace

Real cells_across_mechanism(const run_folder::SavedSoil& start, const run_folder::SavedSoil& now, const std::vector<Real>& points_of_cell,
                            int dim)
{
  const std::vector<std::size_t> at_start = counted_points(start, points_of_cell), sheared = sheared_points(now, points_of_cell);
  if (at_start.empty() || sheared.empty()) return nan;
  Real cells = 0, smallest = infinity;
  for (const std::size_t k : sheared) cells += cell_of(now, k, points_of_cell);
  for (int axis = 0; axis < dim; ++axis) {
    const Interval side(places(now, sheared, axis));
    if (!side.is_about(Interval(places(start, at_start, axis)))) smallest = std::min(smallest, side.length());
  }
  return std::isfinite(smallest) ? smallest / size_of(cells / static_cast<Real>(sheared.size()), dim) : nan;
}

Real cells_across_mechanism(const record::RunRecord& run)
{
  if (!has_mechanism_cells(run)) return nan;
  try {
    const std::vector<run_folder::FrameFiles> frames = run_folder::frame_files(run.folder / "frames");
    if (frames.size() < 2) return nan;
    return cells_across_mechanism(run_folder::read_soil(frames.front().soil), run_folder::read_soil(frames.back().soil),
                                  points_of_cell(run.settings), run.settings.dimension());
  } catch (const RunError&) {  // the film says which frame is damaged
    return nan;
  }
}

std::optional<CellSizes> sheared_cell_sizes(const record::RunRecord& run)
{
  if (!has_mechanism_cells(run)) return {};
  try {
    const std::vector<run_folder::FrameFiles> frames = run_folder::frame_files(run.folder / "frames");
    if (frames.size() < 2) return {};
    const run_folder::SavedSoil soil = run_folder::read_soil(frames.back().soil);
    const std::vector<Real> points = points_of_banded_cell(run.settings);
    std::vector<Real> sizes;
    for (const std::size_t k : sheared_points(soil, points)) sizes.push_back(size_of(cell_of(soil, k, points), run.settings.dimension()));
    if (sizes.empty()) return {};
    const Interval range(std::move(sizes));
    return CellSizes{range.low, range.high};
  } catch (const RunError&) {
    return {};
  }
}

bool has_mechanism_cells(const record::RunRecord& run)
{
  const std::vector<Real> points = points_of_cell(run.settings);
  return run.settings.method == settings::Method::mpm && std::any_of(points.begin(), points.end(), [](Real p) { return !std::isnan(p); });
}

}  // namespace berm::base
