// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/triangle_mesh.hpp"

#include <string>

namespace berm::bodies {

/// What is wrong with triangles that should be the closed surface of a body: how many, and where one of them is. Empty where nothing is: each has an area, two of
/// them meet at each edge, one after the other way round, they contain a volume and do not cut through each other. Two flat pieces of the same plane that overlap
/// are not found.
std::string fault_of(const Triangles& triangles);

}  // namespace berm::bodies
