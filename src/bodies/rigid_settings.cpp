// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid_settings.hpp"

namespace berm {

void describe(Describe& d, CircleSettings& circle)
{
  d.value("center", circle.center, {.meaning = "centre of the circle", .unit = "m", .required = true});
  d.value("diameter", circle.diameter, {.meaning = "diameter D of the circle", .unit = "m", .range = positive, .required = true});
}

void describe(Describe& d, HalfPlaneSettings& plane)
{
  d.value("point", plane.point, {.meaning = "a point of the surface", .unit = "m", .required = true});
  d.value("normal", plane.normal, {.meaning = "direction out of the rigid body, of any length", .required = true});
}

void describe(Describe& d, BoxSettings& box)
{
  d.value("center", box.center, {.meaning = "centre of the box", .unit = "m", .required = true});
  d.value("size", box.size, {.meaning = "lengths of its sides", .unit = "m", .range = positive, .required = true});
  d.value("angle", box.angle, {.meaning = "turn of the box, counter-clockwise", .unit = "rad", .range = {-pi, pi}});
}

void describe(Describe& d, RigidSettings& rigid)
{
  d.one_of("shape", rigid.shape, {"circle", "half_plane", "box"}, {.meaning = "exact surface of the body", .required = true});
  d.value("mass", rigid.mass,
          {.meaning = "mass per metre run (in space: mass in kg); a direction that a force drives needs it",
           .unit = "kg/m",
           .range = not_negative});
}

}  // namespace berm
