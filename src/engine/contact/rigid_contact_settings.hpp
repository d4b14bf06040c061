// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"

namespace berm::contact {

/// Contact of two rigid bodies.
struct RigidContactSettings {
  std::string rigid, other_rigid;
  Real friction_angle = 0;  ///< rad
  Real restitution = 0;     ///< normal speed after an impact over that before it
};

void describe(Describe& d, RigidContactSettings& contact);

}  // namespace berm::contact
