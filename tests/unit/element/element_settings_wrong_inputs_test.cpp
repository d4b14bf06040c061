// SPDX-License-Identifier: BSD-3-Clause
// What is refused of an input of element tests: each names the line and the key, and says what is allowed.
#include "element/element_settings.hpp"
#include "material/mohr_coulomb.hpp"
#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace berm::element::this_file {
namespace {

/// Its first line is line 1.
const std::string good_input = R"(title = "Tests of sand"

[material.sand]
law = "mohr_coulomb"
density = 1000
young_modulus = "30 MPa"
poisson_ratio = 0.3
friction_angle = "30 deg"

[material.clay]
law = "mohr_coulomb"
density = 600
young_modulus = "3 MPa"
poisson_ratio = 0.49
friction_angle = 0
cohesion = "10 kPa"

[[test]]
name = "cd"
kind = "triaxial"
material = "sand"
drained = true
confining_stress = "100 kPa"
strain_path = [0.1]

[[test]]
name = "oed"
kind = "oedometer"
material = "clay"
vertical_stress = "20 kPa"
k0 = 0.5
stress_path = ["100 kPa"]
)";

struct WrongElement {
  const char *name, *from, *to;  ///< what is replaced in the good input
  int line;
  std::vector<std::string> says;
};

/// For the names of tests.
void PrintTo(const WrongElement& wrong, std::ostream* stream)
{
  *stream << wrong.name;
}

const std::vector<WrongElement> wrong_elements = {
    {"unknown_kind", "\"triaxial\"", "\"triaxal\"", 20, {"test.cd.kind", "did you mean \"triaxial\"", "simple_shear"}},
    {"no_kind", "kind = \"triaxial\"\n", "", 18, {"test.cd.kind", "is missing"}},
    {"unknown_key", "strain_path = [0.1]", "strains_path = [0.1]", 24, {"test.cd.strains_path", "did you mean \"strain_path\""}},
    {"key_of_another_kind", "drained = true", "stress_path = [1]", 22, {"test.cd.stress_path", "kind = \"isotropic\" or \"oedometer\""}},
    {"unknown_material", "material = \"sand\"", "material = \"snad\"", 21, {"test.cd.material", "did you mean \"sand\"", "clay"}},
    {"no_material", "material = \"sand\"\n", "", 18, {"test.cd.material", "is missing"}},
    {"no_drainage", "drained = true\n", "", 18, {"test.cd.drained", "is missing"}},
    {"k0_with_isotropic",
     "confining_stress = \"100 kPa\"",
     "confining_stress = \"100 kPa\"\nk0 = 0.5",
     24,
     {"test.cd.k0", "cannot be combined with"}},
    {"two_stresses",
     "confining_stress = \"100 kPa\"",
     "confining_stress = \"100 kPa\"\nvertical_stress = 1",
     24,
     {"test.cd.vertical_stress"}},
    {"no_stress", "confining_stress = \"100 kPa\"\n", "", 18, {"test.cd", "confining_stress, or vertical_stress and k0"}},
    {"no_k0", "k0 = 0.5\n", "", 30, {"test.oed.vertical_stress", "needs k0"}},
    {"negative_stress", "\"100 kPa\"\nstrain", "\"-100 kPa\"\nstrain", 23, {"test.cd.confining_stress", "at least 0 Pa"}},
    {"wrong_unit", "\"100 kPa\"\nstrain", "\"100 kN\"\nstrain", 23, {"test.cd.confining_stress", "100 kN"}},
    {"no_steps", "strain_path = [0.1]", "strain_path = [0.1]\nsteps = 0", 25, {"test.cd.steps", "from 1"}},
    {"no_rate", "strain_path = [0.1]", "strain_path = [0.1]\nstrain_rate = 0", 25, {"test.cd.strain_rate", "more than 0"}},
    {"no_path", "strain_path = [0.1]\n", "", 18, {"test.cd", "needs strain_path"}},
    {"standing_still",
     "strain_path = [0.1]",
     "strain_path = [0.1, 0.1]",
     24,
     {"test.cd.strain_path[1]", "is the present state of the specimen"}},
    {"both_paths",
     "stress_path = [",
     "strain_path = [0.1]\nstress_path = [",
     32,
     {"test.oed.strain_path", "cannot be combined with stress_path"}},
    {"cycle_of_one", "strain_path = [0.1]", "strain_path = [0.1]\ncycles = 3", 25, {"test.cd.cycles", "two entries"}},
    {"reconsolidated_once", "drained = true\n", "drained = false\nreconsolidated = true\n", 23, {"test.cd.reconsolidated", "cycles = 2"}},
    {"reconsolidated_and_drained",
     "strain_path = [0.1]",
     "strain_path = [0.1]\ncycles = 2\nreconsolidated = true",
     26,
     {"test.cd.reconsolidated", "drained = false"}},
    {"name_of_two", "\"oed\"", "\"cd\"", 27, {"name", "a test before it"}},
    {"name_of_a_folder", "\"oed\"", "\"a/b\"", 27, {"name", "letters, digits"}},
    {"drained_clay", "material = \"sand\"", "material = \"clay\"", 22, {"test.cd.drained", "undrained strength"}},
    {"beyond_strength",
     "confining_stress = \"100 kPa\"",
     "vertical_stress = \"100 kPa\"\nk0 = 0.2",
     24,
     {"test.cd.k0", "beyond the strength"}},
    {"wrong_law",
     "friction_angle = \"30 deg\"",
     "friction_angle = \"30 deg\"\ndilation_angle = \"31 deg\"",
     9,
     {"material.sand.dilation_angle"}},
    {"table_of_a_case", "[[test]]\nname = \"cd\"", "[[stage]]\nname = \"cd\"", 18, {"stage", "unknown key"}},
};

class WrongElementInputs : public testing::TestWithParam<WrongElement> {};

std::string refusal_of(const std::string& text)
{
  TemporaryFolder folder;
  folder.write("case.toml", text);
  try {
    read_element_case(folder.path() / "case.toml");
  } catch (const InputError& error) {
    return std::string(error.what()).substr(folder.path().string().size() + 1);
  }
  return "";
}

TEST_P(WrongElementInputs, are_refused_with_line_and_key)
{
  const WrongElement& wrong = GetParam();
  std::string text = good_input;
  const std::size_t at = text.find(wrong.from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(wrong.from).size(), wrong.to);
  const std::string message = refusal_of(text);
  EXPECT_EQ(message.find("case.toml:" + std::to_string(wrong.line) + ": "), 0u) << message;
  for (const std::string& part : wrong.says) EXPECT_NE(message.find(part), std::string::npos) << "no `" << part << "` in: " << message;
}

INSTANTIATE_TEST_SUITE_P(Table, WrongElementInputs, testing::ValuesIn(wrong_elements),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ElementInput, that_is_right_is_read)
{
  EXPECT_EQ(refusal_of(good_input), "");
}

TEST(ElementInput, that_is_a_case_of_berm_run_says_how_its_soil_is_tested)
{
  const std::string message = refusal_of("[mesh]\nkind = \"box\"\n");
  for (const char* part : {"case.toml:1: mesh: ", "a case of berm run", "materials_from = \"case.toml\""})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(ElementInput, takes_materials_from_a_case_and_changes_of_them)
{
  TemporaryFolder folder;
  const std::size_t tests = good_input.find("[[test]]");
  folder.write("run.toml", "surface = 0\n" + good_input.substr(good_input.find("[material"), tests - good_input.find("[material")));
  folder.write("case.toml", "materials_from = \"run.toml\"\n" + good_input.substr(tests));
  const ElementCase c = read_element_case(folder.path() / "case.toml", {"material.clay.cohesion=12 kPa", "test.cd.strain_path=[0.2]"});
  EXPECT_EQ(material_of(c, c.test[1]).get<material::MohrCoulomb>().cohesion, 12e3);
  EXPECT_EQ(c.test[0].strain_path, std::vector<Real>{0.2});
  folder.write("case.toml", "materials_from = \"rum.toml\"\n" + good_input.substr(tests));
  try {
    read_element_case(folder.path() / "case.toml");
    FAIL() << "there is no rum.toml";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("case.toml:1: materials_from: "), std::string::npos) << message;
    EXPECT_NE(message.find("rum.toml: there is no such file"), std::string::npos) << message;
  }
}

TEST(ElementInput, takes_the_soil_at_the_depth_of_the_specimen)
{
  TemporaryFolder folder;
  std::string text = good_input;
  text.replace(text.find("cohesion = \"10 kPa\""), 19, "cohesion = \"10 kPa\"\ncohesion_gradient = \"2 kPa/m\"");
  text += "depth = \"3 m\"\n";
  folder.write("case.toml", text);
  const ElementCase c = read_element_case(folder.path() / "case.toml");
  EXPECT_EQ(material_of(c, c.test[1]).get<material::MohrCoulomb>().cohesion, 16e3);
}

}  // namespace
}  // namespace berm::element::this_file
