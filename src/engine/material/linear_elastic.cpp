// SPDX-License-Identifier: BSD-3-Clause
#include "material/linear_elastic.hpp"

#include "material/describe_elasticity.hpp"

namespace berm::material {

void describe(Describe& d, LinearElastic& law)
{
  describe_elasticity(d, law);
}

}  // namespace berm::material
