// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/rigid/triangle_mesh.hpp"

#include <string>

namespace berm::bodies {

/// What is wrong with triangles that should bound a body: how many, and where one of them is. Empty where nothing is: each has an area, two of them meet at
/// each edge, one after the other way round, they contain a volume, do not cut through each other or lie on each other over an area, and no part of the volume is
/// counted twice or less than once: of closed surfaces within each other every second one faces inwards, as that of a cavity does. (All of them may be turned the
/// other way round.) Throws Interrupted where a signal asks to stop.
std::string fault_of(const Triangles& triangles);

}  // namespace berm::bodies
