// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::mpm {

/// Sums over the particles of one body.
template <int dim>
struct BodySums {
  Real mass = 0;                               ///< kg/m or kg
  Real kinetic = 0;                            ///< J/m or J
  Real fastest = 0;                            ///< m/s, root mean square velocity in the cell where that is largest
  Vec<dim> momentum = Vec<dim>::Zero();        ///< N s/m or N s
  Vec<dim> moment = Vec<dim>::Zero();          ///< first moment of mass, sum m x; over mass: the centre of mass
  Vec<3> moment_of_momentum = Vec<3>::Zero();  ///< sum x cross m v, angular momentum about the origin, N s or N m s; in 2D about z only
  Vec<dim> lower = Vec<dim>::Constant(infinity), upper = Vec<dim>::Constant(-infinity);  ///< bounding box of the particles' centres

  Vec<dim> center() const { return moment / mass; }
  /// Angular momentum about the centre of mass.
  Vec<3> angular_momentum() const;

  BodySums& operator+=(const BodySums& other)
  {
    mass += other.mass;
    kinetic += other.kinetic;
    fastest = std::max(fastest, other.fastest);
    momentum += other.momentum;
    moment += other.moment;
    moment_of_momentum += other.moment_of_momentum;
    lower = lower.cwiseMin(other.lower);
    upper = upper.cwiseMax(other.upper);
    return *this;
  }
};

template <int dim>
BodySums<dim> sums_over(const bodies::Particles<dim>& particles);

/// Momentum error: |momentum now - momentum at the start - impulses of gravity, tractions, contact, supports and damping|
/// over the sum of the magnitudes of all these and of the momentum if all particles moved in one direction. Round-off where
/// the step is right. In axisymmetry along the axis: across it the stress around it gives momentum.
template <int dim>
Real momentum_error(const problem::State<dim>& state, mesh::Metric metric = mesh::Metric::cartesian);

/// The particle with this id. Throws RunError where there is none.
template <int dim>
bodies::Particle<dim> particle_of(const bodies::Particles<dim>& particles, std::int32_t id);

}  // namespace berm::mpm
