// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::driven {

/// A rigid body that is pushed into the bed, by w against V, and dragged along it, by u against H: what any such body has, a pipe, a cone or an anchor. Its
/// results follow its path: the ways that it goes, and the states between them.
base::Reading reading();

/// The same of a body whose push another reading tells: its numbers without V in the push, its charts, and no words.
base::Reading reading_without_push();

}  // namespace berm::driven
