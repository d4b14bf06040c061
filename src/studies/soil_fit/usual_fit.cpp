// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/measured_test.cpp
#include "soil_fit/usual_fit.hpp"

#include "input/message_text.hpp"
#include "soil_fit/laboratory_table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::soil_fit {
namespace {

/// A key with its usual number; free where it has bounds.
struct UsualKey {
  const char *key, *value, *from = "", *to = "";
};

struct UsualLaw {
  const char* word;
  bool keeps_void_ratio;  ///< of each specimen
  std::vector<UsualKey> drained, undrained;
};

const std::vector<UsualLaw>& laws()
{
  static const std::vector<UsualKey> cam_clay = {{"critical_friction_angle", "\"25 deg\"", "\"15 deg\"", "\"40 deg\""},
                                                 {"compression_index", "0.15", "0.02", "0.6"},
                                                 {"swelling_index", "0.03", "0.002", "0.2"},
                                                 {"overconsolidation_ratio", "1.2", "1", "20"},
                                                 {"poisson_ratio", "0.25"},
                                                 {"max_pressure", "\"5 MPa\""}};
  static const std::vector<UsualKey> norsand = {{"critical_friction_angle", "\"32 deg\"", "\"25 deg\"", "\"42 deg\""},
                                                {"critical_void_ratio", "0.95", "0.6", "1.5"},
                                                {"critical_line_slope", "0.03", "0.004", "0.15"},
                                                {"volumetric_coupling", "0.3", "0", "0.6"},
                                                {"dilatancy", "3.5", "1.5", "8"},
                                                {"hardening_modulus", "150", "20", "800"},
                                                {"hardening_slope", "0", "0", "3000"},
                                                {"rigidity", "400", "80", "800"},
                                                {"poisson_ratio", "0.2"},
                                                {"max_pressure", "\"5 MPa\""}};
  static const std::vector<UsualKey> hypoplastic = {{"critical_friction_angle", "\"32 deg\"", "\"25 deg\"", "\"40 deg\""},
                                                    {"granular_hardness", "\"2 GPa\"", "\"20 MPa\"", "\"50 GPa\""},
                                                    {"hardness_exponent", "0.3", "0.15", "0.6"},
                                                    {"min_void_ratio", "0.6", "0.35", "0.8"},
                                                    {"critical_void_ratio", "0.95", "0.81", "1.15"},
                                                    {"max_void_ratio", "1.2"},
                                                    {"dilatancy_exponent", "0.15", "0.03", "0.4"},
                                                    {"stiffness_exponent", "1.5", "0.5", "4"},
                                                    {"small_strain", "1e-4"},
                                                    {"reversal_stiffness", "4", "1", "10"},
                                                    {"turn_stiffness", "1"},
                                                    {"evolution_exponent", "0.2"},
                                                    {"decay_exponent", "3"},
                                                    {"max_pressure", "\"5 MPa\""}};
  static const std::vector<UsualKey> hardening_soil = {{"secant_modulus", "\"40 MPa\"", "\"23 MPa\"", "\"100 MPa\""},
                                                       {"oedometer_modulus", "\"30 MPa\""},
                                                       {"unloading_modulus", "\"200 MPa\""},
                                                       {"stiffness_exponent", "0.5", "0.2", "1"},
                                                       {"friction_angle", "\"34 deg\"", "\"20 deg\"", "\"48 deg\""},
                                                       {"dilation_angle", "\"4 deg\"", "\"0 deg\"", "\"18 deg\""},
                                                       {"poisson_ratio", "0.2"},
                                                       {"max_pressure", "\"5 MPa\""}};
  static const std::vector<UsualLaw> all = {{"mohr_coulomb",
                                             false,
                                             {{"young_modulus", "\"20 MPa\"", "\"0.5 MPa\"", "\"500 MPa\""},
                                              {"poisson_ratio", "0.3"},
                                              {"friction_angle", "\"33 deg\"", "\"15 deg\"", "\"50 deg\""},
                                              {"dilation_angle", "\"3 deg\"", "\"0 deg\"", "\"15 deg\""}},
                                             {{"young_modulus", "\"5 MPa\"", "\"0.1 MPa\"", "\"200 MPa\""},
                                              {"poisson_ratio", "0.49"},
                                              {"friction_angle", "0"},
                                              {"cohesion", "\"30 kPa\"", "\"0.5 kPa\"", "\"500 kPa\""}}},
                                            {"clay",
                                             false,
                                             {},
                                             {{"undrained_strength", "\"30 kPa\"", "\"0.5 kPa\"", "\"500 kPa\""},
                                              {"rigidity_index", "100", "5", "1000"},
                                              {"poisson_ratio", "0.49"}}},
                                            {"modified_cam_clay", true, cam_clay, cam_clay},
                                            {"norsand", true, norsand, norsand},
                                            {"hypoplastic", true, hypoplastic, hypoplastic},
                                            {"hardening_soil", false, hardening_soil, hardening_soil},
                                            {"ngi_adp",
                                             false,
                                             {},
                                             {{"undrained_strength", "\"30 kPa\"", "\"0.5 kPa\"", "\"500 kPa\""},
                                              {"rigidity_index", "300", "20", "2000"},
                                              {"dss_ratio", "0.7"},
                                              {"passive_ratio", "0.45"},
                                              {"active_failure_strain", "0.02", "0.003", "0.2"},
                                              {"dss_failure_strain", "0.05"},
                                              {"passive_failure_strain", "0.1"},
                                              {"poisson_ratio", "0.49"}}}};
  return all;
}

}  // namespace

std::vector<std::string> usual_laws()
{
  std::vector<std::string> words;
  for (const UsualLaw& law : laws()) words.emplace_back(law.word);
  return words;
}

std::string usual_fit(const UsualFit& request)
{
  const auto law = std::find_if(laws().begin(), laws().end(), [&](const UsualLaw& l) { return l.word == request.law; });
  if (law == laws().end())
    throw InputError(
        fmt::format("{} is neither an input of berm fit (FILE.toml) nor a law that it knows usual numbers of{}; of another law, "
                    "write the input",
                    input::in_quotes(request.law), input::suggestion(request.law, usual_laws())));
  const bool is_penetrometer = request.kind == TBar::word || request.kind == Ball::word;
  static const std::vector<UsualKey> remoulding = {{"undrained_strength", "\"10 kPa\"", "\"0.2 kPa\"", "\"500 kPa\""},
                                                   {"sensitivity", "4", "1.5", "50"},
                                                   {"ductility", "15", "2", "200"},
                                                   {"rigidity_index", "100"},
                                                   {"poisson_ratio", "0.49"}};
  if (is_penetrometer && request.law != "clay")
    throw InputError(fmt::format("{} is a test of clay that softens: berm fit clay TEST.csv --kind {}", request.kind, request.kind));
  if (is_penetrometer == request.diameter.empty())
    throw InputError(is_penetrometer ? "--diameter is needed: that of the tool, such as --diameter \"40 mm\""
                                     : "--diameter is that of a penetrometer: --kind t_bar or --kind ball");
  const std::vector<UsualKey>& keys = is_penetrometer ? remoulding : request.undrained ? law->undrained : law->drained;
  if (keys.empty())
    throw InputError(fmt::format("{} is a law of undrained clay: berm fit {} TESTS.csv --undrained", request.law, request.law));
  std::string measured, void_ratio;
  for (std::size_t k = 0; k < request.files.size(); ++k) {
    MeasuredFile settings;
    settings.name = request.files[k].stem().string();
    for (std::size_t before = 0; before < k; ++before)
      if (request.files[before].stem() == request.files[k].stem())
        settings.name = fmt::format("{}_{}", request.files[k].stem().string(), k + 1);
    if (request.kind == element::Oedometer::word) settings.kind = element::Oedometer{};
    if (request.kind == TBar::word) settings.kind = TBar{};
    if (request.kind == Ball::word) settings.kind = Ball{};
    if (auto* triaxial = std::get_if<element::Triaxial>(&settings.kind)) triaxial->drained = !request.undrained;
    const LaboratoryTable table(request.files[k], settings);
    const auto quoted = [](const std::string& text) { return nlohmann::json(text).dump(); };
    measured += fmt::format("\n[[measured]]\nname = {}\nfile = {}\nkind = \"{}\"\n", quoted(settings.name),
                            quoted(std::filesystem::absolute(request.files[k]).string()), request.kind);
    if (is_penetrometer) measured += fmt::format("diameter = {}\n", quoted(request.diameter));
    if (!is_penetrometer && request.kind != "oedometer" && request.kind != "isotropic")
      measured += fmt::format("drained = {}\n", !request.undrained);
    if (request.extends) measured += "direction = \"extension\"\n";
    if (request.k0) measured += fmt::format("k0 = {}\n", *request.k0);
    if (table.has_column("test")) measured += "test = \"test\"\n";
    if (law->keeps_void_ratio && table.has(Reading::void_ratio)) {
      void_ratio = "void_ratio = 0.8\n";
      measured += fmt::format("specimen = {{void_ratio = {}}}\n", quoted(table.heading_of(Reading::void_ratio)));
    }
  }
  std::string text = fmt::format(
      "# SPDX-License-Identifier: BSD-3-Clause\ntitle = \"{} fitted to {}\"\n\n[material.soil]\nlaw = \"{}\"\ndensity = \"1000 kg/m^3\"\n",
      request.law, request.files.size() == 1 ? request.files[0].filename().string() : fmt::format("{} files", request.files.size()),
      request.law);
  std::string free;
  for (const UsualKey& key : keys) {
    text += fmt::format("{} = {}\n", key.key, key.value);
    if (*key.from != '\0') free += fmt::format("\n[[free]]\nkey = \"{}\"\nfrom = {}\nto = {}\n", key.key, key.from, key.to);
  }
  if (law->keeps_void_ratio && void_ratio.empty()) {
    if (request.law == "norsand") {
      text += "state_parameter = -0.05\n";
      free += "\n[[free]]\nkey = \"state_parameter\"\nfrom = -0.35\nto = 0.15\n";
    } else if (request.law == "hypoplastic") {
      text += "relative_density = 0.5\n";
      free += "\n[[free]]\nkey = \"relative_density\"\nfrom = 0\nto = 1\n";
    } else {
      text += "void_ratio = 1\n";
    }
  }
  return text + void_ratio + free + measured;
}

}  // namespace berm::soil_fit
