// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/structures_test.cpp
#include "structures/base/structure.hpp"

#include "core/error.hpp"

namespace berm::base {

EmbeddedBody Structure::embedded(const problem::Case&) const
{
  throw KeyError("stage: an envelope needs a push or a drag by velocity, of a rigid body whose envelope is known");
}

}  // namespace berm::base
