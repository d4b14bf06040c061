// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/macro_element_fit/fmu_other_programs_test.cpp
#include "macro_element_fit/fmu.hpp"

#include "io/revision.hpp"
#include "io/sha256.hpp"
#include "io/zip.hpp"

#include <fmt/format.h>

namespace berm::macro_element_fit {
namespace {

constexpr const char* identifier = "berm_macro_element";

/// A variable; its value reference is its place in the list, as fmu.c has it.
struct Variable {
  const char *name, *causality, *unit, *description;
};
constexpr Variable variables[] = {
    {"time", "independent", "s", "time"},
    {"x", "input", "m", "displacement along the pipe at the end of the next step"},
    {"u", "input", "m", "displacement across the pipe at the end of the next step"},
    {"w", "input", "m", "embedment of the invert at the end of the next step, positive downwards"},
    {"T", "output", "N/m", "force of the pipe on the soil along x"},
    {"H", "output", "N/m", "force of the pipe on the soil along u"},
    {"V", "output", "N/m", "reaction of the soil on the pipe, positive upwards"},
    {"V_start", "parameter", "N/m", "V on the pipe at the start, which was pushed straight down to where it lies"},
};

bool is(const Variable& v, std::string_view causality)
{
  return v.causality == causality;
}

/// What stands in the attributes of a variable of either version: an input and a parameter begin at 0.
std::string attributes_of(const Variable& v, std::size_t reference)
{
  return fmt::format(R"(name="{}" valueReference="{}" description="{}" causality="{}" variability="{}"{})", v.name, reference,
                     v.description, v.causality, is(v, "parameter") ? "fixed" : "continuous",
                     is(v, "output")      ? R"( initial="calculated")"
                     : is(v, "parameter") ? R"( initial="exact")"
                                          : "");
}

std::string type_of(const Variable& v)
{
  return fmt::format(R"(unit="{}"{})", v.unit, is(v, "input") || is(v, "parameter") ? R"( start="0")" : "");
}

/// The inputs that an output depends on; FMI 2.0 counts variables from 1, FMI 3.0 has their references. H and V do not depend on x.
std::string unknown_of(int fmi_version, std::size_t reference)
{
  const std::size_t shift = fmi_version == 2 ? 1 : 0, first = std::string_view(variables[reference].name) == "T" ? 1 : 2;
  std::string dependencies;
  for (std::size_t k = first; k <= 3; ++k) dependencies += fmt::format("{}{}", k > first ? " " : "", k + shift);
  return fmi_version == 2 ? fmt::format(R"(      <Unknown index="{}" dependencies="{}"/>)", reference + 1, dependencies)
                          : fmt::format(R"(    <Output valueReference="{}" dependencies="{}"/>)", reference, dependencies);
}

/// resources/parameters.txt, without its token.
std::string text_of(const macro_element::Parameters& p)
{
  std::string text = fmt::format("version {}\n", p.version);
  for (const berm_macro_element_member& m : berm_macro_element_members)
    text += fmt::format("{} {:.17g}\n", m.name, macro_element::value_of(p, m));
  for (int k = 0; k < p.backbone_points; ++k) text += fmt::format("backbone {:.17g} {:.17g}\n", p.backbone_w[k], p.backbone_V[k]);
  return text;
}

}  // namespace

std::string model_description(int fmi_version, const std::string& token)
{
  const bool two = fmi_version == 2;
  std::string text = fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{}.0" modelName="{}" {}="{}" description="Force between 1 m of pipe and the seabed" generationTool="berm {}">
  <CoSimulation modelIdentifier="{}" canHandleVariableCommunicationStepSize="true" canGetAndSetFMU{state}="true" canSerializeFMU{state}="true")",
                                 fmi_version, identifier, two ? "guid" : "instantiationToken", token, io::version_words(), identifier,
                                 fmt::arg("state", two ? "state" : "State"));
  text += two ? R"( canNotUseMemoryManagementFunctions="true" providesDirectionalDerivative="true">
    <SourceFiles>
      <File name="fmu.c"/>
      <File name="macro_element.c"/>
    </SourceFiles>
  </CoSimulation>
)"
              : " providesDirectionalDerivatives=\"true\"/>\n";
  text += R"(  <UnitDefinitions>
    <Unit name="s"><BaseUnit s="1"/></Unit>
    <Unit name="m"><BaseUnit m="1"/></Unit>
    <Unit name="N/m"><BaseUnit kg="1" s="-2"/></Unit>
  </UnitDefinitions>
  <LogCategories>
    <Category name="logStatusError"/>
  </LogCategories>
  <DefaultExperiment startTime="0"/>
  <ModelVariables>
)";
  for (std::size_t k = 0; k < std::size(variables); ++k)
    text += two ? fmt::format("    <ScalarVariable {}><Real {}/></ScalarVariable>\n", attributes_of(variables[k], k), type_of(variables[k]))
                : fmt::format("    <Float64 {} {}/>\n", attributes_of(variables[k], k), type_of(variables[k]));
  text += "  </ModelVariables>\n  <ModelStructure>\n";
  std::string outputs, initial;
  for (std::size_t k = 0; k < std::size(variables); ++k) {
    if (!is(variables[k], "output")) continue;
    outputs += unknown_of(fmi_version, k) + "\n";
    initial +=
        two ? fmt::format("      <Unknown index=\"{}\"/>\n", k + 1) : fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", k);
  }
  text += two ? "    <Outputs>\n" + outputs + "    </Outputs>\n    <InitialUnknowns>\n" + initial + "    </InitialUnknowns>\n"
              : outputs + initial;
  return text + "  </ModelStructure>\n</fmiModelDescription>\n";
}

std::string fmu_of(const macro_element::Parameters& parameters, int fmi_version)
{
  const std::string numbers = text_of(parameters), token = io::sha256_of(numbers), resource = "token " + token + "\n" + numbers;
  const std::string description = model_description(fmi_version, token);
  const std::string machine = fmi_version == 2 && BERM_PROCESSOR == std::string_view("x86_64") ? "linux64" : BERM_PROCESSOR "-linux";
  std::vector<io::ZipEntry> files = {{"modelDescription.xml", description},
                                     {"resources/parameters.txt", resource},
                                     {fmt::format("binaries/{}/{}.so", machine, identifier), fmu_library},
                                     {"sources/fmu.c", fmu_code},
                                     {"sources/macro_element.c", code_c},
                                     {"sources/macro_element.h", code_h}};
  if (fmi_version == 3)
    files.push_back({"sources/buildDescription.xml", R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="berm_macro_element">
    <SourceFileSet language="C99">
      <SourceFile name="fmu.c"/>
      <SourceFile name="macro_element.c"/>
    </SourceFileSet>
    <Library name="m" external="true"/>
  </BuildConfiguration>
</fmiBuildDescription>
)"});
  return io::zip_of(files);
}

}  // namespace berm::macro_element_fit
