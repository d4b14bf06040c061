// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/macro_element_fit/fmu_other_programs_test.cpp
#include "macro_element_fit/fmu.hpp"

#include "fmu/embedded.hpp"
#include "fmu/unit.hpp"
#include "io/sha256.hpp"

#include <fmt/format.h>

namespace berm::macro_element_fit {
namespace {

/// resources/parameters.txt, without its token.
std::string text_of(const macro_element::Parameters& p)
{
  std::string text = fmt::format("version {}\n", p.version);
  for (const berm_macro_element_member& m : berm_macro_element_members)
    text += fmt::format("{} {:.17g}\n", m.name, macro_element::value_of(p, m));
  for (int k = 0; k < p.backbone_points; ++k) text += fmt::format("backbone {:.17g} {:.17g}\n", p.backbone_w[k], p.backbone_V[k]);
  return text;
}

/// Its variables are numbered as fmu.c has them. H and V do not depend on x.
fmu::Unit unit_of(const std::string& token)
{
  return {.identifier = "berm_macro_element",
          .description = "Force between 1 m of pipe and the seabed",
          .variables = {{"time", "independent", "s", "time"},
                        {"x", "input", "m", "axial displacement of the pipe at the end of the next step"},
                        {"u", "input", "m", "lateral displacement of the pipe at the end of the next step"},
                        {"w", "input", "m", "embedment of the invert at the end of the next step, positive downwards"},
                        {"T", "output", "N/m", "force of the pipe on the soil along x", {1, 2, 3}},
                        {"H", "output", "N/m", "force of the pipe on the soil along u", {2, 3}},
                        {"V", "output", "N/m", "reaction of the soil on the pipe, positive upwards", {2, 3}},
                        {"V_start", "parameter", "N/m", "V on the pipe at the start, which was pushed straight down to its position"}},
          .has_derivatives = true,
          .has_bytes_of_states = true,
          .needs_berm = false,
          .library = fmu_library,
          .token = token,
          .sources = {"fmu.c", "fmi.c", "macro_element.c"}};
}

}  // namespace

std::string model_description(int fmi_version, const std::string& token)
{
  return fmu::model_description(fmi_version, unit_of(token));
}

std::string fmu_of(const macro_element::Parameters& parameters, int fmi_version)
{
  const std::string numbers = text_of(parameters), token = io::sha256_of(numbers), resource = "token " + token + "\n" + numbers;
  fmu::Unit unit = unit_of(token);
  unit.files = {{"resources/parameters.txt", resource}, {"sources/fmu.c", fmu_code},         {"sources/fmi.c", fmu::fmi_c},
                {"sources/fmi.h", fmu::fmi_h},          {"sources/macro_element.c", code_c}, {"sources/macro_element.h", code_h}};
  return fmu::archive_of(fmi_version, unit);
}

}  // namespace berm::macro_element_fit
