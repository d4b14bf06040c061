// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "sanity/journey_on_springs.hpp"

#include "beam/answers.hpp"
#include "slices/line_on_springs.hpp"

#include <algorithm>

namespace berm::sanity {
namespace {

constexpr Real embedment = 0.1;                           // over the diameter: for the resistance of an interface along the line
constexpr Real way_of_step = 0.01;                        // over the diameter
constexpr Real shortest_step = 5e-3, longest_step = 0.1;  // s
constexpr Real most_node_steps = 5e5;

using beam::Plane;

/// Since it was laid, m, by freedom.
std::vector<Real> gone_of(const slices::LineOnSprings& line)
{
  std::vector<Real> gone = line.state().displacement;
  for (std::size_t i = 0; i < gone.size(); ++i) gone[i] -= line.of_case().line.shape[i];
  return gone;
}

Real next_step_of(const slices::LineOnSprings& line)
{
  Real fastest = 0;
  for (Index i = 0; i < line.of_case().line.nodes(); ++i)
    fastest = std::max(fastest, std::abs(line.state().velocity[line.of_case().line.across(Plane::lateral, i)]));
  return std::clamp(way_of_step * line.of_case().diameter / fastest, shortest_step, longest_step);
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
  case problem::LineHalf::symmetric:
    return 2 * place(right);
  case problem::LineHalf::antisymmetric:
    return place(right);
  case problem::LineHalf::none:
    break;
  }
  return 2 * (place(right) - of.x[crown]);
}

/// The first stage that brings the largest compression of all.
std::size_t hottest_stage_of(const problem::Case& c, const slices::LineOfCase& of)
{
  Real largest = -infinity;
  std::size_t hottest = 0;
  slices::LineLoads loads = of.laid();
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    if (c.stage[k].kind != problem::StageKind::pipeline) continue;
    loads = target_of(c.stage[k].pipeline, loads);
    if (const Real compression = of.constrained_force(loads, 0); compression > largest) largest = compression, hottest = k;
  }
  return hottest;
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

std::optional<Journey> journey_on_springs(const problem::Case& c, Real slower, const GoesOn& goes_on)
{
  slices::LineOnSprings line(c, embedment * bodies::width_of<2>(bodies::make_shape<2>(c.rigid.front().second.shape)));
  const slices::LineOfCase& of = line.of_case();
  if (!of.lateral) return {};
  const std::size_t hottest = hottest_stage_of(c, of);
  Journey journey{std::vector<LineThen>(c.stage.size()), of.places, std::vector<Span>(of.places.size(), {0, 0})};
  slices::LineLoads from = of.laid();
  Real steps_left = most_node_steps / static_cast<Real>(of.line.nodes());
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const problem::StageSettings& stage = c.stage[k];
    if (stage.kind != problem::StageKind::pipeline) continue;
    const slices::LineLoads to = target_of(stage.pipeline, from);
    const Real ramp = slower * stage.ramp, end = slower * *stage.until.time;
    for (Real time = 0; time < end;) {
      if (--steps_left < 0) return journey;
      const Real left = end - time, dt = std::min(left, next_step_of(line));
      time = dt < left ? time + dt : end;
      try {
        line.step(slices::between(from, to, ramp > time ? time / ramp : 1), dt);
      } catch (const beam::NoEquilibrium&) {
        return journey;
      }
      if (k <= hottest) note_slices(line, journey);
    }
    if (of.constrained_force(to, 0) > of.constrained_force(from, 0)) journey.ends[k] = then_of(line);
    if (k == hottest) journey.lobe = lobe_of(line);
    if (!goes_on(k, journey.ends[k])) break;
    from = to;
  }
  return journey;
}

}  // namespace berm::sanity
