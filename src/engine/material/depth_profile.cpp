// SPDX-License-Identifier: BSD-3-Clause
#include "material/depth_profile.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::material {

Real value_at(const DepthProfile& profile, const std::vector<Real>& values, Real depth)
{
  const auto below = std::upper_bound(profile.depth.begin(), profile.depth.end(), depth);
  if (below == profile.depth.begin()) return values.front();
  if (below == profile.depth.end()) return values.back();
  const std::size_t k = static_cast<std::size_t>(below - profile.depth.begin());
  return std::lerp(values[k - 1], values[k], (depth - profile.depth[k - 1]) / (profile.depth[k] - profile.depth[k - 1]));
}

std::vector<FieldInfo> local_fields(const char* strength_key)
{
  std::vector<FieldInfo> fields;
  if (strength_key != nullptr) {
    std::string word = strength_key;
    std::replace(word.begin(), word.end(), '_', ' ');
    fields.push_back({strength_key, word, "Pa"});
  }
  fields.push_back({"young_modulus", "Young's modulus", "Pa"});
  return fields;
}

void check_profile(Describe& d, const std::string& path, const DepthProfile& profile, const char* strength_key,
                   const StrengthAtDepth& strength, Real young_modulus, Real young_modulus_gradient)
{
  const std::vector<Real>& depth = profile.depth;
  d.check(depth.size() > 1, path + ".profile.depth", "needs two depths at least");
  d.check(std::adjacent_find(depth.begin(), depth.end(), std::greater_equal<>()) == depth.end(), path + ".profile.depth",
          "each depth must be larger than the one before");
  d.check(!profile.strength.empty() || !profile.young_modulus.empty() || !profile.ocr.empty(), path + ".profile",
          strength_key == nullptr ? "needs young_modulus" : fmt::format("needs {}, young_modulus or both", strength_key));
  const auto check_size = [&](const char* key, const std::vector<Real>& values) {
    d.check(values.empty() || values.size() == depth.size(), fmt::format("{}.profile.{}", path, key),
            fmt::format("needs a value for each of the {} depths, and has {}", depth.size(), values.size()));
  };
  const auto check_one = [&](const char* key, const std::vector<Real>& values, Real at_surface, Real gradient) {
    if (values.empty()) return;
    check_size(key, values);
    d.check(at_surface == values.front(), path + "." + key, fmt::format("is given by profile.{}: leave it out", key));
    d.check(gradient == 0, fmt::format("{}.{}_gradient", path, key), fmt::format("cannot be combined with profile.{}", key));
  };
  if (strength_key != nullptr) check_one(strength_key, profile.strength, *strength.value, *strength.gradient);
  check_one("young_modulus", profile.young_modulus, young_modulus, young_modulus_gradient);
  check_size("ocr", profile.ocr);
}

void check_stress_history(Describe& d, const std::string& path, const Shansep& shansep, const DepthProfile& profile,
                          const std::string& strength_key, const StrengthAtDepth& strength)
{
  constexpr const char* twice = "is given by shansep: leave one of them out";
  d.check(*strength.value == shansep.min_strength, path + "." + strength_key, twice);
  d.check(*strength.gradient == 0, fmt::format("{}.{}_gradient", path, strength_key), twice);
  d.check(profile.strength.empty(), fmt::format("{}.profile.{}", path, strength_key), twice);
  check_shansep(d, path + ".shansep", shansep, !profile.ocr.empty());
}

}  // namespace berm::material
