// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

constexpr std::size_t max_rigid_contacts = 16;

/// Whether a stage drives a rigid body, or it is free.
bool may_move(const Case& c, const std::string& rigid);

/// Refuses contacts of rigid bodies that make no sense by themselves.
void check_rigid_contacts(Describe& d, const Case& c);

}  // namespace berm::settings
