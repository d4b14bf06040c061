// SPDX-License-Identifier: BSD-3-Clause
// What other programs are given, called as they call it: by the drivers of tests/interfaces, compiled with the code that berm writes.
#include "io/scratch_folder.hpp"
#include "macro_element_fit/files.hpp"
#include "macro_element_fit/fmu.hpp"
#include "samples/macro_element_parameters.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

namespace berm::macro_element_fit::this_file {
namespace {

Parameters sample()
{
  Parameters p = macro_element::sample_parameters();
  p.backbone_points = 2;
  p.backbone_w[0] = 0.01, p.backbone_w[1] = 0.2;
  p.backbone_V[0] = 1000. / 3, p.backbone_V[1] = 8000;
  return p;
}

std::string text_of(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder with what berm macro-element writes.
class OtherPrograms : public testing::Test {
protected:
  OtherPrograms() { write_files(folder_.path(), sample(), {}); }

  int shell(const std::string& command) const
  {
    return std::system(fmt::format("cd '{}' && {}", folder_.path().string(), command).c_str());
  }
  /// Compiles a driver with the code, and with what lies in examples/macro_element, and runs it, also where the host has a decimal comma. The two
  /// that are compared round alike.
  int drive(const std::string& name, const std::string& more, const std::string& arguments) const
  {
    return shell(fmt::format("cc -std=c99 -D_GNU_SOURCE -Wall -Wextra -Werror -O2 -ffp-contract=off -I. '{0}/tests/interfaces/{1}.c' {2} "
                             "macro_element.c -o {1} -ldl -lm && ./{1} {3} && env {4} ./{1} {3}",
                             BERM_SOURCE_DIR, name,
                             more.empty() ? "" : fmt::format("'{}/examples/macro_element/{}'", BERM_SOURCE_DIR, more), arguments,
                             BERM_COMMA_LOCALE));
  }

  io::ScratchFolder folder_;
};

TEST_F(OtherPrograms, run_both_units_to_the_bits_of_the_macro_element_and_go_back_in_them)
{
  std::string arguments;
  for (const int version : {2, 3}) {
    const std::string unit = fmt::format("unit {}", version);  // a path with a blank, which a URI has as %20
    ASSERT_EQ(shell(fmt::format("python3 -m zipfile --extract macro_element.fmi{}.fmu '{}'", version, unit)), 0);
    EXPECT_EQ(shell(fmt::format("for xml in $(cd '{0}' && find . -name '*.xml'); do python3 -c 'import sys, xml.dom.minidom as m; "
                                "m.parse(sys.argv[1])' \"{0}/$xml\" || exit 1; done",
                                unit)),
              0);
    const std::filesystem::path root = folder_.path() / unit;
    const std::string resource = text_of(root / "resources/parameters.txt"), token = resource.substr(6, 64);
    const std::string machine = version == 2 ? "linux64" : "x86_64-linux";
    const std::filesystem::path library = root / "binaries" / machine / "berm_macro_element.so";
    if (!std::filesystem::exists(library)) GTEST_SKIP() << "another kind of machine";
    EXPECT_EQ(text_of(root / "modelDescription.xml"), model_description(version, token));
    const std::string resources =
        version == 2 ? fmt::format("file://{}/unit%20{}/resources", folder_.path().string(), version) : (root / "resources").string() + "/";
    arguments += fmt::format(" '{}' '{}' {}", library.string(), resources, token);
  }
  EXPECT_EQ(drive("fmu", "", arguments), 0);
}

TEST_F(OtherPrograms, compile_the_units_from_their_sources)
{
  ASSERT_EQ(shell("python3 -m zipfile --extract macro_element.fmi3.fmu unit"), 0);
  EXPECT_EQ(shell("cc -std=c99 -pedantic -Wall -Wextra -Werror -O2 -fPIC -shared unit/sources/fmu.c unit/sources/fmi.c "
                  "unit/sources/macro_element.c -o unit.so -lm"),
            0);
}

TEST_F(OtherPrograms, get_the_same_bytes_for_the_same_parameters_and_another_token_for_others)
{
  Parameters other = sample();
  other.diameter *= 1 + 1e-15;
  EXPECT_EQ(fmu_of(sample(), 3), fmu_of(sample(), 3));
  EXPECT_NE(fmu_of(sample(), 3), fmu_of(other, 3));
}

/// What the schemas of the standard ask for: elements and attributes, and variables that are numbered as fmu.c has them.
TEST(ModelDescription, has_the_form_of_each_version)
{
  const std::string two = model_description(2, "abc"), three = model_description(3, "abc");
  const auto in_order = [](const std::string& text, const std::vector<const char*>& parts) {
    std::size_t at = 0;
    for (const char* part : parts) {
      at = text.find(part, at);
      ASSERT_NE(at, std::string::npos) << part << " in\n" << text;
    }
  };
  in_order(two, {"fmiVersion=\"2.0\"",
                 "guid=\"abc\"",
                 "<CoSimulation",
                 "canGetAndSetFMUstate=\"true\"",
                 "canSerializeFMUstate=\"true\"",
                 "providesDirectionalDerivative=\"true\"",
                 "<UnitDefinitions>",
                 "<LogCategories>",
                 "<DefaultExperiment",
                 "<ModelVariables>",
                 "name=\"time\" valueReference=\"0\"",
                 "name=\"u\" valueReference=\"2\"",
                 "<Real unit=\"m\" start=\"0\"/>",
                 "name=\"V\" valueReference=\"6\"",
                 "initial=\"calculated\"",
                 "name=\"V_start\" valueReference=\"7\"",
                 "variability=\"fixed\"",
                 "<Outputs>",
                 "<Unknown index=\"5\" dependencies=\"2 3 4\"/>",
                 "<Unknown index=\"6\" dependencies=\"3 4\"/>",
                 "<InitialUnknowns>",
                 "<Unknown index=\"7\"/>"});
  in_order(three, {"fmiVersion=\"3.0\"", "instantiationToken=\"abc\"", "<CoSimulation", "canGetAndSetFMUState=\"true\"",
                   "canSerializeFMUState=\"true\"", "providesDirectionalDerivatives=\"true\"/>", "<UnitDefinitions>",
                   "<Float64 name=\"time\" valueReference=\"0\"", "causality=\"independent\"", "<Float64 name=\"w\" valueReference=\"3\"",
                   "unit=\"m\" start=\"0\"/>", "<Output valueReference=\"4\" dependencies=\"1 2 3\"/>",
                   "<Output valueReference=\"6\" dependencies=\"2 3\"/>", "<InitialUnknown valueReference=\"4\"/>"});
}

TEST_F(OtherPrograms, call_the_user_element_of_Abaqus_in_a_Newton_iteration)
{
  EXPECT_EQ(drive("abaqus", "abaqus_uel.c", ""), 0);
}

TEST_F(OtherPrograms, call_the_external_functions_of_OrcaFlex_in_steps_that_are_tried_again)
{
  EXPECT_EQ(drive("orcaflex", "orcaflex.c", ""), 0);
}

}  // namespace
}  // namespace berm::macro_element_fit::this_file
