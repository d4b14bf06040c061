// SPDX-License-Identifier: BSD-3-Clause
#include "material/material.hpp"

#include "material/laws.hpp"
#include "samples/anisotropic_clay.hpp"
#include "samples/critical_state_soils.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace berm::material::this_file {
namespace {

/// Chooses one law, and keeps what is said of every key.
class Recorder : public Describe {
public:
  explicit Recorder(int law) : law_(law) {}

  std::vector<std::pair<std::string, Parameter>> said;
  std::vector<std::string> words, refused;

  const Parameter* of(const std::string& key) const
  {
    for (const auto& [name, parameter] : said)
      if (name == key) return &parameter;
    return nullptr;
  }
  void check(bool fine, const std::string& path, const std::string&, const std::vector<std::string>&) override
  {
    if (!fine) refused.push_back(path);
  }

protected:
  void leaf(const char* key, Leaf, const Parameter& parameter) override { said.emplace_back(key, parameter); }
  int choose(const char*, const std::vector<const char*>& names, int, const Parameter&) override
  {
    words.assign(names.begin(), names.end());
    return law_;
  }
  void enter(const char*, const Parameter&) override {}
  void leave() override {}
  bool has_table(const char*, bool) override { return false; }
  std::vector<std::string> names_in(const char*, const std::vector<std::string>&, const Parameter&) override { return {}; }
  void enter_named(const char*, const std::string&) override {}
  int count_in(const char*, int, const Parameter&) override { return 0; }
  void enter_item(const char*, int) override {}

private:
  int law_;
};

TEST(Material, the_word_decides_which_law_the_keys_fill)
{
  Material material;
  Recorder elastic(0), soil(1);
  describe(elastic, material);
  EXPECT_NE(material.get_if<LinearElastic>(), nullptr);
  EXPECT_EQ(elastic.of("cohesion"), nullptr);
  describe(soil, material);
  EXPECT_NE(material.get_if<MohrCoulomb>(), nullptr);
  ASSERT_NE(soil.of("cohesion"), nullptr);
  EXPECT_EQ(soil.words[1], "mohr_coulomb");
  EXPECT_STREQ(law_word(material), "mohr_coulomb");
}

TEST(Material, what_no_law_can_guess_is_required)
{
  for (const int law : {0, 1, 2}) {
    Material material;
    Recorder recorder(law);
    describe(recorder, material);
    for (const char* key : {"young_modulus", "poisson_ratio"}) {
      ASSERT_NE(recorder.of(key), nullptr);
      EXPECT_TRUE(recorder.of(key)->required) << key;
    }
  }
  Material material;
  Recorder recorder(1);
  describe(recorder, material);
  EXPECT_TRUE(recorder.of("friction_angle")->required);
  EXPECT_STREQ(recorder.of("friction_angle")->unit, "rad");
  EXPECT_GE(recorder.of("friction_angle")->range.max, 60 * pi / 180);
}

TEST(Material, needs_a_density_or_a_unit_weight_below_water_and_not_both)
{
  MohrCoulomb law;
  const auto refused_weight = [&] {
    Recorder recorder(1);
    check(recorder, "material.sand", Material(law));
    return recorder.refused.empty() ? std::string() : recorder.refused.front();
  };
  EXPECT_EQ(refused_weight(), "material.sand.density");
  law.density = nan;
  EXPECT_EQ(refused_weight(), "material.sand.submerged_unit_weight");
  law.density = 900;
  EXPECT_EQ(refused_weight(), "");
}

TEST(Material, dilation_larger_than_friction_is_refused_at_its_key)
{
  MohrCoulomb law;
  law.friction_angle = 0.5;
  law.dilation_angle = 0.5;
  Recorder recorder(1);
  check(recorder, "material.sand", law);
  EXPECT_TRUE(recorder.refused.empty());
  law.dilation_angle = 0.6;
  check(recorder, "material.sand", law);
  ASSERT_EQ(recorder.refused.size(), 1u);
  EXPECT_EQ(recorder.refused[0], "material.sand.dilation_angle");
}

/// The keys that check() refuses.
template <class L>
std::vector<std::string> refused(const L& law)
{
  Recorder recorder(0);
  check(recorder, "material.soil", law);
  return recorder.refused;
}

TEST(Material, critical_state_soil_that_cannot_be_is_refused_at_its_key)
{
  using Keys = std::vector<std::string>;
  ModifiedCamClay clay = sample_cam_clay();
  EXPECT_EQ(refused(clay), Keys{});
  clay.swelling_index = clay.compression_index;
  EXPECT_EQ(refused(clay), Keys{"material.soil.swelling_index"});
  clay = sample_cam_clay();
  clay.max_pressure = clay.min_pressure;
  EXPECT_EQ(refused(clay), Keys{"material.soil.max_pressure"});

  NorSand sand = sample_norsand();
  EXPECT_EQ(refused(sand), Keys{});
  sand.void_ratio = 0.7;
  EXPECT_EQ(refused(sand), Keys{"material.soil.void_ratio"}) << "both";
  sand.void_ratio.reset();
  sand.state_parameter.reset();
  EXPECT_EQ(refused(sand), Keys{"material.soil.void_ratio"}) << "neither";
  sand = sample_norsand();
  sand.dilatancy = 50;
  EXPECT_EQ(refused(sand), Keys{"material.soil.dilatancy"});

  Recorder recorder(3);
  Material material;
  describe(recorder, material);
  EXPECT_EQ(recorder.of("overconsolidation_ratio")->range.min, 1);
}

TEST(Material, anisotropic_clay_that_cannot_be_is_refused_at_its_key)
{
  using Keys = std::vector<std::string>;
  EXPECT_EQ(refused(sample_ngi_adp()), Keys{});
  NgiAdp clay = sample_ngi_adp(1);
  EXPECT_EQ(refused(clay), Keys{"material.soil.initial_mobilisation"}) << "it has failed at rest";
  EXPECT_EQ(refused(sample_ngi_adp(-0.35)), Keys{"material.soil.initial_mobilisation"});
  clay = sample_ngi_adp();
  clay.active_failure_strain = 0.5 / 400, clay.dss_failure_strain = 0.55 / 400, clay.passive_failure_strain = 0.85 / 400;
  EXPECT_EQ(refused(clay),
            (Keys{"material.soil.active_failure_strain", "material.soil.dss_failure_strain", "material.soil.passive_failure_strain"}))
      << "all of it is elastic";
  clay = sample_ngi_adp();
  clay.young_modulus = 1e7;
  EXPECT_EQ(refused(clay), Keys{"material.soil.rigidity_index"}) << "stiffness given twice";
}

TEST(Material, hardening_soil_that_cannot_be_is_refused_at_its_key)
{
  using Keys = std::vector<std::string>;
  HardeningSoil sand;
  sand.density = 1600;
  sand.friction_angle = 0.7;
  sand.dilation_angle = 0.2;
  sand.secant_modulus = sand.oedometer_modulus = 30e6;
  sand.unloading_modulus = 90e6;
  sand.stiffness_exponent = 0.5;
  sand.poisson_ratio = 0.25;
  sand.max_pressure = 1e6;
  const HardeningSoil good = sand;
  EXPECT_EQ(refused(sand), Keys{});
  sand.oedometer_modulus = 1.01 * largest_oedometer_modulus(sand);
  EXPECT_EQ(refused(sand), Keys{"material.soil.oedometer_modulus"}) << "nothing left for the cap";
  sand = good;
  sand.unloading_modulus = 50e6;
  EXPECT_EQ(refused(sand), Keys{"material.soil.unloading_modulus"}) << "E_i is 54.5 MPa";
  sand = good;
  sand.virgin_k0 = 0.2;
  EXPECT_EQ(refused(sand), Keys{"material.soil.virgin_k0"}) << "below active failure";
  sand = good;
  sand.dilation_angle = 0.8;
  EXPECT_EQ(refused(sand).front(), "material.soil.dilation_angle");
  sand = good;
  sand.small_strain_shear_modulus = 90e6;
  EXPECT_EQ(refused(sand), Keys{"material.soil.shear_strain_at_70_percent"});
  sand.shear_strain_at_70_percent = 2e-4;
  EXPECT_EQ(refused(sand), Keys{});
  sand.small_strain_shear_modulus = 30e6;
  EXPECT_EQ(refused(sand), Keys{"material.soil.small_strain_shear_modulus"}) << "softer than unloading";
}

TEST(Material, answers_for_the_law_it_holds)
{
  const Material elastic = LinearElastic{.density = 2000, .inertia_density = {}, .young_modulus = 3e6, .poisson_ratio = 0};
  EXPECT_EQ(density(elastic), 2000);
  EXPECT_DOUBLE_EQ(p_wave_modulus(elastic), 3e6);
  EXPECT_EQ(state_size(elastic), 0);
  MohrCoulomb law;
  law.density = 1800;
  law.young_modulus = 1e7;
  law.poisson_ratio = 0.25;
  const Material soil = law;
  EXPECT_EQ(density(soil), 1800);
  EXPECT_DOUBLE_EQ(p_wave_modulus(soil), 1.2e7);
  EXPECT_EQ(state_size(soil), 1);
}

/// A law that answers nothing itself.
struct Plain {
  static constexpr const char* word = "plain_law";
  static constexpr int state_size = 0;
  Real density = 0;
  std::optional<Real> inertia_density;
  std::optional<PoreWater> water;
};

TEST(Material, a_law_that_does_not_answer_has_neither_friction_nor_depth_nor_dilation)
{
  const Plain law;
  EXPECT_EQ(law_name(law), "plain law");
  EXPECT_TRUE(state_fields(law).empty());
  Real state = 0;
  initial_state(law, {{-1e3, -2e3, -1e3}}, &state);
  EXPECT_EQ(state, 0);
  EXPECT_TRUE(yields(law));
  EXPECT_FALSE(dilates(law));
  EXPECT_FALSE(non_associated(law));
  EXPECT_FALSE(strength_at_rest(law));
  EXPECT_FALSE(shear_strength(law, 0, nullptr));
  EXPECT_FALSE(varies(law));
  EXPECT_TRUE(local_values(law).empty());
}

TEST(Material, each_law_has_a_word_and_a_name_and_names_what_it_keeps)
{
  EXPECT_EQ(Laws::words().size(), std::variant_size_v<Laws::Any>);
  for (int k = 0; k < static_cast<int>(Laws::words().size()); ++k) {
    Material material;
    Recorder recorder(k);
    describe(recorder, material);
    EXPECT_STREQ(law_word(material), Laws::words()[k]);
    EXPECT_FALSE(law_name(material).empty());
    EXPECT_EQ(static_cast<int>(state_fields(material).size()), state_size(material));
    EXPECT_LE(state_size(material), Laws::max_state);
  }
}

TEST(Material, opening_goes_to_frames_where_soil_can_come_apart)
{
  MohrCoulomb law;
  law.density = 1800;
  law.young_modulus = 1e7;
  law.poisson_ratio = 0.25;
  law.friction_angle = 0.6;
  const auto opening = [](const MohrCoulomb& sand) { return state_fields(Material(sand)).at(0); };
  EXPECT_FALSE(opening(law).goes(to_frame));
  EXPECT_TRUE(opening(law).goes(to_checkpoint) && opening(law).goes(with_particle));
  law.dilation_angle = 0.1;
  EXPECT_TRUE(opening(law).goes(to_frame));
  EXPECT_EQ(opening(law).name, "opening");
}

}  // namespace
}  // namespace berm::material::this_file
