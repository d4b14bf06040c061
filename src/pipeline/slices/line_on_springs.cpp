// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/slices/springs_beside_test.cpp
#include "slices/line_on_springs.hpp"

#include <algorithm>
#include <cmath>

namespace berm::slices {
namespace {

settings::Case without_soil(settings::Case c)
{
  c.pipeline->slices.as_spring = settings::SliceAsSpring::always;
  return c;
}

Real next_step_of(const LineOnSprings& line)
{
  constexpr Real way = 0.01;                      // over the diameter
  constexpr Real shortest = 5e-3, longest = 0.1;  // s
  const beam::Line& of = line.of_case().line;
  Real fastest = 0;
  for (Index i = 0; i < of.nodes(); ++i) fastest = std::max(fastest, std::abs(line.state().velocity[of.across(beam::Plane::lateral, i)]));
  return std::clamp(way * line.of_case().diameter / fastest, shortest, longest);
}

}  // namespace

void put_loads(const LineOfCase& of, const LineLoads& now, const std::vector<Real>& on_springs, beam::Loads& loads)
{
  const beam::Line& line = of.line;
  std::fill(loads.force.begin(), loads.force.end(), 0.0);
  for (Index e = 0; e < line.elements(); ++e) loads.constrained_force[e] = of.constrained_force(now, (line.x[e] + line.x[e + 1]) / 2);
  loads.force[line.axial(line.nodes() - 1)] += now.pull;
  // Springs have no force where the line was laid, macro-elements carry its weight there.
  const Real carried = of.settings.far_soil.macro_element.empty() ? of.settings.submerged_weight : 0;
  // Loads go to nodes as reactions of the soil do, so that a line that is carried all along is not bent at its ends.
  for (Index i = 0; i < line.nodes(); ++i) {
    loads.force[line.across(beam::Plane::lateral, i)] += now.lateral * of.length_of_nodes[i];
    loads.force[line.across(beam::Plane::vertical, i)] += carried * on_springs[i] - now.weight * of.length_of_nodes[i];
  }
}

LineOnSprings::LineOnSprings(const settings::Case& c, std::optional<Real> embedment)
    : of_case_(without_soil(c)),
      state_(beam::state_of(of_case_.line)),
      work_(of_case_.line),
      loads_(beam::no_loads(of_case_.line))
{
  if (!of_case_.has_interface()) return;
  const Real weight = of_case_.settings.submerged_weight,
             along = of_case_.axial_resistance(embedment.value_or(0.1 * of_case_.diameter), weight);
  const beam::Line& line = of_case_.line;
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const beam::Spring& spring = line.springs[s];
    if (spring.freedom == line.axial(spring.node) && std::holds_alternative<beam::PlasticSpring>(line.laws[spring.law]))
      state_.spring_factor[s] = along / weight;
  }
}

void LineOnSprings::step(const LineLoads& now, Real dt)
{
  constexpr Real smallest = 1.0 / 64;
  put_loads(of_case_, now, of_case_.length_of_nodes, loads_);
  for (Real done = 0, part = 1; done < 1;) try {
      beam::step(of_case_.line, loads_, part * dt, state_, work_);
      done += part;
    } catch (const beam::NoEquilibrium&) {
      if (part <= smallest) throw;
      part /= 2;
    }
}

void go_through_stages(const settings::Case& c, Real slower, const Watch& watch, LineOnSprings& line)
{
  constexpr Real most_node_steps = 5e5;
  LineLoads before = line.of_case().laid();
  Real steps_left = most_node_steps / static_cast<Real>(line.of_case().line.nodes());
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const settings::StageSettings& stage = c.stage[k];
    if (stage.kind != settings::StageKind::pipeline) continue;
    const Real end = slower * *stage.until.time;
    for (Real time = 0; time < end;) {
      if (--steps_left < 0) return;
      const Real left = end - time, dt = std::min(left, next_step_of(line));
      time = dt < left ? time + dt : end;
      try {
        line.step(loads_in(stage, before, time / slower), dt);
      } catch (const beam::NoEquilibrium&) {
        return;
      }
      watch.step(k, dt);
    }
    const LineLoads now = end_of(stage, before);
    if (!watch.stage_end(k, before, now)) return;
    before = now;
  }
}

}  // namespace berm::slices
