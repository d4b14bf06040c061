// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::contact {

/// When contact is corrected within a step (paper, section 2).
enum class Scheme {
  two_sided,  ///< one impulse: step 8 completes that of step 4
  twice,      ///< steps 4 and 8: accelerations and re-mapped velocities
  once,       ///< step 4 only
  hybrid,     ///< step 4; nodes in contact then move and strain with that velocity (update stress last), all others with the re-mapped one
  usf,        ///< update stress first: the velocities before the step, which strain, and those after it, which move
  sticky      ///< one velocity field: what touches neither slides nor parts
};

/// Where two bodies are in contact.
enum class Detection {
  automatic,  ///< particle at a rigid body, gap between deformable ones
  gap,        ///< nodes: the approach velocity is compared with the gap that the nearest particles still have
  overlap,    ///< every node that both bodies reach through a cell, as published
  distance,   ///< nodes whose nearest particles touch
  particle    ///< particles at the surface of a rigid body instead of nodes, with the rule for the gap
};

/// Frictional contact of a deformable body with a rigid one or another deformable one.
struct ContactSettings {
  std::string body;
  std::string rigid, other_body;  ///< one of the two; the other is empty
  Real friction_angle = 0;        ///< rad
  Real adhesion = 0;              ///< Pa
  Scheme scheme = Scheme::two_sided;
  Detection detection = Detection::automatic;
  Real gap_closing_steps = 20;  ///< T/dt: a gap closes over this many steps
};

void describe(Describe& d, ContactSettings& contact);

}  // namespace berm::contact
