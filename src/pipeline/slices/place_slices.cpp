// SPDX-License-Identifier: BSD-3-Clause
#include "slices/place_slices.hpp"

#include "os/error.hpp"
#include "slices/line_on_springs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berm::slices {
namespace {

/// The case with many slices, whose places a line on springs knows only by its elements: these are short as far as it may buckle.
settings::Case with_short_elements(settings::Case c)
{
  constexpr Real parts = 100;
  const Real length = c.pipeline->length, size = std::min(longest_element_of(c) / 2, length / parts);
  settings::SliceSettings& slices = c.pipeline->slices;
  const Real to = slices.to.value_or(std::min(length, parts * size)), count = std::max<Real>(parts / 2, std::ceil(to / size));
  slices = {};
  slices.to = to;
  slices.spacing = to / count;
  return c;
}

/// Of springs and macro-elements sideways, N/m, by node.
std::vector<Real> resistances_of(const LineOnSprings& on_springs)
{
  const beam::Line& line = on_springs.of_case().line;
  const beam::State& state = on_springs.state();
  std::vector<Real> resistances(static_cast<std::size_t>(line.nodes()), 0);
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const beam::Spring& spring = line.springs[s];
    if (spring.freedom == line.across(beam::Plane::lateral, spring.node))
      resistances[spring.node] += force_of(line.laws[spring.law], state.springs[s], state.displacement[spring.freedom]).force;
  }
  for (std::size_t m = 0; m < line.macro_elements.size(); ++m) resistances[line.macro_elements[m].node] += state.macro_elements[m].H;
  return resistances;
}

/// What the line does on its way.
struct Seen {
  std::vector<Real> changes;  ///< by element, int |Delta H| dt
  Index last = 0;             ///< the farthest node at which a spring has had much of its resistance
};

void look_at(const LineOnSprings& on_springs, Real dt, Seen& seen)
{
  const LineOfCase& of = on_springs.of_case();
  const std::vector<Real> H = resistances_of(on_springs);
  for (std::size_t e = 0; e < seen.changes.size(); ++e) seen.changes[e] += dt * std::abs(H[e + 1] - H[e]);
  for (Index i = of.line.nodes() - 1; i > seen.last; --i) {
    const Index v = of.line.across(beam::Plane::lateral, i);
    if (of.mobilised(on_springs.state().displacement[v] - of.line.shape[v]) >= much_mobilised) seen.last = i;
  }
}

/// How many slices there are to a metre, by element as far as the last slice, over a factor.
std::vector<Real> densities(const beam::Line& line, const std::vector<Real>& changes, Real to)
{
  constexpr Real most = 7;  // over the mean
  std::vector<Real> densities;
  Real all = 0;
  for (Index e = 0; e < line.elements() && line.x[e] < to; ++e) all += changes[static_cast<std::size_t>(e)];
  for (Index e = 0; e < line.elements() && line.x[e] < to; ++e) {
    const Real share = all > 0 ? changes[static_cast<std::size_t>(e)] / all : 0;
    densities.push_back(1 + std::min(most, share * to / line.length(e)));
  }
  return densities;
}

std::vector<Real> places_in_equal_shares(const beam::Line& line, const std::vector<Real>& densities, Real to, int count)
{
  constexpr Real digits = 1e5;  // of all
  std::vector<Real> until = {0};
  for (std::size_t e = 0; e < densities.size(); ++e)
    until.push_back(until.back() + densities[e] * (std::min(line.x[e + 1], to) - line.x[e]));
  std::vector<Real> places;
  for (int k = 0; k + 1 < count; ++k) {
    const Real share = until.back() * k / (count - 1);
    const auto e = static_cast<std::size_t>(std::upper_bound(until.begin(), until.end(), share) - until.begin()) - 1;
    const Real x = line.x[e] + (share - until[e]) / densities[e];
    places.push_back(std::round(digits * x / to) / digits * to);
  }
  places.push_back(to);
  return places;
}

}  // namespace

void place_slices(settings::Case& c)
{
  constexpr Real more = 1.1;
  settings::SliceSettings& slices = c.pipeline->slices;
  if (slices.count == 0) return;
  const settings::Case tried = with_short_elements(c);
  LineOnSprings on_springs(tried);
  const LineOfCase& of = on_springs.of_case();
  if (!of.lateral)
    throw KeyError("pipeline.slices.count: the springs of pipeline.far_soil, by which berm chooses the positions, have no lateral "
                   "resistance; give them one, or the slices positions: pipeline.slices.at");
  const std::size_t hottest = hottest_stage_of(tried, of);
  Seen seen{std::vector<Real>(static_cast<std::size_t>(of.line.elements()), 0)};
  go_through_stages(tried, 1,
                    {[&](std::size_t, Real dt) { look_at(on_springs, dt, seen); },
                     [&](std::size_t stage, const LineLoads&, const LineLoads&) { return stage < hottest; }},
                    on_springs);
  if (!slices.to && seen.last == 0)
    throw KeyError(
        "pipeline.slices.count: on the springs of pipeline.far_soil the line does not slide laterally, so berm cannot choose the "
        "position of the last slice: give pipeline.slices.to");
  const Real to = slices.to.value_or(std::min(more * of.line.x[seen.last], c.pipeline->length));
  slices.at = places_in_equal_shares(of.line, densities(of.line, seen.changes, to), to, slices.count);
  slices.count = 0;
  slices.to.reset();
}

}  // namespace berm::slices
