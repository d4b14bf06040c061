// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_settings.hpp"

namespace berm {

void describe(Describe& d, ContactSettings& contact)
{
  d.value("body", contact.body, {.meaning = "name of the deformable body", .required = true});
  d.value("rigid", contact.rigid, {.meaning = "name of the rigid body", .required = true});
  d.value("friction_angle", contact.friction_angle,
          {.meaning = "Coulomb friction angle of the interface", .unit = "rad", .range = {0, 89.9 * pi / 180}, .required = true});
  d.value("adhesion", contact.adhesion,
          {.meaning = "shear strength of the interface without normal stress", .unit = "Pa", .range = not_negative});
  d.choice("scheme", contact.scheme, {"twice", "once"}, {.meaning = "correction in steps 4 and 8 of the algorithm, or in step 4 only"});
  d.choice(
      "detection", contact.detection, {"gap", "overlap"},
      {.meaning =
           "a node is in contact once the particles around it have closed their gap, or as soon as both bodies reach it (as published)"});
  d.value("approach_steps", contact.approach_steps, {.meaning = "steps over which detection by gap lets a gap close", .range = {1, 1000}});
}

}  // namespace berm
