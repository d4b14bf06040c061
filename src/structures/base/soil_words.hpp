// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/body_soil.hpp"
#include "problem/case.hpp"

namespace berm::base {

/// The layers of a soil downwards, or its regions: "\"sand\", from 5 mm down \"clay\"".
std::string layers_in_words(const problem::BodySoil& soil);

/// What `berm check` says of bodies whose soil varies, line by line: their layers or regions, and strength and stiffness at the surface and at the lowest
/// point that the main rigid body reaches in a push.
std::vector<std::string> soil_words(const problem::Case& c);

}  // namespace berm::base
