// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fmu/slice_unit_test.cpp
#include "fmu/unit.hpp"

#include "io/revision.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::fmu {
namespace {

constexpr struct {
  std::string_view name, base;
} known_units[] = {
    {"s", R"(s="1")"}, {"m", R"(m="1")"}, {"m/s", R"(m="1" s="-1")"}, {"N/m", R"(kg="1" s="-2")"}, {"kg/m", R"(kg="1" m="-1")"}};

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

/// The inputs that an output depends on; FMI 2.0 counts variables from 1, FMI 3.0 has their references.
std::string unknown_of(int fmi_version, const Variable& v, std::size_t reference)
{
  std::vector<std::size_t> inputs = v.inputs;
  if (fmi_version == 3) return fmt::format(R"(    <Output valueReference="{}" dependencies="{}"/>)", reference, text_of_list(inputs, " "));
  for (std::size_t& input : inputs) ++input;
  return fmt::format(R"(      <Unknown index="{}" dependencies="{}"/>)", reference + 1, text_of_list(inputs, " "));
}

}  // namespace

std::string model_description(int fmi_version, const Unit& unit)
{
  const bool two = fmi_version == 2;
  std::string text =
      fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="{}.0" modelName="{}" {}="{}" description="{}" generationTool="berm {}">
  <CoSimulation modelIdentifier="{}"{} canHandleVariableCommunicationStepSize="true" canGetAndSetFMU{state}="true")",
                  fmi_version, unit.identifier, two ? "guid" : "instantiationToken", unit.token, unit.description, io::version_words(),
                  unit.identifier, unit.needs_berm ? R"( needsExecutionTool="true")" : "", fmt::arg("state", two ? "state" : "State"));
  if (unit.has_bytes_of_states) text += fmt::format(R"( canSerializeFMU{}="true")", two ? "state" : "State");
  if (two) text += R"( canNotUseMemoryManagementFunctions="true")";
  if (unit.has_derivatives) text += fmt::format(R"( providesDirectionalDerivative{}="true")", two ? "" : "s");
  if (two && !unit.sources.empty()) {
    text += ">\n    <SourceFiles>\n";
    for (const char* source : unit.sources) text += fmt::format("      <File name=\"{}\"/>\n", source);
    text += "    </SourceFiles>\n  </CoSimulation>\n";
  } else {
    text += "/>\n";
  }
  text += "  <UnitDefinitions>\n";
  for (const auto& [name, base] : known_units)
    if (std::any_of(unit.variables.begin(), unit.variables.end(), [&](const Variable& v) { return v.unit == name; }))
      text += fmt::format("    <Unit name=\"{}\"><BaseUnit {}/></Unit>\n", name, base);
  text += R"(  </UnitDefinitions>
  <LogCategories>
    <Category name="logStatusError"/>
  </LogCategories>
  <DefaultExperiment startTime="0"/>
  <ModelVariables>
)";
  const std::vector<Variable>& variables = unit.variables;
  for (std::size_t k = 0; k < variables.size(); ++k)
    text += two ? fmt::format("    <ScalarVariable {}><Real {}/></ScalarVariable>\n", attributes_of(variables[k], k), type_of(variables[k]))
                : fmt::format("    <Float64 {} {}/>\n", attributes_of(variables[k], k), type_of(variables[k]));
  text += "  </ModelVariables>\n  <ModelStructure>\n";
  std::string outputs, initial;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    if (!is(variables[k], "output")) continue;
    outputs += unknown_of(fmi_version, variables[k], k) + "\n";
    initial +=
        two ? fmt::format("      <Unknown index=\"{}\"/>\n", k + 1) : fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", k);
  }
  text += two ? "    <Outputs>\n" + outputs + "    </Outputs>\n    <InitialUnknowns>\n" + initial + "    </InitialUnknowns>\n"
              : outputs + initial;
  return text + "  </ModelStructure>\n</fmiModelDescription>\n";
}

std::string archive_of(int fmi_version, const Unit& unit)
{
  const std::string description = model_description(fmi_version, unit);
  const std::string machine = fmi_version == 2 && BERM_PROCESSOR == std::string_view("x86_64") ? "linux64" : BERM_PROCESSOR "-linux";
  std::vector<io::ZipEntry> files = unit.files;
  files.insert(files.begin(),
               {{"modelDescription.xml", description}, {fmt::format("binaries/{}/{}.so", machine, unit.identifier), unit.library}});
  std::string build = fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="{}">
    <SourceFileSet language="C99">
)",
                                  unit.identifier);
  for (const char* source : unit.sources) build += fmt::format("      <SourceFile name=\"{}\"/>\n", source);
  build += R"(    </SourceFileSet>
    <Library name="m" external="true"/>
  </BuildConfiguration>
</fmiBuildDescription>
)";
  if (fmi_version == 3 && !unit.sources.empty()) files.push_back({"sources/buildDescription.xml", build});
  return io::zip_of(files);
}

}  // namespace berm::fmu
