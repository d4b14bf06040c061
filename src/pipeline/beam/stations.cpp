// SPDX-License-Identifier: BSD-3-Clause
#include "beam/stations.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::beam {
namespace {

/// The hat of point k of ascending ones, at x.
Real hat(const std::vector<Real>& points, Index k, Real x)
{
  if (x < points[k]) return k == 0 ? 0 : std::max(0.0, (x - points[k - 1]) / (points[k] - points[k - 1]));
  if (x == points[k]) return 1;
  return k + 1 == static_cast<Index>(points.size()) ? 0 : std::max(0.0, (points[k + 1] - x) / (points[k + 1] - points[k]));
}

}  // namespace

Stations::Stations(const Line& line, std::vector<Real> places)
{
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!(places[k] >= line.x.front() && places[k] <= line.x.back()))
      throw InputError(fmt::format("a station is at x = {} m: the line extends from {} to {} m", places[k], line.x.front(), line.x.back()));
    if (k > 0 && !(places[k] > places[k - 1]))
      throw InputError(fmt::format("a station at x = {} m follows one at {} m: they ascend", places[k], places[k - 1]));
  }
  if (places.size() < 2) throw InputError(fmt::format("a line has {} stations: it has two at least", places.size()));
  lengths_.assign(places.size(), 0);
  std::vector<Real> borders = places;
  borders.insert(borders.end(), line.x.begin(), line.x.end());
  std::sort(borders.begin(), borders.end());
  for (Index k = 0; k < count(); ++k)
    for (Index i = 0; i < line.nodes(); ++i) {
      // Between two borders the product of two hats is a parabola, which Simpson's rule sums exactly. Hats are continuous but at the ends of the line and of the stations, where a border lies.
      const Real from = std::max(places[std::max(0, k - 1)], line.x[std::max(0, i - 1)]);
      const Real to = std::min(places[std::min(count() - 1, k + 1)], line.x[std::min(line.nodes() - 1, i + 1)]);
      Real length = 0;
      for (auto border = std::lower_bound(borders.begin(), borders.end(), from); border != borders.end() && *border < to; ++border) {
        const Real a = *border, b = *(border + 1), m = (a + b) / 2;
        length +=
            (b - a) / 6 *
            (hat(places, k, a) * hat(line.x, i, a) + 4 * hat(places, k, m) * hat(line.x, i, m) + hat(places, k, b) * hat(line.x, i, b));
      }
      if (length > 0) shares_.push_back({k, i, length});
      lengths_[k] += length;
    }
}

void Stations::add_to_nodes(const std::vector<Real>& of_stations, std::vector<Real>& of_nodes) const
{
  for (const Share& share : shares_) of_nodes[share.node] += share.length * of_stations[share.station];
}

void Stations::add_forces(const Line& line, Direction direction, const std::vector<Real>& per_metre, Loads& loads) const
{
  for (const Share& share : shares_) loads.force[line.freedom(direction, share.node)] += share.length * per_metre[share.station];
}

void Stations::add_impedances(const Line& line, Direction direction, const std::vector<Real>& per_metre, Loads& loads) const
{
  for (const Share& share : shares_) loads.impedance[line.freedom(direction, share.node)] += share.length * per_metre[share.station];
}

void Stations::means(const Line& line, Direction direction, const std::vector<Real>& of_freedoms, std::vector<Real>& of_stations) const
{
  std::fill(of_stations.begin(), of_stations.end(), 0.0);
  for (const Share& share : shares_)
    of_stations[share.station] += share.length / lengths_[share.station] * of_freedoms[line.freedom(direction, share.node)];
}

}  // namespace berm::beam
