// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/input/read_case_wrong_inputs_test.cpp
#include "contact/contact_settings.hpp"

#include "core/usual.hpp"

namespace berm::contact {

void describe(Describe& d, SoilInterfaceSettings& soil)
{
  d.value("material", soil.material, {.meaning = "name of a [material.NAME] of the body", .required = true});
  d.value("friction_angle", soil.friction_angle,
          {.meaning = "Coulomb friction angle of the interface with it", .unit = "rad", .range = {0, 89.9 * degree}, .required = true});
  d.value("adhesion", soil.adhesion,
          {.meaning = "shear strength of the interface with it at zero normal stress", .unit = "Pa", .range = not_negative});
  d.value("adhesion_factor", soil.adhesion_factor,
          {.meaning = "instead of `adhesion`: fraction of the current undrained shear strength", .range = {0, 1}});
}

void describe(Describe& d, ContactSettings& contact)
{
  d.value("body", contact.body, {.meaning = "name of the deformable body", .required = true});
  d.value("rigid", contact.rigid, {.meaning = "name of the rigid body in contact with it; or"});
  d.value("other_body", contact.other_body, {.meaning = "name of the other deformable body in contact with it"});
  d.value("friction_angle", contact.friction_angle,
          {.meaning = "Coulomb friction angle of the interface", .unit = "rad", .range = {0, 89.9 * degree}, .required = true});
  d.value("adhesion", contact.adhesion,
          {.meaning = "shear strength of the interface at zero normal stress", .unit = "Pa", .range = not_negative});
  d.value("adhesion_factor", contact.adhesion_factor,
          {.meaning = "alpha, instead of `adhesion`: adhesion divided by the current undrained shear strength of the soil at the interface",
           .range = {0, 1}});
  d.value("adhesion_sensitivity", contact.adhesion_sensitivity,
          {.meaning =
               "adhesion before sliding divided by that after large slip; it falls exponentially with the slip of a particle; 1 = constant",
           .range = {1, 1000}});
  d.value("adhesion_ductility", contact.adhesion_ductility,
          {.meaning = "slip after which 95 % of the loss of adhesion has occurred", .unit = "m", .range = not_negative});
  d.value("tension", contact.tension,
          {.meaning = "tensile normal stress (suction) that the interface carries where it has been closed and has not separated since; "
                      "\"unlimited\" = undrained soil cannot separate from the rigid body",
           .unit = "Pa",
           .range = not_negative,
           .words = {{"none", 0}, {"unlimited", infinity}}});
  std::vector<const char*> schemes;
  for (const SchemeRules& rules : scheme_rules) schemes.push_back(rules.word);
  d.choice("scheme", contact.scheme, schemes,
           {.meaning = "modified update stress last (MUSL) with one impulse, which step 4 of the algorithm begins and step 8 completes (at "
                       "nodes: step 8 keeps closed points together); MUSL with independent corrections in steps 4 and 8 (as published); "
                       "MUSL with a correction in step 4 only; the same with update stress last at nodes in contact; update stress "
                       "first (of all contacts or none); or neither slip nor separation"});
  d.choice("detection", contact.detection, {"automatic", "gap", "overlap", "distance", "particle"},
           {.meaning =
                "automatic: particle at a rigid body, gap between deformable ones. Points in contact are: nodes whose particles have "
                "closed their gap, at a speed limited by the gap; nodes with particles of both bodies in their cells (as published); "
                "nodes whose particles touch; or particles at the surface of a rigid body"});
  d.value("gap_closing_steps", contact.gap_closing_steps,
          {.meaning = "number of steps over which a gap may close, with detection by gap or particle; each as long as without mpm.courant",
           .range = {1, 1000}});
  d.choice("particle_rim", contact.particle_rim, {"whole", "worn"},
           {.meaning = "where a particle touches a rigid body: at half its width from its centre; or there while its soil is undeformed, "
                       "and nearer to the centre as it is sheared, which makes the resistance of flowing soil more accurate; a body that "
                       "slides over the same soil at a fixed level loses contact with it"});
  d.value("drained", contact.drained,
          {.meaning = "the water of consolidating soil flows across the surface of the rigid body, where the excess pore pressure is then "
                      "zero; else it does not"});
  d.array("soil", contact.soil,
          {.meaning = "properties of the interface beside some materials of the body, where they differ from layer to layer; beside the "
                      "others they are as above"});
  declare_usual(d, {{"adhesion_sensitivity", {1, 50}}, {"tension", {0, 5e6}}});
}

}  // namespace berm::contact
