// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/scene.hpp"

namespace berm::sanity {

/// How the stages move the bodies that they drive, as far as the input says it.
template <int dim>
std::vector<Way> ways_of(const problem::Model<dim>& model);

/// What a body takes along an axis during a stage.
Span swept(const Scene& s, const Way& way, int d);

/// Whether the way meets the soil of a body, as far as it is known.
bool may_meet(const Scene& s, const Way& way, const BodyScene& soil);

/// Whether it meets any soil that touches the rigid body: a stage may be all in the air.
bool may_meet_soil(const Scene& s, const Way& way);

}  // namespace berm::sanity
