// SPDX-License-Identifier: BSD-3-Clause
#include "beam/line.hpp"

#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::beam {

Index Line::across(Plane plane, Index node) const
{
  const auto found = std::find(planes.begin(), planes.end(), plane);
  if (found == planes.end()) throw std::logic_error("the line does not move in that plane");
  return axial(node) + 1 + 2 * static_cast<Index>(found - planes.begin());
}

Index Line::freedom(Direction direction, Index node) const
{
  if (direction == Direction::axial) return axial(node);
  return across(direction == Direction::lateral ? Plane::lateral : Plane::vertical, node);
}

bool Line::moves(Plane plane) const
{
  return std::find(planes.begin(), planes.end(), plane) != planes.end();
}

Line straight_line(std::vector<Real> x, const Section& section, std::vector<Plane> planes)
{
  if (x.size() < 2) throw InputError(fmt::format("a line has {} nodes: it has two at least", x.size()));
  for (std::size_t i = 1; i < x.size(); ++i)
    if (!(x[i] > x[i - 1]))
      throw InputError(fmt::format("node {} of a line is at {} m, the one before it at {} m: they ascend", i, x[i], x[i - 1]));
  Line line;
  line.planes = std::move(planes);
  line.x = std::move(x);
  line.section.assign(line.x.size() - 1, section);
  line.shape.assign(line.freedoms(), 0);
  line.held.assign(line.freedoms(), 0);
  return line;
}

std::vector<Real> graded_nodes(Real size, Real fine, Real growth, Real longest, Real end)
{
  std::vector<Real> x = {0};
  for (Real h = size; x.back() < end * (1 - 1e-9);) {
    if (x.back() > fine * (1 - 1e-9)) h = std::min(longest, h * growth);
    x.push_back(x.back() + h);
  }
  return x;
}

void set_shape(Line& line, Plane plane, const std::function<Real(Real)>& displacement, const std::function<Real(Real)>& slope)
{
  for (Index i = 0; i < line.nodes(); ++i) {
    line.shape[line.across(plane, i)] = displacement(line.x[i]);
    line.shape[line.across(plane, i) + 1] = slope(line.x[i]);
  }
}

void hold(Line& line, Index node, EndCondition condition)
{
  if (condition == EndCondition::free) return;
  line.held[line.axial(node)] = 1;
  for (const Plane plane : line.planes) {
    const Index displacement = line.across(plane, node);
    // Around the vertical axis the weight looks the same.
    const bool mirrored = condition == EndCondition::symmetric || (condition == EndCondition::antisymmetric && plane == Plane::vertical);
    line.held[displacement] = !mirrored;
    line.held[displacement + 1] = mirrored || condition == EndCondition::clamped;
  }
}

std::vector<Real> lengths_of_nodes(const Line& line, Real from, Real to)
{
  std::vector<Real> lengths(line.nodes());
  for (Index i = 0; i < line.nodes(); ++i) {
    const Real lower = i == 0 ? line.x[i] : (line.x[i - 1] + line.x[i]) / 2;
    const Real upper = i + 1 == line.nodes() ? line.x[i] : (line.x[i] + line.x[i + 1]) / 2;
    lengths[i] = std::max(0.0, std::min(upper, to) - std::max(lower, from));
  }
  return lengths;
}

void add_springs(Line& line, Direction direction, SpringLaw law, const std::vector<Real>& lengths, Real level)
{
  check(law);
  line.laws.push_back(std::move(law));
  for (Index i = 0; i < line.nodes(); ++i) {
    if (!(lengths[i] > 0)) continue;
    Spring spring;
    spring.node = i;
    spring.freedom = line.freedom(direction, i);
    spring.law = static_cast<Index>(line.laws.size()) - 1;
    spring.length = lengths[i];
    spring.origin = std::isnan(level) ? line.shape[spring.freedom] : level;
    line.springs.push_back(spring);
  }
}

void add_macro_elements(Line& line, const berm_macro_element_parameters& parameters, const std::vector<Real>& lengths,
                        const berm_macro_element_state& laid)
{
  if (!line.moves(Plane::lateral) || !line.moves(Plane::vertical))
    throw InputError("a macro-element couples axial, lateral and vertical motion: its line moves in both planes");
  const double there[3] = {laid.x, laid.u, laid.w};
  berm_macro_element_state tried;
  double F[3];
  if (const int error = berm_macro_element_step(&parameters, &laid, there, &tried, F, nullptr); error != BERM_MACRO_ELEMENT_OK)
    throw InputError(fmt::format("a macro-element of the line: {}", berm_macro_element_error(error)));
  line.macro_soils.push_back({parameters, laid});
  for (Index i = 0; i < line.nodes(); ++i)
    if (lengths[i] > 0) line.macro_elements.push_back({i, static_cast<Index>(line.macro_soils.size()) - 1, lengths[i]});
}

}  // namespace berm::beam
