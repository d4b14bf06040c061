// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/journey_on_springs.hpp"

#include "beam/answers.hpp"
#include "slices/line_on_springs.hpp"

#include <algorithm>

namespace berm::sanity {
namespace {

using beam::Plane;

/// Since it was laid, m, by freedom.
std::vector<Real> gone_of(const slices::LineOnSprings& line)
{
  std::vector<Real> gone = line.state().displacement;
  for (std::size_t i = 0; i < gone.size(); ++i) gone[i] -= line.of_case().line.shape[i];
  return gone;
}

/// Between the places to either side of the crown where the line has not moved; what lies beyond x = 0 is its other half.
Real lobe_of(const slices::LineOnSprings& line)
{
  const beam::Line& of = line.of_case().line;
  const std::vector<Real> all = gone_of(line);
  const auto gone = [&](Index i) { return all[of.across(Plane::lateral, i)]; };
  const Index crown = beam::crown(of, line.state(), true);
  const auto ends_between = [&](Index i) { return gone(i) * gone(i + 1) <= 0; };
  const auto place = [&](Index i) { return of.x[i] + gone(i) / (gone(i) - gone(i + 1)) * of.length(i); };
  Index right = crown, left = crown - 1;
  while (right < of.elements() && !ends_between(right)) ++right;
  while (left >= 0 && !ends_between(left)) --left;
  if (!(std::abs(gone(crown)) > buckled * line.of_case().diameter) || right == of.elements()) return nan;
  if (left >= 0) return place(right) - place(left);
  switch (line.of_case().settings.half) {
  case settings::LineHalf::symmetric:
    return 2 * place(right);
  case settings::LineHalf::antisymmetric:
    return place(right);
  case settings::LineHalf::none:
    break;
  }
  return 2 * (place(right) - of.x[crown]);
}

void note_slices(const slices::LineOnSprings& line, Journey& journey)
{
  std::vector<Real> means(journey.places.size());
  line.of_case().stations.means(line.of_case().line, beam::Direction::lateral, gone_of(line), means);
  for (std::size_t k = 0; k < means.size(); ++k) journey.sideways[k].add(means[k]);
}

LineThen then_of(const slices::LineOnSprings& line)
{
  const beam::Line& of = line.of_case().line;
  LineThen then{std::abs(line.state().displacement[of.across(Plane::lateral, crown(of, line.state()))]), largest_moment(of, line.state())};
  const std::vector<Real> gone = gone_of(line);
  for (Index i = 0; i < of.nodes(); ++i) then.gone = std::max(then.gone, std::abs(gone[of.across(Plane::lateral, i)]));
  return then;
}

}  // namespace

std::optional<Journey> journey_on_springs(const settings::Case& c, Real slower, const GoesOn& goes_on)
{
  slices::LineOnSprings line(c);
  const slices::LineOfCase& of = line.of_case();
  if (!of.lateral) return {};
  const std::size_t hottest = hottest_stage_of(c, of);
  Journey journey{std::vector<LineThen>(c.stage.size()), of.places, std::vector<Span>(of.places.size(), {0, 0})};
  const auto step = [&](std::size_t k, Real) {
    if (k <= hottest) note_slices(line, journey);
  };
  const auto stage_end = [&](std::size_t k, const slices::LineLoads& before, const slices::LineLoads& now) {
    if (of.constrained_force(now, 0) > of.constrained_force(before, 0)) journey.ends[k] = then_of(line);
    if (k == hottest) journey.lobe = lobe_of(line);
    return goes_on(k, journey.ends[k]);
  };
  go_through_stages(c, slower, {step, stage_end}, line);
  return journey;
}

}  // namespace berm::sanity
