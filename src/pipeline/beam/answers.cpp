// SPDX-License-Identifier: BSD-3-Clause
#include "beam/answers.hpp"

#include "beam/assembly.hpp"

#include <algorithm>
#include <cmath>

namespace berm::beam {
namespace {

/// What an element has bent to in a plane.
AtEnds bent(const Line& line, const State& state, Plane plane, Index element)
{
  const Index a = line.across(plane, element), b = line.across(plane, element + 1);
  AtEnds now = at_ends(&state.displacement[a], &state.displacement[b], line.length(element));
  const AtEnds shape = at_ends(&line.shape[a], &line.shape[b], line.length(element));
  for (int i = 0; i < 4; ++i) now[i] -= shape[i];
  return now;
}

Real curvature_in(const Line& line, const State& state, Plane plane, Index element, Real s)
{
  const Real L = line.length(element);
  return curving(bent(line, state, plane, element), s) / (L * L);
}

/// The mean over the elements of a node of what a function of an element and of the place in it is.
template <class Of>
Real mean_at(const Line& line, Index node, const Of& of)
{
  if (node == 0) return of(node, 0);
  if (node == line.elements()) return of(node - 1, 1);
  return (of(node - 1, 1) + of(node, 0)) / 2;
}

}  // namespace

Real effective_force(const Line& line, const State& state, Index element)
{
  return membrane(line, element, state.displacement, state.constrained_force[element]).force;
}

Real curvature(const Line& line, const State& state, Plane plane, Index node)
{
  return mean_at(line, node, [&](Index e, Real s) { return curvature_in(line, state, plane, e, s); });
}

Real moment(const Line& line, const State& state, Plane plane, Index node)
{
  return mean_at(line, node, [&](Index e, Real s) { return line.section[e].bending_stiffness * curvature_in(line, state, plane, e, s); });
}

Index crown(const Line& line, const State& state, bool from_shape)
{
  const auto gone = [&](Index node) {
    const Index at = line.across(Plane::lateral, node);
    return std::abs(state.displacement[at] - (from_shape ? line.shape[at] : 0));
  };
  Index found = 0;
  for (Index i = 1; i < line.nodes(); ++i)
    if (gone(i) > gone(found)) found = i;
  return found;
}

Real largest_moment(const Line& line, const State& state)
{
  Real largest = 0;
  for (Index i = 0; i < line.nodes(); ++i) largest = std::max(largest, std::abs(moment(line, state, Plane::lateral, i)));
  return largest;
}

Real shear(const Line& line, const State& state, Plane plane, Index element)
{
  const Real change = curvature_in(line, state, plane, element, 1) - curvature_in(line, state, plane, element, 0);
  return line.section[element].bending_stiffness * change / line.length(element);
}

FibreStrain longitudinal_strain(const Line& line, const State& state, Index element)
{
  const Real mean = membrane(line, element, state.displacement, 0).strain;
  Real bending_squared = 0;
  for (const Real s : {0.0, 1.0}) {
    Real squared = 0;
    for (const Plane plane : line.planes) {
      const Real strain = line.section[element].radius * curvature_in(line, state, plane, element, s);
      squared += strain * strain;
    }
    bending_squared = std::max(bending_squared, squared);
  }
  return {mean + std::sqrt(bending_squared), mean - std::sqrt(bending_squared)};
}

Real largest_slope(const Line& line, const State& state)
{
  Real largest = 0;
  for (Index i = 0; i < line.nodes(); ++i) {
    Real squared = 0;
    for (const Plane plane : line.planes) {
      const Real slope = state.displacement[line.across(plane, i) + 1];
      squared += slope * slope;
    }
    largest = std::max(largest, squared);
  }
  return std::sqrt(largest);
}

}  // namespace berm::beam
