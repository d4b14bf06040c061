// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/measure.hpp"

#include "core/for_each.hpp"

namespace berm {

template <int dim>
BodySums<dim> measure(const Particles<dim>& particles)
{
  const auto& occupied = particles.occupied();
  return sum_of<BodySums<dim>>("measure", static_cast<Index>(occupied.size()), [&](Index c) {
    BodySums<dim> sums;
    Index left = particles.count_in(occupied[c]);
    for (Index b = particles.first_block(occupied[c]); left > 0; b = particles.block(b).next, left -= lanes) {
      const Block<dim>& p = particles.block(b);
      Lanes square{};
      for (int d = 0; d < dim; ++d) {
        square += p.v[d] * p.v[d];
        sums.momentum[d] += sum(p.mass * p.v[d]);
        sums.moment[d] += sum(p.mass * p.x[d]);
      }
      sums.mass += sum(p.mass);
      sums.kinetic += 0.5 * sum(p.mass * square);
    }
    return sums;
  });
}

template <int dim>
Real momentum_error(const State<dim>& state)
{
  Vec<dim> now = Vec<dim>::Zero();
  for (const Particles<dim>& particles : state.particles) now += measure(particles).momentum;
  const Totals<dim>& t = state.totals;
  const Vec<dim> given = t.gravity_impulse + t.contact_impulse + t.support_impulse + t.damping_impulse;
  const Real size =
      t.first_momentum.norm() + t.gravity_impulse.norm() + t.contact_impulse.norm() + t.support_impulse.norm() + t.damping_impulse.norm();
  return size > 0 ? (now - t.first_momentum - given).norm() / size : 0;
}

template <int dim>
Vec<dim> position_of(const Particles<dim>& particles, std::int32_t id)
{
  Vec<dim> x = Vec<dim>::Constant(std::numeric_limits<Real>::quiet_NaN());
  particles.visit([&](Index, Index b, int l) {
    if (particles.block(b).id[l] == id)
      for (int d = 0; d < dim; ++d) x[d] = particles.block(b).x[d][l];
  });
  return x;
}

template BodySums<2> measure(const Particles<2>&);
template BodySums<3> measure(const Particles<3>&);
template Real momentum_error(const State<2>&);
template Real momentum_error(const State<3>&);
template Vec<2> position_of(const Particles<2>&, std::int32_t);
template Vec<3> position_of(const Particles<3>&, std::int32_t);

}  // namespace berm
