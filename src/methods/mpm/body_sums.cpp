// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/body_sums.hpp"

#include "core/ranks.hpp"
#include "os/error.hpp"

namespace berm::mpm {

template <int dim>
Vec<3> BodySums<dim>::angular_momentum() const
{
  Vec<3> of_center = Vec<3>::Zero();
  const Vec<dim> x = center();
  if constexpr (dim == 3) {
    of_center[0] = x[1] * momentum[2] - x[2] * momentum[1];
    of_center[1] = x[2] * momentum[0] - x[0] * momentum[2];
  }
  of_center[2] = x[0] * momentum[1] - x[1] * momentum[0];
  return moment_of_momentum - of_center;
}

template <int dim>
BodySums<dim> sums_over(const bodies::Particles<dim>& particles)
{
  const auto& occupied = particles.occupied();
  return sum_of<BodySums<dim>>("measure", particles.chunks(), [&](Index c) {
    BodySums<dim> sums;
    for (const auto& [p, b, count] : particles.blocks_in(occupied[c])) {
      Lanes square{};
      for (int d = 0; d < dim; ++d) {
        square += p.v[d] * p.v[d];
        sums.momentum[d] += sum(p.mass * p.v[d]);
        sums.moment[d] += sum(p.mass * p.x[d]);
        // Lanes without a particle have a finite position, which is no part of the body.
        for (int l = 0; l < count; ++l) {
          sums.lower[d] = std::min(sums.lower[d], p.x[d][l]);
          sums.upper[d] = std::max(sums.upper[d], p.x[d][l]);
        }
      }
      if constexpr (dim == 3) {
        sums.moment_of_momentum[0] += sum(p.mass * (p.x[1] * p.v[2] - p.x[2] * p.v[1]));
        sums.moment_of_momentum[1] += sum(p.mass * (p.x[2] * p.v[0] - p.x[0] * p.v[2]));
      }
      sums.moment_of_momentum[2] += sum(p.mass * (p.x[0] * p.v[1] - p.x[1] * p.v[0]));
      sums.mass += sum(p.mass);
      sums.kinetic += 0.5 * sum(p.mass * square);
    }
    sums.fastest = std::sqrt(2 * sums.kinetic / sums.mass);
    return sums;
  });
}

template <int dim>
Real momentum_error(const problem::State<dim>& state, mesh::Metric metric)
{
  const auto size_of = [&](Vec<dim> v) {
    if (metric == mesh::Metric::axisymmetric) v[0] = 0;
    return v.norm();
  };
  Vec<dim> now = Vec<dim>::Zero();
  Real moving = 0;  // the momentum if all particles moved in one direction
  for (const bodies::Particles<dim>& particles : state.particles) {
    const BodySums<dim> sums = sums_over(particles);
    now += sums.momentum;
    moving += std::sqrt(2 * sums.mass * sums.kinetic);
  }
  now += taken_out(state).momentum;
  const Vec<dim>& first = state.ledger.totals.first_momentum;
  Vec<dim> given = Vec<dim>::Zero();
  Real size = moving + size_of(first);
  for_each_row(problem::rows_of_run<dim>, [&](const auto& row) {
    const auto& sum = state.ledger.totals.*row.member;
    if constexpr (std::is_same_v<decltype(sum), const Vec<dim>&>)
      if (row.balance == problem::Balance::momentum) given += sum, size += size_of(sum);
  });
  return size > 0 ? size_of(now - first - given) / size : 0;
}

template <int dim>
bodies::Particle<dim> particle_of(const bodies::Particles<dim>& particles, std::int32_t id)
{
  Index block = none;
  int lane = 0;
  particles.visit([&](Index, Index b, int l) {
    if (particles.block(b).id[l] == id) block = b, lane = l;
  });
  std::vector<bodies::Particle<dim>> found, all;
  if (block != none) found.push_back(particles.read(block, lane));
  Ranks::of_run().gather(found, all);
  if (all.empty()) throw RunError("there is no particle " + std::to_string(id));
  return all.front();
}

template struct BodySums<2>;
template struct BodySums<3>;
template BodySums<2> sums_over(const bodies::Particles<2>&);
template BodySums<3> sums_over(const bodies::Particles<3>&);
template Real momentum_error(const problem::State<2>&, mesh::Metric);
template Real momentum_error(const problem::State<3>&, mesh::Metric);
template bodies::Particle<2> particle_of(const bodies::Particles<2>&, std::int32_t);
template bodies::Particle<3> particle_of(const bodies::Particles<3>&, std::int32_t);

}  // namespace berm::mpm
