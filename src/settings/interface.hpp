// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/body_soil.hpp"
#include "settings/case.hpp"

namespace berm::settings {

/// Where a contact keeps what it remembers among the extra numbers of a particle; none where it does not.
struct InterfaceMemory {
  int bond = none;  ///< a Bond
  int slip = none;  ///< m, sliding distance along the rigid body
};

/// The undrained strength of undisturbed soil, Pa; empty where its strength depends on the pressure, or it has none.
std::optional<Real> undrained_strength(const material::Material& soil);

/// The fields of a body's particles in which its contacts remember, after those of its soil.
std::vector<FieldInfo> memory_fields(const Case& c, const std::string& body);

/// Where the contact number `contact` remembers.
InterfaceMemory memory_of(const Case& c, Index contact);

/// Refuses what does not go together in the table at `path` ("contact.skin").
void check_interface(Describe& d, const Case& c, const std::string& path, const contact::ContactSettings& contact);

}  // namespace berm::settings
