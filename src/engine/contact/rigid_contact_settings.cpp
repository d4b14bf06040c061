// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/rigid_contact_test.cpp
#include "contact/rigid_contact_settings.hpp"

namespace berm::contact {

void describe(Describe& d, RigidContactSettings& contact)
{
  d.value("rigid", contact.rigid, {.meaning = "name of one rigid body", .required = true});
  d.value("other_rigid", contact.other_rigid, {.meaning = "name of the other", .required = true});
  d.value("friction_angle", contact.friction_angle,
          {.meaning = "Coulomb friction angle between them", .unit = "rad", .range = {0, 89.9 * degree}, .required = true});
  d.value(
      "restitution", contact.restitution,
      {.meaning = "coefficient of restitution: normal speed of separation after an impact divided by that of approach", .range = {0, 1}});
}

}  // namespace berm::contact
