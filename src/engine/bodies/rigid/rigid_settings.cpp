// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "bodies/rigid/rigid_settings.hpp"

namespace berm::bodies {

void describe(Describe& d, RigidSettings& rigid)
{
  describe_shape(d, rigid.shape);
  d.value("mass", rigid.mass,
          {.meaning =
               "mass per metre run (around an axis and in space: mass in kg); a direction that a force moves needs it: more than that "
               "of the soil in the cells under the body, else the force oscillates from step to step",
           .unit = "kg/m",
           .range = not_negative});
  d.choice("motion", rigid.motion, {"driven", "free"},
           {.meaning = "motion where no stage drives it: none, or by gravity and its contacts (except in a geostatic stage)"});
  d.value(
      "velocity", rigid.velocity,
      {.meaning = "velocity of a free body at the start of the first stage that is not geostatic, as of a dropped object; absent = at rest",
       .unit = "m/s"});
  d.choice("rotation", rigid.rotation, {"fixed", "free"}, {.meaning = "whether the moment of its contacts rotates it about its centre"});
  d.value("moment_of_inertia", rigid.moment_of_inertia,
          {.meaning = "moment of inertia per metre run about its centre (in space: in kg m2, about every axis); absent = that of a solid "
                      "of this shape and mass",
           .unit = "kg m",
           .range = positive});
  d.value("depth_slices", rigid.depth_slices,
          {.meaning = "number of slices of equal height into which its embedded part at the start is divided, for the forces of the soil "
                      "by depth: p-y curves "
                      "and shaft friction of a pile (docs/how_to/penetrate.md)",
           .range = {0, 100}});
  d.value("structure", rigid.structure,
          {.meaning = "structure whose results are reported: automatic takes it from shape, ground and stages (docs/how_to/penetrate.md)"});
}

void check(Describe& d, const std::string& path, const RigidSettings& rigid, int dimension)
{
  std::visit([&](const auto& shape) { check(d, path, shape, dimension); }, rigid.shape);
  d.check(rigid.motion == Motion::driven || rigid.mass > 0, path + ".motion", "a free body needs a mass");
  d.check(rigid.velocity.empty() || rigid.motion == Motion::free, path + ".velocity",
          "is that of a free body where it begins: add motion = \"free\", or drive the body by the velocity of a stage");
  d.check(rigid.velocity.empty() || static_cast<int>(rigid.velocity.size()) == dimension, path + ".velocity",
          dimension == 2 ? "needs two components" : "needs three components");
  if (rigid.rotation == Rotation::free) {
    d.check(is_bounded(make_shape<2>(rigid.shape)), path + ".rotation", "a half-plane cannot rotate");
    d.check(rigid.mass > 0 || rigid.moment_of_inertia, path + ".rotation", "a body that rotates needs a mass or a moment_of_inertia");
  }
}

}  // namespace berm::bodies
