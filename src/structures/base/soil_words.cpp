// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/soil_words.hpp"

#include "structures/base/driven_body.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::base {
namespace {

/// "cohesion 2 kPa, Young's modulus 1 MPa".
std::string values_in_words(const material::Material& material)
{
  const std::vector<FieldInfo> fields = local_fields(material);
  const std::vector<Real> values = local_values(material);
  std::vector<std::string> words;
  for (std::size_t k = 0; k < fields.size(); ++k) words.push_back(fmt::format("{} {}", fields[k].label, text::stress_words(values[k])));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string layers_in_words(const problem::BodySoil& soil)
{
  std::string words = fmt::format("\"{}\"", soil.names.front());
  for (const problem::SoilLayer& layer : soil.layers)
    words += fmt::format(", from {} down \"{}\"", text::length_words(layer.top), soil.names[layer.material]);
  for (const auto& [region, number] : soil.of_region) words += fmt::format(", in region \"{}\" \"{}\"", region, soil.names[number]);
  return words;
}

std::vector<std::string> soil_words(const problem::Case& c)
{
  std::vector<std::string> lines;
  for (const auto& [name, settings] : c.body) {
    const problem::BodySoil soil = soil_of(c, settings);
    if (!varies(soil)) continue;
    lines.push_back(fmt::format("soil         body \"{}\": {}", name, layers_in_words(soil)));
    lines.push_back(fmt::format("             at the surface: {}", values_in_words(soil.at("", 0))));
    if (const Real depth = soil_depth(c, problem::ground_of(c), reference_depth(c)); depth > 0)
      lines.push_back(fmt::format("             {} deep, the lowest point of the {}: {}", text::length_words(depth), body_word(c),
                                  values_in_words(soil.at("", depth))));
  }
  return lines;
}

}  // namespace berm::base
