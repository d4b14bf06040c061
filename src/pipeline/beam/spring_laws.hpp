// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <variant>
#include <vector>

namespace berm::beam {

/// A point of a curve of resistance over displacement.
struct CurvePoint {
  Real displacement = 0;  ///< m
  Real force = 0;         ///< N/m
};

/// Resistance over displacement, the same in both directions: straight lines from zero through the points, constant after the last. Displacements ascend, forces are positive, and no line is
/// steeper than the first, whose slope is the elastic stiffness.
struct Backbone {
  std::vector<CurvePoint> points;

  Real stiffness() const { return points.front().force / points.front().displacement; }
  Real force(Real u) const;  ///< u >= 0
  Real slope(Real u) const;  ///< at u > 0; at a point that of the line after it
};

/// Force k u.
struct LinearSpring {
  Real stiffness = 0;  ///< N/m2
};

/// Force k u where u <= 0, none beyond: a bed without tension, a wall.
struct OneSidedSpring {
  Real stiffness = 0;  ///< N/m2
};

/// Elastic, then sliding along its backbone. Where it goes back it is elastic with the first stiffness, up to the resistance on that side; a side remembers how far it has been: between the farthest displacements
/// the resistance is that which the backbone has there, beyond them the backbone goes on. So resistance that was lost stays lost, and a berm counts from where the line was laid. With one point it is
/// Coulomb's friction, against the motion.
struct PlasticSpring {
  Backbone backbone;
};

/// The force of the backbone at any time: against the displacement, as in Hobbs' solutions, and not against the motion.
struct HolonomicSpring {
  Backbone backbone;
};

/// The closed list of laws. Forces are per metre of the line, or of one spring whose length counts as 1.
using SpringLaw = std::variant<LinearSpring, OneSidedSpring, PlasticSpring, HolonomicSpring>;

/// Coulomb's friction: elastic up to the mobilisation (m), then the limit (N/m).
PlasticSpring friction(Real limit, Real mobilisation);

/// What a spring remembers.
struct SpringState {
  Real origin = 0;                 ///< m, the displacement at which it began, without force
  Real slip = 0;                   ///< m, from there: where it has no force now; of a plastic spring, like the farthest displacements
  Real forward = 0, backward = 0;  ///< m, from there to either side, while it slid; positive
};

/// Resistance of a spring at a displacement, and how it changes with it.
struct SpringForce {
  Real force = 0;      ///< N/m, along the displacement that it resists
  Real stiffness = 0;  ///< N/m2, the derivative of that function
  bool slides = false;
};

/// At a displacement u (m) after the last accepted state.
SpringForce force_of(const SpringLaw& law, const SpringState& state, Real u);

/// The state once that displacement is accepted.
SpringState accepted(const SpringLaw& law, const SpringState& state, Real u);

/// Throws InputError where the numbers of a law make no sense.
void check(const SpringLaw& law);

}  // namespace berm::beam
