// SPDX-License-Identifier: BSD-3-Clause
// The strength of a sounding in a case: a profile of clay, layers of sand.
#include "start/cpt.hpp"

#include "input/read_case.hpp"
#include "os/error.hpp"
#include "start/soils.hpp"

#include <gtest/gtest.h>

namespace berm::start::this_file {
namespace {

/// 0.05, 0.15, ... m.
site::Sounding made(const std::vector<Real>& q_t)
{
  site::Sounding sounding;
  sounding.file = "made.csv";
  sounding.corrected = "q_t as in the file";
  sounding.rows = static_cast<Index>(q_t.size());
  for (const Real q : q_t) {
    sounding.depth.push_back(0.05 + 0.1 * static_cast<Real>(sounding.depth.size()));
    sounding.q_t.push_back(q);
  }
  return sounding;
}

TEST(Cpt, gives_clay_a_profile_of_its_undrained_strength)
{
  const Kind& kind = kind_called("pipe-in-clay");
  // sigma_v0 = (6 + 9.81) kN/m3 z: 0.79 and 2.37 kPa.
  const CptCase written = with_cpt(kind, kind.text, made({28.79e3, 44.37e3}), {});
  const std::string& text = written.text;
  EXPECT_NE(text.find("depth = [\"0.05 m\", \"0.15 m\"]\nundrained_strength = [\"2.00 kPa\", \"3.00 kPa\"]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("From made.csv: 2 of 2 rows, 0.05 to 0.15 m"), std::string::npos);
  EXPECT_NE(text.find("N_kt = 14"), std::string::npos);
  EXPECT_EQ(text.find("undrained_strength_gradient"), std::string::npos);
  EXPECT_NE(text.find("# Undrained: s_u from the sounding, G = 100 s_u."), std::string::npos) << "and not the strength of the template";
  EXPECT_EQ(text.find("s_u = 2 kPa"), std::string::npos);
  ASSERT_EQ(written.doubts.size(), 1u);
  EXPECT_NE(text.find("# Warning: the sounding ends at 0.15 m with 2 readings, and the bed is 3 m deep"), std::string::npos) << text;
  EXPECT_NO_THROW(input::read_case_text("case.toml", text));
}

TEST(Cpt, gives_sand_layers_with_an_angle_of_friction_each)
{
  const Kind& kind = kind_called("pipe-in-sand");
  const std::string text = with_cpt(kind, kind.text, made({0.1e6, 0.15e6, 3e6, 3e6}), {}).text;
  // 17.6 + 11 log10(1 / sqrt(0.0045)) = 30.5 and 29.8 deg, mean 30.2; then 42.9 and 42.1.
  EXPECT_NE(text.find("friction_angle = \"30.2 deg\""), std::string::npos) << text;
  EXPECT_NE(text.find("[material.sand_2]"), std::string::npos);
  EXPECT_NE(text.find("# Drained: phi and psi from the sounding; inertia"), std::string::npos);
  EXPECT_EQ(text.find("33 deg,"), std::string::npos);
  // psi = (phi - 33 deg) / 0.8: none of 30.2 deg, 11.9 of 42.5.
  EXPECT_NE(text.find("friction_angle = \"30.2 deg\"\ndilation_angle = \"0.0 deg\"\n"), std::string::npos);
  EXPECT_NE(text.find("friction_angle = \"42.5 deg\"\ndilation_angle = \"11.9 deg\"\n"), std::string::npos);
  EXPECT_NE(text.find("\nmaterial = \"sand\"\nsoil_layer = [{ top = \"0.20 m\", material = \"sand_2\" }]\n"), std::string::npos) << text;
  EXPECT_NO_THROW(input::read_case_text("case.toml", text));
}

TEST(Cpt, goes_with_a_soil_by_name_whose_unit_weight_counts)
{
  const Kind& kind = kind_called("pipe-in-clay");
  const std::string text =
      with_cpt(kind, with_soil(kind, kind.text, "kaolin"), made({28.8155e3, 44.4465e3}), {}).text;  // (6.5 + 9.81) kN/m3
  EXPECT_NE(text.find("undrained_strength = [\"2.00 kPa\", \"3.00 kPa\"]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("sensitivity = 3.2"), std::string::npos);
  EXPECT_NE(text.find("# All but the strength is that of: Kaolin"), std::string::npos);
  EXPECT_EQ(text.find("s_u = 2.3 kPa"), std::string::npos);
}

TEST(Cpt, leaves_no_strength_of_the_template_in_a_comment)
{
  for (const Kind& kind : kinds()) {
    const bool clay = table_of(kind.text, "clay").begin != std::string::npos, sand = table_of(kind.text, "sand").begin != std::string::npos;
    if (clay == sand || kind.name == "layers") continue;
    for (const std::string& soil : soils_for(kind)) {
      const std::string of_soil = with_cpt(kind, with_soil(kind, kind.text, soil), made({0.1e6, 0.2e6}), {}).text;
      const std::size_t title = of_soil.find("# All but the strength is that of: ");
      ASSERT_NE(title, std::string::npos) << soil;
      const std::string line = of_soil.substr(title, of_soil.find('\n', title) - title);
      for (const char* strength : {"s_u =", "phi =", "psi ="}) EXPECT_EQ(line.find(strength), std::string::npos) << line;
    }
    const std::string text = with_cpt(kind, kind.text, made({0.1e6, 0.2e6}), {}).text;
    EXPECT_EQ(text.find("# Undrained: s_u ="), std::string::npos) << kind.name;
    EXPECT_EQ(text.find("# Drained: phi ="), std::string::npos) << kind.name;
  }
}

TEST(Cpt, refuses_the_choice_for_the_other_soil)
{
  const Kind &clay = kind_called("pipe-in-clay"), &sand = kind_called("pipe-in-sand");
  EXPECT_THROW(with_cpt(clay, clay.text, made({0.1e6, 0.2e6}), {{}, site::Correlation::kulhawy_mayne}), InputError);
  EXPECT_THROW(with_cpt(sand, sand.text, made({0.1e6, 0.2e6}), {14, {}}), InputError);
}

TEST(Cpt, makes_a_case_of_each_kind_that_takes_one_and_is_refused_by_the_others)
{
  for (const Kind& kind : kinds()) {
    const bool clay = table_of(kind.text, "clay").begin != std::string::npos, sand = table_of(kind.text, "sand").begin != std::string::npos;
    if (clay == sand || kind.name == "layers")
      EXPECT_THROW(with_cpt(kind, kind.text, made({1e6, 1e6}), {}), InputError) << kind.name;
    else
      EXPECT_NO_THROW(input::read_case_text(kind.name, with_cpt(kind, kind.text, made({0.1e6, 0.1e6, 1.5e6, 3e6}), {}).text)) << kind.name;
  }
}

}  // namespace
}  // namespace berm::start::this_file
