// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/shaft.hpp"

#include "samples/made_push.hpp"
#include "structures/base/general_measures.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::lateral::this_file {
namespace {

constexpr Real outer = 0.2, inner = 0.18;                        // m
constexpr Real ring = pi * (outer * outer - inner * inner) / 4;  // m2

/// A ring of D = 0.2 m with a wall of 10 mm, pushed 10 D into the clay of MadePush: N_c = 8 at its tip and 4 kPa on both faces.
MadePush pushed_skirt()
{
  MadePush made;
  made.shape = bodies::ProfileSettings{{inner / 2, outer / 2, outer / 2, inner / 2}, {0, 0, 3, 3}};
  made.contact.adhesion = 4e3;
  made.q = [](Real z) { return (5e3 * z + 8 * 10e3) * ring / (pi * outer * outer / 4); };  // MadePush multiplies by the whole circle
  made.shaft = [](Real z) { return 4e3 * pi * (outer + inner) * z; };
  return made;
}

base::DisplayUnits units_of(const record::RunRecord& run)
{
  return base::DisplayUnits({{base::body_scale(run), &run.quantities}});
}

TEST(Skirt, has_the_area_of_its_ring_and_friction_on_both_faces)
{
  const record::RunRecord run = pushed_skirt().record();
  EXPECT_STREQ(structures::structure_of(run.settings).word, "skirt");
  const auto value = [&](const char* name) { return base::quantity_value(run, name); };
  EXPECT_NEAR(value("area"), ring, 1e-12);
  EXPECT_NEAR(value("N_c_end"), 8, 1e-6);
  EXPECT_NEAR(value("f_shaft_end"), 4e3, 1e-6);
  EXPECT_NEAR(value("z_end_over_D"), 10, 1e-9);
  EXPECT_NEAR(value("w_end_of_push_over_D"), 10, 1e-9) << "one D in all that is told";
  EXPECT_NEAR(base::body_scale(run).width, outer, 1e-12);
}

TEST(Skirt, says_how_thick_it_is_and_what_tip_and_faces_carry)
{
  const record::RunRecord run = pushed_skirt().record();
  const std::string words = structures::structure_of(run.settings).in_words(run, units_of(run));
  EXPECT_NE(words.find("the tip of the skirt is 10 D (2 m) deep"), std::string::npos) << words;
  EXPECT_NE(words.find("D = 200 mm, wall of 10 mm, area of the ring 59.7 cm²"), std::string::npos) << words;
  // Over the last 0.2 D, in the middle at z = 1.98 m: (5 x 1.98 + 80) kPa on the ring, 4 kPa over pi 0.38 m x 1.98 m.
  EXPECT_NE(words.find("the tip carries 0.5366 kN and friction 9.455 kN, 4 kPa on average over both faces"), std::string::npos) << words;
}

TEST(Skirt, stands_beside_a_strip_and_what_its_interface_carries)
{
  const record::RunRecord run = pushed_skirt().record();
  const std::string html = structures::structure_of(run.settings).published_values({{&run, 0}}, units_of(run));
  EXPECT_NE(html.find("5.142"), std::string::npos) << html;
  EXPECT_NE(html.find("friction of both faces"), std::string::npos) << html;
  EXPECT_NE(html.find("9.455</td>"), std::string::npos) << html;
}

TEST(Skirt, with_a_lid_says_where_it_is)
{
  MadePush made = pushed_skirt();
  made.shape = bodies::ProfileSettings{{0, inner / 2, inner / 2, outer / 2, outer / 2, 0}, {2.9, 2.9, 0, 0, 3, 3}};
  const record::RunRecord run = made.record();
  EXPECT_NEAR(base::quantity_value(run, "area"), ring, 1e-12);
  EXPECT_NE(structures::structure_of(run.settings).in_words(run, units_of(run)).find("the lid is 2.9 m above the tip"), std::string::npos);
}

TEST(Skirt, measures_how_many_cells_its_wall_is_thick)
{
  record::RunRecord run = pushed_skirt().record();
  run.settings.method = settings::Method::mpm;
  std::get<mesh::SeabedMesh>(run.settings.mesh).near_size = 5e-3;
  const base::TrustMeasures measures = structures::structure_of(run.settings).measures(run.settings);
  const auto wall = std::ranges::find(measures, std::string("cells in the thickness of the wall"), &base::TrustMeasure::what);
  ASSERT_NE(wall, measures.end());
  EXPECT_NEAR(wall->value(run), 2, 1e-9);
}

}  // namespace
}  // namespace berm::lateral::this_file
