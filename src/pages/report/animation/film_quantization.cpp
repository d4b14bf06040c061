// SPDX-License-Identifier: BSD-3-Clause
#include "report/animation/film_quantization.hpp"

#include "plot/gnuplot.hpp"

#include <algorithm>
#include <cmath>

namespace berm::report {
namespace {

/// A change of a code, such that small changes either way are small numbers: 0, -1, 1, -2, ... are 0, 1, 2, 3, ...
std::uint16_t folded(std::uint16_t now, std::uint16_t before)
{
  const auto change = static_cast<std::int16_t>(static_cast<std::uint16_t>(now - before));
  return static_cast<std::uint16_t>(change << 1 ^ change >> 15);
}

std::uint16_t code_of(Real x, Real lower, Real step)
{
  return static_cast<std::uint16_t>(std::lround(std::clamp((x - lower) / step, 0., max_code)));
}

}  // namespace

std::pair<Real, Real> ends_of(const std::vector<const std::vector<Real>*>& lists)
{
  std::pair<Real, Real> ends{infinity, -infinity};
  for (const std::vector<Real>* list : lists)
    for (const Real number : *list) ends = {std::min(ends.first, number), std::max(ends.second, number)};
  return ends;
}

FilmBox box_of(const std::vector<const FilmFrame*>& frames)
{
  FilmBox box{Vec<2>::Constant(infinity), Vec<2>::Constant(-infinity)};
  const auto widen = [&](const std::vector<Real>& places, int d) {
    if (places.empty()) return;
    const auto [lowest, highest] = std::minmax_element(places.begin(), places.end());
    box.lower[d] = std::min(box.lower[d], *lowest);
    box.upper[d] = std::max(box.upper[d], *highest);
  };
  for (const FilmFrame* frame : frames) {
    widen(frame->x, 0);
    widen(frame->y, 1);
  }
  return box;
}

FilmGrid::FilmGrid(const FilmBox& box) : lower(box.lower), step((box.upper - box.lower).maxCoeff() / max_code)
{
  if (!(step > 0)) step = 1 / max_code;  // one point, which never moves
}

std::uint16_t FilmGrid::code(Real x, int d) const
{
  return code_of(x, lower[d], step);
}

std::string axis_bytes(const std::vector<const std::vector<Real>*>& frames, Real lower, Real step)
{
  const std::size_t count = frames.front()->size(), plane = frames.size() * count;
  std::string bytes(2 * plane, '\0');
  std::vector<std::uint16_t> before(count);
  char *low = bytes.data(), *high = low + plane;
  for (const std::vector<Real>* places : frames)
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint16_t now = code_of((*places)[k], lower, step), stored = places == frames.front() ? now : folded(now, before[k]);
      before[k] = now;
      *low++ = static_cast<char>(stored & 255);
      *high++ = static_cast<char>(stored >> 8);
    }
  return bytes;
}

std::string position_bytes(const std::vector<const FilmFrame*>& frames, const FilmGrid& grid, Real lower_z)
{
  std::vector<const std::vector<Real>*> x, y, z;
  for (const FilmFrame* frame : frames) x.push_back(&frame->x), y.push_back(&frame->y), z.push_back(&frame->z);
  const std::string plane = axis_bytes(x, grid.lower[0], grid.step) + axis_bytes(y, grid.lower[1], grid.step);
  return frames.front()->z.empty() ? plane : plane + axis_bytes(z, lower_z, grid.step);
}

std::string size_bytes(const std::vector<float>& sizes, const FilmGrid& grid)
{
  std::vector<std::uint16_t> codes;
  for (const float size : sizes) codes.push_back(static_cast<std::uint16_t>(std::lround(std::clamp(size / grid.step, 1., max_code))));
  return bytes_of(codes);
}

std::string triangle_bytes(const std::vector<std::array<Index, 6>>& triangles)
{
  constexpr int parts[parts_of_triangle][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  std::vector<std::uint32_t> corners;
  for (const std::array<Index, 6>& nodes : triangles)
    for (const auto& part : parts)
      for (const int corner : part) corners.push_back(static_cast<std::uint32_t>(nodes[corner]));
  return bytes_of(corners);
}

FilmRange range_of(std::vector<float> values)
{
  if (values.empty()) return {};
  const auto part = static_cast<std::ptrdiff_t>(values.size() / 500);
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const Real min = *lowest, max = *highest;
  const auto at = [&](std::ptrdiff_t place) -> Real {
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
  };
  const auto end = [](Real most, Real farthest) { return most > 0 ? most : std::max(Real(0), farthest); };
  const Real above = end(at(std::ssize(values) - 1 - part), max), below = end(-at(part), -min);
  // A value of single precision may lie beyond its own decimals by round-off.
  const auto rounded = [](Real end_of_range) { return plot::round_up(end_of_range * (1 - 1e-6)); };
  return {below > 0 ? -rounded(below) : 0, above > 0 || below == 0 ? rounded(above) : 0};
}

std::string field_bytes(const std::vector<float>& values, std::size_t count, const FilmRange& range)
{
  std::string bytes(values.size(), '\0');
  std::vector<std::uint8_t> before(count, 0);
  for (std::size_t first = 0; first < values.size(); first += count)
    for (std::size_t k = 0; k < count; ++k) {
      const auto now =
          static_cast<std::uint8_t>(std::lround(std::clamp((values[first + k] - range.low) / (range.high - range.low), 0., 1.) * 255));
      bytes[first + k] = static_cast<char>(now - before[k]);
      before[k] = now;
    }
  return bytes;
}

}  // namespace berm::report
