// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/case.hpp"
#include "structures/pipe/pipe_quantities.hpp"

namespace berm::pipe {

/// What the results of a case's pipe are made dimensionless with: the width of the main rigid body, the weight of the body that touches it. The diameter is
/// 0 where there is no pipe, that is no rigid body that a push or drag moves.
PipeScale pipe_scale(const problem::Case& c);

/// The pushes and the drags of a case; held_force is left empty.
PipeStages pipe_stages(const problem::Case& c);

/// The contact of a deformable body with the main rigid body, the last where there are several; null where there is none.
const contact::ContactSettings* contact_of_pipe(const problem::Case& c);

/// The material of that body; null where none touches.
const material::Material* touched_material(const problem::Case& c);

}  // namespace berm::pipe
