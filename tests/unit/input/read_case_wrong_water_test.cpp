// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/wrong_inputs.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// The message that refuses the good case with these keys for its sand, which does not dilate but for them, and which the pipe meets at particles.
std::string refusal_with(std::vector<std::string> keys, bool with_start = true)
{
  if (with_start)
    for (const char* key : {"material.sand.water.drainage=undrained", "material.sand.dilation_angle=0 deg"})
      keys.emplace(keys.begin(), key);
  try {
    read_case_text("case.toml", std::string(test::good_case), keys);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

#define EXPECT_WATER_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

const std::string in_water = "material.sand.water.";

TEST(Water, needs_no_more_than_its_drainage)
{
  EXPECT_EQ(refusal_with({}), "");
  EXPECT_EQ(refusal_with({in_water + "bulk_modulus=1 GPa", in_water + "porosity=0.4"}), "");
  EXPECT_EQ(refusal_with({in_water + "drainage=drained", "material.sand.dilation_angle=5 deg"}), "");
  EXPECT_WATER_SAYS(refusal_with({in_water + "porosity=0.4"}, false), "drainage");
  EXPECT_WATER_SAYS(refusal_with({in_water + "drainage=undrainde"}), "did you mean \"undrained\"?");
}

TEST(Water, of_a_bulk_modulus_needs_the_porosity_and_the_other_way_round)
{
  EXPECT_WATER_SAYS(refusal_with({in_water + "bulk_modulus=1 GPa"}), "needs the porosity");
  EXPECT_WATER_SAYS(refusal_with({in_water + "porosity=0.4"}), "water.porosity: is needed with bulk_modulus and permeability only");
  EXPECT_WATER_SAYS(refusal_with({in_water + "bulk_modulus=1 GPa", in_water + "porosity=40"}), "water.porosity");
  EXPECT_WATER_SAYS(refusal_with({"material.sand.young_modulus_gradient=1 MPa/m"}),
                    "needs bulk_modulus, because the stiffness of the soil varies");
}

TEST(Water, that_flows_needs_porosity_and_permeability)
{
  const std::string flows = in_water + "drainage=consolidation", k = in_water + "permeability=1e-5 m/s", n = in_water + "porosity=0.4";
  EXPECT_EQ(refusal_with({flows, k, n}), "");
  EXPECT_EQ(refusal_with({flows, k, n, "material.sand.dilation_angle=5 deg"}), "") << "water flows in where soil dilates";
  EXPECT_WATER_SAYS(refusal_with({flows, n}), "material.sand.water: needs the permeability");
  EXPECT_WATER_SAYS(refusal_with({flows, k}), "material.sand.water: needs the porosity");
  for (const char* limit : {"drained", "undrained"})
    EXPECT_EQ(refusal_with({in_water + "drainage=" + limit, k, n}), "") << "the limits of a case are one word away";
  EXPECT_WATER_SAYS(refusal_with({in_water + "kozeny_carman=true"}), "water.kozeny_carman: is a law of the permeability, which is missing");
  EXPECT_WATER_SAYS(refusal_with({flows, n, in_water + "permeability=0"}), "water.permeability");
  EXPECT_EQ(refusal_with({flows, k, n, "method=fem"}), "");
  EXPECT_WATER_SAYS(refusal_with({flows, k, n, "contact.pipe_on_bed.scheme=usf"}), "cannot be combined with scheme = \"usf\"");
  EXPECT_EQ(refusal_with({flows, k, n, "support.base.drained=true"}), "");
  EXPECT_WATER_SAYS(refusal_with({"support.base.drained=true"}), "support.base.drained: no soil has water that flows");
}

TEST(Water, crosses_rigid_bodies_that_are_drained_where_it_flows)
{
  const std::string flows = in_water + "drainage=consolidation", k = in_water + "permeability=1e-5 m/s", n = in_water + "porosity=0.4",
                    open = "contact.pipe_on_bed.drained=true";
  EXPECT_EQ(refusal_with({flows, k, n, open}), "");
  EXPECT_WATER_SAYS(refusal_with({open}), "contact.pipe_on_bed.drained: the water of [body.");
  EXPECT_WATER_SAYS(refusal_with({open}), "] does not flow: give its material water.drainage = \"consolidation\"");
}

TEST(Water, degree_of_consolidation_ends_stages_in_which_water_flows)
{
  const std::string end = "stage.push.until.consolidation=0.5", flows = in_water + "drainage=consolidation",
                    k = in_water + "permeability=1e-5 m/s", n = in_water + "porosity=0.4";
  EXPECT_WATER_SAYS(refusal_with({end}), "until.consolidation: no soil has water that flows");
  EXPECT_WATER_SAYS(refusal_with({flows, k, n, end}), "needs a body at rest or under a force");
  EXPECT_WATER_SAYS(refusal_with({flows, k, n, "stage.drag.until.consolidation=0.5", end}),
                    "pressure does not dissipate while it is moved");
  EXPECT_WATER_SAYS(refusal_with({flows, k, n, "stage.push.until.consolidation=1.5"}), "from 0.01 to 0.999");
}

TEST(Water, is_for_laws_of_effective_stress)
{
  EXPECT_WATER_SAYS(refusal_with({"material.sand.friction_angle=0 deg"}), "material.sand.water: is for laws of effective stress");
  std::string text(test::good_case);
  const std::string from = "law = \"linear_elastic\"",
                    to = "law = \"clay\"\nundrained_strength = \"5 kPa\"\nwater.drainage = \"undrained\"";
  text.replace(text.find(from), from.size(), to);
  try {
    read_case_text("case.toml", text);
    ADD_FAILURE() << "is not refused";
  } catch (const InputError& error) {
    EXPECT_WATER_SAYS(std::string(error.what()), "material.rubber.water: is for laws of effective stress");
  }
}

TEST(Water, under_soil_that_dilates_needs_the_pressure_of_cavitation)
{
  EXPECT_WATER_SAYS(refusal_with({"material.sand.dilation_angle=5 deg"}), "dilating undrained soil never fails");
  EXPECT_EQ(refusal_with({"material.sand.dilation_angle=5 deg", in_water + "min_pressure=-100 kPa"}), "");
  EXPECT_WATER_SAYS(refusal_with({in_water + "min_pressure=10 kPa"}), "water.min_pressure");
  EXPECT_WATER_SAYS(refusal_with({in_water + "min_pressure=-1 MPa", in_water + "water_depth=100 m"}),
                    "min_pressure: cannot be combined with water_depth");
}

TEST(Water, at_a_rough_contact_needs_particles)
{
  EXPECT_WATER_SAYS(refusal_with({"contact.pipe_on_bed.detection=gap"}),
                    "contact.pipe_on_bed.detection: friction acts on the effective normal stress");
  EXPECT_EQ(refusal_with({"contact.pipe_on_bed.detection=gap", "contact.pipe_on_bed.friction_angle=0 deg"}), "");
}

TEST(Water, is_the_same_in_all_materials_of_a_body)
{
  std::string text(test::good_case);
  const std::string from = "regions = [\"box\"]", to = from + "\nsoil_layer = [{top = \"0.5 m\", material = \"deep\"}]";
  text.replace(text.find(from), from.size(), to);
  text.insert(text.find("[body.bed]"),
              "[material.deep]\nlaw = \"mohr_coulomb\"\ndensity = 1800\nyoung_modulus = 7e6\npoisson_ratio = 0.3\nfriction_angle = 0.5\n");
  try {
    read_case_text("case.toml", text, {"material.sand.water.drainage=undrained", "material.sand.dilation_angle=0"});
    ADD_FAILURE() << "is not refused";
  } catch (const InputError& error) {
    EXPECT_WATER_SAYS(std::string(error.what()), "[material.deep] and [material.sand] of the same body differ in water.drainage");
  }
}

#undef EXPECT_WATER_SAYS

}  // namespace
}  // namespace berm::input::this_file
