// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm {

/// When the contact of a node is corrected within a step (paper, section 2.2).
enum class Scheme {
  twice,  ///< steps 4 and 8: accelerations and re-mapped velocities
  once    ///< step 4 only
};

/// Which nodes are in contact.
enum class Detection {
  gap,     ///< the approach velocity is compared with the gap that the nearest particles still have
  overlap  ///< every node that both the soil and the rigid body reach through a cell, as published
};

/// Frictional contact between a deformable and a rigid body.
struct ContactSettings {
  std::string body, rigid;
  Real friction_angle = 0;  ///< rad
  Real adhesion = 0;        ///< Pa
  Scheme scheme = Scheme::twice;
  Detection detection = Detection::gap;
  Real approach_steps = 20;  ///< T/dt: a gap closes over this many steps
};

void describe(Describe& d, ContactSettings& contact);

}  // namespace berm
