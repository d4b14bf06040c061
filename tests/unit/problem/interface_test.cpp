// SPDX-License-Identifier: BSD-3-Clause
#include "problem/interface.hpp"

#include "material/clay.hpp"
#include "material/ngi_adp.hpp"
#include "settings/body_soil.hpp"
#include "settings/case.hpp"
#include "settings/interface.hpp"

#include <gtest/gtest.h>

namespace berm::problem::this_file {
namespace {

material::Material clay(Real strength, Real rate_parameter)
{
  material::Clay law;
  law.density = 1600;
  law.young_modulus = 1e6;
  law.poisson_ratio = 0.49;
  law.undrained_strength = strength;
  law.rate_parameter = rate_parameter;
  law.reference_rate = 1e-3;
  return law;
}

contact::ContactSettings skin(Real factor, Real sensitivity, Real ductility)
{
  contact::ContactSettings contact;
  contact.body = "bed";
  contact.rigid = "pipe";
  contact.adhesion_factor = factor;
  contact.adhesion_sensitivity = sensitivity;
  contact.adhesion_ductility = ductility;
  return contact;
}

TEST(AdhesionLaw, is_the_share_of_the_strength_that_the_soil_has_now)
{
  const material::Material soil = clay(5e3, 0.1);
  const AdhesionLaw law = adhesion_law(skin(0.4, 1, 0), settings::soil_of_one(soil));
  const Real undisturbed[3] = {}, faster[3] = {0, 0.16, 0.16};  // the state of the law: what the rate adds
  EXPECT_EQ(law.at(soil, undisturbed, 0, 0), 2000);
  EXPECT_EQ(law.at(soil, faster, 0, 0), 0.4 * 5800);
  EXPECT_EQ(law.at(soil, undisturbed, 7, 0), 2000) << "slip counts only where it softens";
}

TEST(AdhesionLaw, of_anisotropic_clay_is_the_share_of_its_strength_in_simple_shear)
{
  material::NgiAdp clay;
  clay.undrained_strength = 1e4;
  clay.dss_ratio = 0.7;
  const material::Material soil = clay;
  const AdhesionLaw law = adhesion_law(skin(0.5, 1, 0), settings::soil_of_one(soil));
  const Real undisturbed[1] = {};
  EXPECT_NEAR(law.at(soil, undisturbed, 0, 0), 3500, 1e-9);
}

TEST(AdhesionLaw, falls_exponentially_with_the_slip_to_one_over_its_sensitivity)
{
  const material::Material soil = clay(5e3, 0);
  const AdhesionLaw law = adhesion_law(skin(1, 4, 0.01), settings::soil_of_one(soil));
  const Real undisturbed[3] = {};
  EXPECT_EQ(law.at(soil, undisturbed, 0, 0), 5e3);
  // 95 % of the fall, 1 - e^-3, after the ductility; all of it after much more.
  EXPECT_NEAR(law.at(soil, undisturbed, 0.01, 0), 5e3 * (0.25 + 0.75 * std::exp(-3.)), 1e-9);
  EXPECT_NEAR(law.at(soil, undisturbed, 1, 0), 1250, 1e-9);
}

TEST(AdhesionLaw, of_a_softening_interface_is_never_above_its_share_of_the_present_strength)
{
  const material::Material soil = clay(5e3, 0);
  const AdhesionLaw law = adhesion_law(skin(0.5, 2, 0.01), settings::soil_of_one(soil));
  const Real softened[3] = {10, 0, -0.8};
  EXPECT_NEAR(law.at(soil, softened, 0, 0), 500, 1e-9);
  EXPECT_NEAR(law.at(soil, softened, 1, 0), 500, 1e-9);
}

TEST(AdhesionLaw, of_an_adhesion_in_pascals_falls_too)
{
  contact::ContactSettings contact = skin(0, 2, 0.01);
  contact.adhesion = 3e3;
  const AdhesionLaw law = adhesion_law(contact, settings::soil_of_one(clay(5e3, 0)));
  EXPECT_TRUE(law.soils.empty());
  EXPECT_EQ(law.at(clay(5e3, 0), nullptr, 0, 0), 3e3);
  EXPECT_NEAR(law.at(clay(5e3, 0), nullptr, 1, 0), 1.5e3, 1e-9);
}

TEST(MemoryOfParticles, is_there_for_the_contacts_that_need_it_and_follows_the_numbers_of_the_soil)
{
  settings::Case c;
  material::Clay growing = clay(5e3, 0.1).get<material::Clay>();
  growing.undrained_strength_gradient = 1e3;
  c.material = {{"clay", growing}};
  bodies::BodySettings body;
  body.material = "clay";
  c.body = {{"bed", body}, {"other", body}};
  contact::ContactSettings plain = skin(0.5, 1, 0), both = skin(0.5, 2, 0.01), elsewhere = skin(0, 1, 0);
  both.tension = infinity;
  elsewhere.body = "other";
  elsewhere.tension = 1e3;
  c.contact = {{"a", plain}, {"b", both}, {"c", elsewhere}};
  const int of_soil = 5;  // the three of the law, undrained_strength, young_modulus
  EXPECT_EQ(memory_of(c, 0).bond, none);
  EXPECT_EQ(memory_of(c, 0).slip, none);
  EXPECT_EQ(memory_of(c, 1).bond, of_soil);
  EXPECT_EQ(memory_of(c, 1).slip, of_soil + 1);
  EXPECT_EQ(memory_of(c, 2).bond, of_soil);
  EXPECT_EQ(memory_of(c, 2).slip, none);
  EXPECT_EQ(memory_fields(c, "bed").size(), 2);
  EXPECT_EQ(memory_fields(c, "other").size(), 1);
}

}  // namespace
}  // namespace berm::problem::this_file
