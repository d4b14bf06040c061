// SPDX-License-Identifier: BSD-3-Clause
#include "beam/assembly.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::beam {
namespace {

constexpr int max_freedoms = 10;  // of an element

/// Residual and lower half of the tangent of one element, by its freedoms.
struct ElementSums {
  Real residual[max_freedoms] = {};
  Real tangent[max_freedoms][max_freedoms] = {};
};

/// Bending, inertia and damping in one plane, and what the membrane does there; `gradient` gets the derivative of L epsilon.
void add_plane(const Line& line, Index e, int plane, const ElementNow& now, const TimeTerms& terms, const Work& work, ElementSums& sums,
               Real* gradient)
{
  const Index size = line.freedoms_of_node(), first = line.axial(e) + 1 + 2 * plane, second = first + size;
  const Real L = now.length, EI = line.section[e].bending_stiffness / (L * L * L), mass = line.section[e].mass * L,
             xi = line.damping[plane];
  const auto ends = [&](const std::vector<Real>& of) { return at_ends(&of[first], &of[second], L); };
  const AtEnds d = ends(work.displacement), shape = ends(line.shape), predicted = ends(work.predicted), v = ends(work.predicted_velocity);
  AtEnds bent, push;  // push: acceleration and damping
  for (int i = 0; i < 4; ++i) {
    const Real since = d[i] - predicted[i];
    bent[i] = d[i] - shape[i];
    push[i] = terms.acceleration * since + xi * (v[i] + terms.velocity * since);
  }
  const AtEnds of_bending = bending.times(bent), of_stretching = stretching.times(d), of_inertia = inertia.times(push);
  const Real scale[4] = {1, L, 1, L};
  const Index at[4] = {1 + 2 * plane, 2 + 2 * plane, size + 1 + 2 * plane, size + 2 + 2 * plane};
  const Real of_mass = mass * (terms.acceleration + xi * terms.velocity);
  for (int i = 0; i < 4; ++i) {
    gradient[at[i]] = scale[i] * of_stretching[i] / L;
    sums.residual[at[i]] += scale[i] * (EI * of_bending[i] + mass * of_inertia[i]);
    for (int j = 0; j <= i; ++j)
      sums.tangent[at[i]][at[j]] +=
          scale[i] * scale[j] * (EI * bending.entry[i][j] + now.force / L * stretching.entry[i][j] + of_mass * inertia.entry[i][j]);
  }
}

void add_element(const Line& line, Index e, const Loads& loads, const TimeTerms& terms, Work& work)
{
  const Index size = line.freedoms_of_node(), first = line.axial(e), second = first + size;
  const ElementNow now = membrane(line, e, work.displacement, loads.constrained_force[e]);
  ElementSums sums;
  Real gradient[max_freedoms] = {};
  gradient[0] = -1, gradient[size] = 1;
  for (int plane = 0; plane < static_cast<int>(line.planes.size()); ++plane) add_plane(line, e, plane, now, terms, work, sums, gradient);
  const Real mass = line.section[e].axial_mass * now.length / 6 * terms.acceleration, EA = line.section[e].axial_stiffness / now.length;
  const Real a = work.displacement[first] - work.predicted[first], b = work.displacement[second] - work.predicted[second];
  sums.residual[0] += mass * (2 * a + b);
  sums.residual[size] += mass * (a + 2 * b);
  sums.tangent[0][0] += 2 * mass, sums.tangent[size][0] += mass, sums.tangent[size][size] += 2 * mass;
  work.largest_force = std::max(work.largest_force, std::abs(now.force));
  for (Index i = 0; i < 2 * size; ++i) {
    work.largest_force = std::max(work.largest_force, std::abs(sums.residual[i]) / work.unit[first + i]);
    work.residual[first + i] += sums.residual[i] + now.force * gradient[i];
    for (Index j = 0; j <= i; ++j) work.tangent.add(first + i, first + j, sums.tangent[i][j] + EA * gradient[i] * gradient[j]);
  }
}

/// Force and tangent of a macro-element; the element's state there goes into `work`.
void add_macro_element(const Line& line, const State& state, std::size_t m, Work& work)
{
  const MacroElement& element = line.macro_elements[m];
  const MacroSoil& soil = line.macro_soils[element.soil];
  const Index at[3] = {line.axial(element.node), line.across(Plane::lateral, element.node), line.across(Plane::vertical, element.node)};
  constexpr Real sign[3] = {1, 1, -1};  // the macro-element's w is downwards
  double to[3] = {soil.laid.x, soil.laid.u, soil.laid.w}, F[3], K[3][3];
  for (int i = 0; i < 3; ++i) to[i] += sign[i] * (work.displacement[at[i]] - line.shape[at[i]]);
  if (const int error = berm_macro_element_step(&soil.parameters, &state.macro_elements[m], to, &work.macro_elements[m], F, K);
      error != BERM_MACRO_ELEMENT_OK)
    throw NoEquilibrium(
        fmt::format("the pipeline does not reach equilibrium after t = {:.6g} s: the macro-element at x = {:.6g} m has no solution: {}; "
                    "a smaller step may find one",
                    state.time, line.x[element.node], berm_macro_element_error(error)));
  for (int i = 0; i < 3; ++i) {
    work.residual[at[i]] += element.length * sign[i] * F[i];
    for (int j = 0; j <= i; ++j)
      work.tangent.add(std::max(at[i], at[j]), std::min(at[i], at[j]), element.length * sign[i] * sign[j] * (K[i][j] + K[j][i]) / 2);
  }
}

}  // namespace

Work::Work(const Line& line)
    : displacement(line.freedoms()),
      predicted(line.freedoms()),
      predicted_velocity(line.freedoms()),
      residual(line.freedoms()),
      unit(line.freedoms(), 1),
      tangent(line.freedoms(), 2 * line.freedoms_of_node() - 1),
      macro_elements(line.macro_elements.size())
{
  const std::vector<Real> lengths = lengths_of_nodes(line);
  for (Index i = 0; i < line.nodes(); ++i)
    for (const Plane plane : line.planes) unit[line.across(plane, i) + 1] = lengths[i];
}

ElementNow membrane(const Line& line, Index element, const std::vector<Real>& displacement, Real constrained_force)
{
  const Index size = line.freedoms_of_node(), first = line.axial(element), second = first + size;
  const Real L = line.length(element);
  Real stretch = displacement[second] - displacement[first];
  for (Index k = 1; k < size; k += 2)
    stretch += (stretching.square(at_ends(&displacement[first + k], &displacement[second + k], L)) -
                stretching.square(at_ends(&line.shape[first + k], &line.shape[second + k], L))) /
               (2 * L);
  return {L, stretch / L, line.section[element].axial_stiffness * stretch / L - constrained_force};
}

void assemble(const Line& line, const State& state, const Loads& loads, const TimeTerms& terms, Work& work)
{
  work.tangent.set_zero();
  std::fill(work.residual.begin(), work.residual.end(), 0.0);
  work.largest_force = 0;
  for (Index e = 0; e < line.elements(); ++e) add_element(line, e, loads, terms, work);
  for (std::size_t s = 0; s < line.springs.size(); ++s) {
    const Spring& spring = line.springs[s];
    if (!acts(line, state, spring)) continue;
    const SpringForce now = force_of(line.laws[spring.law], state.springs[s], work.displacement[spring.freedom]);
    const Real length = spring.length * state.spring_factor[s];
    work.residual[spring.freedom] += length * now.force;
    work.tangent.add(spring.freedom, spring.freedom, length * now.stiffness);
  }
  for (std::size_t m = 0; m < line.macro_elements.size(); ++m) add_macro_element(line, state, m, work);
  for (Index i = 0; i < line.freedoms(); ++i) {
    const Real velocity = work.predicted_velocity[i] + terms.velocity * (work.displacement[i] - work.predicted[i]);
    work.residual[i] += loads.impedance[i] * (velocity - loads.velocity_then[i]) - loads.force[i];
    work.tangent.add(i, i, loads.impedance[i] * terms.velocity);
    work.largest_force = std::max(work.largest_force, std::abs(loads.force[i]) / work.unit[i]);
    if (line.held[i] == 0) continue;
    work.residual[i] = 0;
    work.tangent.set_unit(i);
  }
}

}  // namespace berm::beam
