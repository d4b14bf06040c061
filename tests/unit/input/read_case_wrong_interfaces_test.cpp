// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "os/error.hpp"
#include "samples/refusal.hpp"

#include <gtest/gtest.h>

namespace berm::input::this_file {
namespace {

/// The message that refuses the good case with these keys in its contact, which has the default scheme but for them.
std::string refusal(std::vector<std::string> keys)
{
  for (std::string& key : keys) key = "contact.pipe_on_bed." + key;
  keys.insert(keys.begin(), "contact.pipe_on_bed.scheme=musl_coupled");
  return test::refusal_with(keys);
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Interface, with_tension_needs_particles_and_the_coupled_scheme)
{
  EXPECT_EQ(refusal({"tension=5 kPa"}), "");
  EXPECT_EQ(refusal({"tension=unlimited"}), "");
  EXPECT_SAYS(refusal({"tension=5 kPa", "scheme=musl_double"}), "contact.pipe_on_bed.scheme: tension is for \"musl_coupled\" only");
  EXPECT_SAYS(refusal({"tension=unlimited", "detection=gap"}), "contact.pipe_on_bed.detection: tension is for \"particle\" only");
}

TEST(Interface, with_worn_rims_needs_particles_and_soil_that_flows)
{
  EXPECT_EQ(refusal({"particle_rim=worn"}), "");
  EXPECT_SAYS(refusal({"particle_rim=worn", "detection=gap"}), "contact.pipe_on_bed.detection: particle_rim is for \"particle\" only");
  EXPECT_SAYS(refusal({"particle_rim=wron"}), "did you mean \"worn\"?");
  EXPECT_SAYS(
      test::refusal_with({"contact.pipe_on_bed.scheme=musl_coupled", "contact.pipe_on_bed.particle_rim=worn", "body.bed.material=rubber"}),
      "contact.pipe_on_bed.particle_rim: [body.bed] is elastic and does not flow: its particles keep their width in contact");
}

TEST(Interface, between_deformable_bodies_has_no_tension)
{
  std::string text(test::good_case);
  const std::string from = "rigid = \"pipe\"\nfriction_angle", to = "other_body = \"ball\"\ntension = \"unlimited\"\nfriction_angle";
  text.replace(text.find(from), from.size(), to);
  text.insert(text.find("[rigid.pipe]"), "[body.ball]\nmaterial = \"sand\"\nregions = [\"box\"]\n");
  try {
    read_case_text("case.toml", text);
    ADD_FAILURE() << "is not refused";
  } catch (const InputError& error) {
    EXPECT_SAYS(std::string(error.what()), "contact.pipe_on_bed.tension: is for contact with a rigid body");
  }
}

TEST(Interface, names_the_words_that_stand_for_a_number)
{
  EXPECT_SAYS(refusal({"tension=full"}), "\"none\", \"unlimited\"");
  EXPECT_SAYS(refusal({"tension=-5 kPa"}), "contact.pipe_on_bed.tension");
}

TEST(Interface, has_one_adhesion)
{
  EXPECT_SAYS(refusal({"adhesion=1 kPa", "adhesion_factor=0.5"}), "contact.pipe_on_bed.adhesion_factor: cannot be combined with adhesion");
}

TEST(Interface, has_a_share_of_an_undrained_strength_only)
{
  EXPECT_SAYS(refusal({"adhesion_factor=0.5"}), "[body.bed] has none");
}

TEST(Interface, softens_where_there_is_an_adhesion_and_a_slip_to_lose_it_over)
{
  EXPECT_EQ(refusal({"adhesion=1 kPa", "adhesion_sensitivity=3", "adhesion_ductility=1 mm"}), "");
  EXPECT_SAYS(refusal({"adhesion=1 kPa", "adhesion_sensitivity=3"}), "needs both adhesion_sensitivity");
  EXPECT_SAYS(refusal({"adhesion=1 kPa", "adhesion_ductility=1 mm"}), "needs both adhesion_sensitivity");
  EXPECT_SAYS(refusal({"adhesion_sensitivity=3", "adhesion_ductility=1 mm"}), "needs an adhesion that falls");
}

}  // namespace
}  // namespace berm::input::this_file
