// SPDX-License-Identifier: BSD-3-Clause
#include "boundary/support.hpp"

namespace berm {

void describe(Describe& d, SupportSettings& support)
{
  d.value("boundary", support.boundary, {.meaning = "boundary of the mesh that is held", .required = true});
  d.value("fixed", support.fixed, {.meaning = "directions that are held: \"x\", \"y\", \"z\"", .required = true});
}

}  // namespace berm
