// SPDX-License-Identifier: BSD-3-Clause
// Units of a slice of soil. tests/interfaces/slice_fmu.c runs them.
#include "fmu/slice_unit.hpp"
#include "input/read_case.hpp"
#include "io/scratch_folder.hpp"
#include "os/error.hpp"
#include "samples/error_of.hpp"

#include <fstream>
#include <gtest/gtest.h>

namespace berm::fmu::this_file {
namespace {

const std::filesystem::path slice = BERM_SOURCE_DIR "/tests/interfaces/slice.toml";

settings::Case slice_with(const std::vector<std::string>& set)
{
  return input::read_case(slice, set);
}

std::string unit_with(const std::vector<std::string>& set, int version = 3)
{
  return fmu_of_slice(slice_with(set), slice.parent_path(), version);
}

void expect_in_order(const std::string& text, const std::vector<const char*>& parts)
{
  std::size_t at = 0;
  for (const char* part : parts) {
    at = text.find(part, at);
    ASSERT_NE(at, std::string::npos) << part << " in\n" << text;
  }
}

/// What the schemas of the standard ask for: elements and attributes, and variables that are numbered as slice.c has them.
TEST(SliceDescription, has_the_form_of_each_version)
{
  const std::string two = slice_description(2, "abc"), three = slice_description(3, "abc");
  expect_in_order(two, {"fmiVersion=\"2.0\"",
                        "guid=\"abc\"",
                        "<CoSimulation modelIdentifier=\"berm_slice\" needsExecutionTool=\"true\"",
                        "canHandleVariableCommunicationStepSize=\"true\"",
                        "canGetAndSetFMUstate=\"true\"",
                        "/>",
                        "<UnitDefinitions>",
                        "<Unit name=\"kg/m\"",
                        "<LogCategories>",
                        "<DefaultExperiment",
                        "<ModelVariables>",
                        "name=\"time\" valueReference=\"0\"",
                        "name=\"v_w\" valueReference=\"2\"",
                        "<Real unit=\"m/s\" start=\"0\"/>",
                        "name=\"H\" valueReference=\"3\"",
                        "initial=\"calculated\"",
                        "name=\"contact_mass\" valueReference=\"7\"",
                        "<Outputs>",
                        "<Unknown index=\"4\" dependencies=\"\"/>",
                        "<Unknown index=\"8\" dependencies=\"\"/>",
                        "<InitialUnknowns>",
                        "<Unknown index=\"8\"/>"});
  expect_in_order(three, {"fmiVersion=\"3.0\"", "instantiationToken=\"abc\"", "needsExecutionTool=\"true\"",
                          "canGetAndSetFMUState=\"true\"", "/>", "<UnitDefinitions>", "<Float64 name=\"v_u\" valueReference=\"1\"",
                          "causality=\"input\"", "<Float64 name=\"w\" valueReference=\"6\"",
                          "<Output valueReference=\"3\" dependencies=\"\"/>", "<InitialUnknown valueReference=\"7\"/>"});
  for (const std::string& text : {two, three})
    for (const char* none : {"canSerialize", "providesDirectional", "SourceFiles"}) EXPECT_EQ(text.find(none), std::string::npos) << none;
}

TEST(SliceUnit, has_the_same_bytes_for_the_same_case_and_another_token_for_another)
{
  EXPECT_EQ(unit_with({}), unit_with({}));
  const std::string unit = unit_with({}), other = unit_with({"material.sand.poisson_ratio=0.26"});
  const auto token_in = [](const std::string& of) { return of.substr(of.find("instantiationToken=\"") + 20, 64); };
  EXPECT_NE(token_in(unit), token_in(other));
  for (const std::string& of : {unit, unit_with({}, 2)})
    expect_in_order(of, {"binaries/", "berm_slice.so", "resources/case.toml", "law = \"mohr_coulomb\"", "resources/unit.txt",
                         "stage follow\n", "documentation/externalDependencies.txt", "libberm.so."});
}

TEST(SliceUnit, holds_the_mesh_that_its_case_names)
{
  const io::ScratchFolder folder;
  std::ofstream(folder.path() / "of mine.msh") << "a mesh\n";
  settings::Case settings = slice_with({});
  settings.mesh = mesh::GmshFile{"of mine.msh"};
  const std::string unit = fmu_of_slice(settings, folder.path(), 2);
  expect_in_order(unit, {"resources/mesh.msh", "a mesh\n", "resources/case.toml", "file = \"mesh.msh\""});
}

TEST(SliceUnit, is_refused_where_the_case_is_no_slice_that_its_last_stage_drives)
{
  const auto error_with = [](const std::vector<std::string>& set) { return test::error_of<KeyError>([&] { unit_with(set); }); };
  EXPECT_EQ(error_with({"stage.follow.kind=\"free\"", "stage.follow.drive={}"}).substr(0, 70),
            "stage[2].kind: FMU export needs kind = \"drive\" as the last stage, whic");
  EXPECT_THROW(unit_with({"stage.follow.kind=\"free\"", "stage.follow.drive={}"}), NoDrive);
  settings::Case settings = slice_with({});
  settings.geometry = settings::Geometry::axisymmetric;
  const auto error_of = [&] { return test::error_of<KeyError>([&] { fmu_of_slice(settings, "", 2); }); };
  EXPECT_EQ(error_of().substr(0, 9), "geometry:");
  settings = slice_with({});
  settings.rigid.push_back(settings.rigid.front());
  EXPECT_EQ(error_of().substr(0, 6), "rigid:");
  settings = slice_with({});
  settings.method = settings::Method::fem;
  EXPECT_EQ(error_of().substr(0, 7), "method:");
  settings = slice_with({});
  settings.pipeline.emplace();
  EXPECT_EQ(error_of().substr(0, 9), "pipeline:");
}

TEST(SliceUnit, is_made_of_a_case_with_the_stage_that_its_refusal_gives)
{
  const io::ScratchFolder folder;
  std::ifstream read(slice);
  std::string text{std::istreambuf_iterator<char>(read), {}};
  text.erase(text.find("# Its caller drives it"), text.find("[output]") - text.find("# Its caller drives it"));
  for (const char* mass : {"mass = \"1 kg/m\"", ""}) {
    std::string of_body = text;
    of_body.replace(of_body.find("mass = \"1 kg/m\""), 15, mass);
    const std::filesystem::path file = folder.path() / "case.toml";
    std::ofstream(file) << of_body;
    std::string stage;
    try {
      fmu_of_slice(input::read_case(file, {}), folder.path(), 3);
    } catch (const NoDrive& error) {
      stage = error.stage;
    }
    EXPECT_EQ(stage.find("hold = true    #") != std::string::npos, *mass != 0) << stage;
    std::ofstream(file, std::ios::app) << "\n" << stage;
    expect_in_order(fmu_of_slice(input::read_case(file, {}), folder.path(), 3), {"stage co_simulation\n"});
  }
}

}  // namespace
}  // namespace berm::fmu::this_file
