// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm {

/// Sums over the particles of one body.
template <int dim>
struct BodySums {
  Real mass = 0;                         ///< kg/m or kg
  Real kinetic = 0;                      ///< J/m or J
  Vec<dim> momentum = Vec<dim>::Zero();  ///< N s/m or N s
  Vec<dim> moment = Vec<dim>::Zero();    ///< sum m x; over mass: the centre of mass

  BodySums& operator+=(const BodySums& other)
  {
    mass += other.mass;
    kinetic += other.kinetic;
    momentum += other.momentum;
    moment += other.moment;
    return *this;
  }
};

template <int dim>
BodySums<dim> measure(const Particles<dim>& particles);

/// |momentum now - momentum at the start - impulses of gravity, contact, supports and damping| over the sum of the sizes of all these: round-off.
template <int dim>
Real momentum_error(const State<dim>& state);

/// Position of the particle with this id, m.
template <int dim>
Vec<dim> position_of(const Particles<dim>& particles, std::int32_t id);

}  // namespace berm
