// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sanity/sanity_test.cpp
#include "material/laws.hpp"
#include "sanity/questions.hpp"
#include "sanity/sanity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sanity {
namespace {

/// The smallest overconsolidation ratio that the input gives, and its key; infinity where it gives none.
std::pair<Real, std::string> smallest_ocr(const material::Material& material)
{
  Real smallest = material::shansep(material)->ocr.value_or(infinity);
  std::string key = "shansep.ocr";
  material::visit(
      [&](const auto& law) {
        if constexpr (material::KnowsStressHistory<std::decay_t<decltype(law)>>)
          for (const Real ocr : law.profile.ocr)
            if (ocr < smallest) smallest = ocr, key = "profile.ocr";
      },
      material);
  return {smallest, key};
}

/// Whether another body of other soil lies above a part of this one.
bool has_another_above(const Scene& s, Index body, Index other)
{
  const Spans &own = s.bodies[body].space, &over = s.bodies[other].space;
  const auto overlaps = [&](int d) {
    return d == s.up || !(own[d].to > own[d].from) || (over[d].from < own[d].to && own[d].from < over[d].to);
  };
  const bool above = s.up_sign > 0 ? over[s.up].to > own[s.up].to : over[s.up].from < own[s.up].from;
  return above && overlaps(0) && overlaps(1) && overlaps(2);
}

}  // namespace

void is_the_strength_by_stress_that_of_clay(const Scene& s, Findings& found)
{
  constexpr Real largest_ratio = 1, largest_exponent = 1.5, rounding = 1e-6;
  for (const auto& [name, material] : s.c.material) {
    const material::Shansep* clay = material::shansep(material);
    if (clay == nullptr) continue;
    const auto key = [&, &own = name](const std::string& word) { return fmt::format("material.{}.{}", own, word); };
    if (clay->ratio > largest_ratio)
      found.warn(key("shansep.ratio"), fmt::format("is {:.3g}: normally consolidated clay has 0.2 to 0.35 of the vertical effective stress "
                                                   "as strength; is it in per cent, or that of an overconsolidated clay?",
                                                   clay->ratio));
    if (clay->exponent > largest_exponent) found.warn(key("shansep.exponent"), fmt::format("is {:.3g}; clay has 0.7 to 1", clay->exponent));
    if (const auto [ocr, word] = smallest_ocr(material); ocr < 1)
      found.warn(key(word), fmt::format("is {:.3g}: below 1 the clay is underconsolidated: it still consolidates, and its effective stress "
                                        "is less than the weight above: take 1 at least",
                                        ocr));
  }
  for (Index b = 0; b < static_cast<Index>(s.bodies.size()); ++b) {
    const settings::BodySoil soil = soil_of(s.c, s.c.body[b].second);
    const auto clay =
        std::find_if(soil.materials.begin(), soil.materials.end(), [](const auto& m) { return material::shansep(m) != nullptr; });
    if (clay == soil.materials.end() || soil.vertical_stress_at_start) continue;
    for (Index other = 0; other < static_cast<Index>(s.bodies.size()); ++other)
      if (other != b && has_another_above(s, b, other) && std::abs(density(s.material_of(other)) / density(*clay) - 1) > rounding)
        found.warn(
            "material." + soil.names[static_cast<std::size_t>(clay - soil.materials.begin())] + ".shansep",
            fmt::format("takes only the weight of [body.{}] above a point, and [body.{}] with another density is above it: give both soils "
                        "as layers of one body",
                        s.c.body[b].first, s.c.body[other].first));
  }
}

}  // namespace berm::sanity
