// SPDX-License-Identifier: BSD-3-Clause
#include "beam/loads.hpp"

namespace berm::beam {

Loads no_loads(const Line& line)
{
  const std::vector<Real> none_of_freedoms(line.freedoms(), 0);
  return {none_of_freedoms, none_of_freedoms, none_of_freedoms, std::vector<Real>(line.elements(), 0)};
}

void add_load(const Line& line, Plane plane, Index element, Real per_metre, Loads& loads)
{
  const Real force = per_metre * line.length(element) / 2, moment = force * line.length(element) / 6;
  const Index first = line.across(plane, element), second = line.across(plane, element + 1);
  loads.force[first] += force, loads.force[first + 1] += moment;
  loads.force[second] += force, loads.force[second + 1] -= moment;
}

void add_weight(const Line& line, Loads& loads)
{
  for (Index e = 0; e < line.elements(); ++e) add_load(line, Plane::vertical, e, -line.section[e].submerged_weight, loads);
}

}  // namespace berm::beam
