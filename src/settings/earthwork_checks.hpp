// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "settings/case.hpp"

namespace berm::settings {

/// Refuses fills and excavations that make no sense by themselves.
void check_earthworks(Describe& d, const Case& c);

}  // namespace berm::settings
