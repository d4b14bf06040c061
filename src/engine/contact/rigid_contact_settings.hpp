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

/// Whether it is between these two, whichever comes first.
inline bool joins(const RigidContactSettings& contact, const std::string& one, const std::string& other)
{
  return (contact.rigid == one && contact.other_rigid == other) || (contact.rigid == other && contact.other_rigid == one);
}

}  // namespace berm::contact
