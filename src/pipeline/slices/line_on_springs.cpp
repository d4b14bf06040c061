// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/slices/springs_beside_test.cpp
#include "slices/line_on_springs.hpp"

#include <algorithm>

namespace berm::slices {
namespace {

problem::Case without_soil(problem::Case c)
{
  c.pipeline->slices.asleep = problem::SliceSleep::always;
  return c;
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

LineOnSprings::LineOnSprings(const problem::Case& c, Real embedment)
    : of_case_(without_soil(c)),
      state_(beam::state_of(of_case_.line)),
      work_(of_case_.line),
      loads_(beam::no_loads(of_case_.line))
{
  if (!of_case_.has_interface()) return;
  const Real weight = of_case_.settings.submerged_weight, along = of_case_.axial_resistance(embedment, weight);
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

}  // namespace berm::slices
