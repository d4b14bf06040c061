// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/describe.hpp"
#include "core/field_info.hpp"
#include "material/shansep.hpp"

#include <algorithm>

namespace berm::material {

/// Values over depth below the bed's surface at the start, linear between the entries and constant beyond them; an empty list: not given here.
struct DepthProfile {
  std::vector<Real> depth;                    ///< m, ascending
  std::vector<Real> strength, young_modulus;  ///< Pa
  std::vector<Real> ocr;                      ///< overconsolidation ratio, of a law with shansep

  bool empty() const { return depth.empty(); }
  bool operator==(const DepthProfile&) const = default;
};

/// The profile of a law, whose word for its strength is Law::strength_key, null where it has none.
template <class Law>
struct ProfileOf : DepthProfile {
  bool operator==(const ProfileOf&) const = default;
};

template <class Law>
void describe(Describe& d, ProfileOf<Law>& profile)
{
  d.value("depth", profile.depth,
          {.meaning = "depths below the seabed, the smallest first", .unit = "m", .range = not_negative, .required = true});
  if constexpr (Law::strength_key != nullptr)
    d.value(Law::strength_key, profile.strength,
            {.meaning = "strength at these depths, instead of the key of the same name above", .unit = "Pa", .range = not_negative});
  if constexpr (Law::strength_key != nullptr)
    d.value("ocr", profile.ocr, {.meaning = "overconsolidation ratio at these depths, for shansep", .range = {0, 1e4, true}});
  d.value("young_modulus", profile.young_modulus,
          {.meaning = "Young's modulus at these depths, instead of the key of the same name above", .unit = "Pa", .range = positive});
}

/// The value of a profile at a depth, m.
Real value_at(const DepthProfile& profile, const std::vector<Real>& values, Real depth);

/// The members that hold a law's strength at the surface, Pa, and its increase with depth, Pa/m; null where the law has none.
struct StrengthAtDepth {
  Real *value = nullptr, *gradient = nullptr;
};

/// A law whose strength may follow from the vertical stress.
template <class Law>
concept KnowsStressHistory = requires(Law law)
{
  law.shansep;
};

/// Sets the strength at the surface to that of the profile, or to the least by the vertical stress.
template <class Law>
void take_surface_strength(Law& law)
{
  const StrengthAtDepth strength = strength_at_depth(law);
  if (*strength.value != 0) return;
  if (!law.profile.strength.empty()) *strength.value = law.profile.strength.front();
  if (law.shansep) *strength.value = law.shansep->min_strength;
}

/// Declares the strength by the vertical stress.
template <class Law>
void describe_shansep(Describe& d, Law& law)
{
  d.optional_table("shansep", law.shansep,
                   {.meaning = "undrained strength by the vertical effective stress at the start, S sigma'_v0 OCR^m, instead of the "
                               "strength itself; a particle keeps that of its initial position"});
}

/// A law that knows gradients and a profile; the others are the same at all depths.
template <class Law>
concept KnowsDepth = requires(Law law)
{
  law.profile;
  law.young_modulus_gradient;
  strength_at_depth(law);
};

/// Whether strength or stiffness of a law change with depth.
template <class Law>
bool varies([[maybe_unused]] Law law)
{
  if constexpr (KnowsStressHistory<Law>)
    if (law.shansep) return true;
  if constexpr (KnowsDepth<Law>) {
    const StrengthAtDepth strength = strength_at_depth(law);
    return !law.profile.empty() || law.young_modulus_gradient != 0 || (strength.gradient != nullptr && *strength.gradient != 0);
  }
  return false;
}

/// The law with the strength and the stiffness at a depth, m, under the weight of the soil above over area, Pa; above the surface with those of the surface.
template <class Law>
Law at_depth(Law law, [[maybe_unused]] Real depth, [[maybe_unused]] Real weight_above = 0)
{
  if constexpr (KnowsDepth<Law>) {
    depth = std::max(Real(0), depth);
    if (const StrengthAtDepth strength = strength_at_depth(law); strength.value != nullptr) {
      *strength.value += *strength.gradient * depth;
      if (!law.profile.strength.empty()) *strength.value = value_at(law.profile, law.profile.strength, depth);
      *strength.gradient = 0;
    }
    if constexpr (KnowsStressHistory<Law>)
      if (law.shansep) {
        std::optional<Real> ocr;
        if (!law.profile.ocr.empty()) ocr = value_at(law.profile, law.profile.ocr, depth);
        *strength_at_depth(law).value = strength_by(*law.shansep, weight_above, ocr);
        law.shansep.reset();
      }
    law.young_modulus += law.young_modulus_gradient * depth;
    if (!law.profile.young_modulus.empty()) law.young_modulus = value_at(law.profile, law.profile.young_modulus, depth);
    law.young_modulus_gradient = 0;
    law.profile = {};
  }
  return law;
}

/// What a particle keeps for itself where the soil varies, of a law at one depth, Pa: the strength, if the law has one, and Young's modulus.
template <class Law>
std::vector<Real> local_values([[maybe_unused]] Law law)
{
  if constexpr (KnowsDepth<Law>) {
    const StrengthAtDepth strength = strength_at_depth(law);
    return strength.value == nullptr ? std::vector<Real>{law.young_modulus} : std::vector<Real>{*strength.value, law.young_modulus};
  }
  return {};
}

/// The law with these values, without its profile.
template <class Law>
Law with_local_values(Law law, [[maybe_unused]] const Real* own)
{
  if constexpr (KnowsDepth<Law>) {
    if (const StrengthAtDepth strength = strength_at_depth(law); strength.value != nullptr) *strength.value = *own++;
    law.young_modulus = *own;
    law.profile = {};
    if constexpr (KnowsStressHistory<Law>) law.shansep.reset();
  }
  return law;
}

/// Name, label and unit of these values, as fields of particles.
std::vector<FieldInfo> local_fields(const char* strength_key);
template <class Law>
std::vector<FieldInfo> local_fields(const Law&)
{
  if constexpr (KnowsDepth<Law>) return local_fields(Law::strength_key);
  return {};
}

/// The number of these values.
template <class Prepared>
constexpr int local_size()
{
  if constexpr (requires { Prepared::local_size; })
    return Prepared::local_size;
  else
    return 0;
}

/// A law that keeps none is the same for all particles.
template <class Prepared, class T>
[[gnu::always_inline]] inline const Prepared& with_local(const Prepared& law, const T* /*own*/)
{
  return law;
}

/// Refuses a profile of the table at `path` that is none, and a value that is given twice.
void check_profile(Describe& d, const std::string& path, const DepthProfile& profile, const char* strength_key,
                   const StrengthAtDepth& strength, Real young_modulus, Real young_modulus_gradient);

/// Refuses a strength by the vertical stress that the table at `path` gives another way too.
void check_stress_history(Describe& d, const std::string& path, const Shansep& shansep, const DepthProfile& profile,
                          const std::string& strength_key, const StrengthAtDepth& strength);

template <class Law>
void check_depths([[maybe_unused]] Describe& d, [[maybe_unused]] const std::string& path, [[maybe_unused]] Law law)
{
  if constexpr (KnowsStressHistory<Law>) {
    if (law.shansep) check_stress_history(d, path, *law.shansep, law.profile, Law::strength_key, strength_at_depth(law));
    d.check(law.shansep || law.profile.ocr.empty(), path + ".profile.ocr", "is for a strength by shansep, and there is none");
  }
  if constexpr (KnowsDepth<Law>)
    if (!law.profile.empty())
      check_profile(d, path, law.profile, Law::strength_key, strength_at_depth(law), law.young_modulus, law.young_modulus_gradient);
}

}  // namespace berm::material
