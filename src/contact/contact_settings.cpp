// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "contact/contact_settings.hpp"

namespace berm::contact {

void describe(Describe& d, ContactSettings& contact)
{
  d.value("body", contact.body, {.meaning = "name of the deformable body", .required = true});
  d.value("rigid", contact.rigid, {.meaning = "name of the rigid body that it touches; or"});
  d.value("other_body", contact.other_body, {.meaning = "name of the deformable body that it touches"});
  d.value("friction_angle", contact.friction_angle,
          {.meaning = "Coulomb friction angle of the interface", .unit = "rad", .range = {0, 89.9 * pi / 180}, .required = true});
  d.value("adhesion", contact.adhesion,
          {.meaning = "shear strength of the interface without normal stress", .unit = "Pa", .range = not_negative});
  d.choice("scheme", contact.scheme, {"two_sided", "twice", "once", "hybrid", "usf", "sticky"},
           {.meaning = "correction in step 4 of the algorithm, whose impulse step 8 completes (at nodes: keeps together in step 8); in "
                       "both steps on their own (as "
                       "published); in step 4 only; in step 4 with nodes in contact updated stress last; update "
                       "stress first (of all contacts or none); or no relative motion at all"});
  d.choice("detection", contact.detection, {"automatic", "gap", "overlap", "distance", "particle"},
           {.meaning = "automatic: particle at a rigid body, gap between deformable ones. In contact are: nodes whose particles have "
                       "closed their gap, at a speed that the gap allows; nodes that both bodies "
                       "reach (as published); nodes whose particles touch; or particles at the surface of a rigid body"});
  d.value("gap_closing_steps", contact.gap_closing_steps,
          {.meaning = "steps over which detection by gap or particle lets a gap close", .range = {1, 1000}, .formerly = "approach_steps"});
}

}  // namespace berm::contact
