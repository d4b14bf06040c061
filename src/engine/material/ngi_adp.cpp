// SPDX-License-Identifier: BSD-3-Clause
#include "material/ngi_adp.hpp"

#include "core/usual.hpp"
#include "material/describe_elasticity.hpp"
#include "material/rigidity_index.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::material {

void describe(Describe& d, NgiAdp& law)
{
  d.value("rigidity_index", law.rigidity_index,
          {.meaning = "shear modulus of unloading and reloading divided by the active strength, G_ur / s_u^A, instead of young_modulus",
           .range = positive});
  describe_elasticity(d, law, !law.rigidity_index);
  describe_shansep(d, law);
  d.value("undrained_strength", law.undrained_strength,
          {.meaning = "undrained shear strength in active shear (triaxial compression), s_u^A",
           .unit = "Pa",
           .range = not_negative,
           .required = law.profile.strength.empty() && !law.shansep});
  d.value("undrained_strength_gradient", law.undrained_strength_gradient,
          {.meaning = "increase of the active strength with depth below the seabed at the start; a particle keeps that of its "
                      "initial position",
           .unit = "Pa/m"});
  d.value(
      "dss_ratio", law.dss_ratio,
      {.meaning = "strength in direct simple shear divided by that in active shear, s_u^DSS / s_u^A", .range = positive, .required = true});
  d.value("passive_ratio", law.passive_ratio,
          {.meaning = "strength in passive shear (triaxial extension) divided by that in active shear, s_u^P / s_u^A",
           .range = positive,
           .required = true});
  const auto strain = [&](const char* key, Real& value, const char* meaning) {
    d.value(key, value, {.meaning = meaning, .range = positive, .required = true});
  };
  strain("active_failure_strain", law.active_failure_strain,
         "shear strain from the start to failure in active shear, e1 - e3: in undrained triaxial compression 3/2 of the axial strain");
  strain("dss_failure_strain", law.dss_failure_strain, "shear strain from the start to failure in direct simple shear");
  strain("passive_failure_strain", law.passive_failure_strain,
         "shear strain from the start to failure in passive shear, e1 - e3: in undrained triaxial extension 3/2 of the axial strain");
  d.value("initial_mobilisation", law.initial_mobilisation,
          {.meaning =
               "shear stress at rest divided by the active strength, tau_0 / s_u^A = (1 - K0) sigma'_v0 / (2 s_u^A): give the k0 that goes "
               "with it",
           .range = {-1, 1}});
  declare_usual(d, {{"undrained_strength", {0, hard_clay}},
                    {"profile.undrained_strength", {0, hard_clay}},
                    {"shansep.pop", {0, 1e7}},
                    {"shansep.ocr", {0, 100}},
                    {"poisson_ratio", {0.3, 0.495}},
                    {"dss_ratio", {0.4, 1}},
                    {"passive_ratio", {0.2, 1}},
                    {"active_failure_strain", {1e-3, 0.15}},
                    {"dss_failure_strain", {1e-3, 0.25}},
                    {"passive_failure_strain", {1e-3, 0.25}},
                    {"initial_mobilisation", {0, 0.9}}});
  take_surface_strength(law);
}

void check(Describe& d, const std::string& path, const NgiAdp& law)
{
  check_rigidity_index(d, path, law);
  const Real begin = law.initial_mobilisation;
  d.check(begin < 1 && begin > -law.passive_ratio, path + ".initial_mobilisation", "is failure: it must lie between -passive_ratio and 1");
  if (!(law.undrained_strength > 0) || !(young_modulus_of(law) > 0)) return;
  const Real per_index = law.undrained_strength / elasticity(law).shear;
  const auto check_strain = [&](const char* key, Real strain, Real rise) {
    d.check(strain > rise * per_index, fmt::format("{}.{}", path, key),
            fmt::format("must be larger than {:.3g}, the elastic strain at failure", rise * per_index));
  };
  check_strain("active_failure_strain", law.active_failure_strain, 1 - begin);
  check_strain("dss_failure_strain", law.dss_failure_strain, law.dss_ratio);
  check_strain("passive_failure_strain", law.passive_failure_strain, law.passive_ratio + begin);
}

NgiAdp at_depth(NgiAdp law, Real depth, Real weight_above)
{
  return with_stiffness_at_depth(law, depth, weight_above);
}

Elasticity elasticity(const NgiAdp& law)
{
  return elasticity(young_modulus_of(law), law.poisson_ratio);
}

YoungPoisson young_poisson(const NgiAdp& law)
{
  return {young_modulus_of(law), law.poisson_ratio};
}

std::string law_name(const NgiAdp&)
{
  return "NGI-ADP";
}

std::vector<FieldInfo> state_fields(const NgiAdp&)
{
  return {{"failure_strain_part", "plastic shear strain divided by that at failure", ""}};
}

void initial_state(const NgiAdp& law, const SymTensor<3>& stress, Real* state)
{
  const PreparedNgiAdp prepared = prepare(law);
  const StretchedStress<3, Real> stretched(stress, prepared.per_radius, prepared.stretch);
  const auto outside = [&](Real kappa) { return stretched.about(prepared.centre_begin + prepared.centre_change * kappa, 1).value > kappa; };
  Real low = 0, high = 1;
  if (!outside(low)) return;
  if (!outside(high))
    for (int k = 0; k < 60; ++k) {
      const Real middle = (low + high) / 2;
      (outside(middle) ? low : high) = middle;
    }
  const Real root = high / (1 + std::sqrt(1 - high * high));
  state[0] = root * root;
}

std::optional<Strength> strength_at_rest(const NgiAdp& law)
{
  return Strength{.cohesion = law.dss_ratio * law.undrained_strength, .cohesion_gradient = law.dss_ratio * law.undrained_strength_gradient};
}

std::optional<NgiAdp> with_strength_over(NgiAdp law, Real factor)
{
  constexpr Real most = 0.999;  // of the strength: at rest it is less than failure
  if (law.rigidity_index) *law.rigidity_index *= factor;
  law.undrained_strength /= factor;
  law.undrained_strength_gradient /= factor;
  for (Real& strength : law.profile.strength) strength /= factor;
  if (law.shansep) law.shansep->ratio /= factor, law.shansep->min_strength /= factor;
  law.initial_mobilisation = std::clamp(law.initial_mobilisation * factor, -most * law.passive_ratio, most);
  return law;
}

PreparedNgiAdp prepare(const NgiAdp& law)
{
  PreparedNgiAdp p;
  const Real begin = law.initial_mobilisation, radius = (1 + law.passive_ratio) / 2;
  p.per_strength = radius;
  p.stretch = radius / law.dss_ratio;
  p.centre_begin = begin / radius;
  p.centre_change = (1 - law.passive_ratio) / (2 * radius) - p.centre_begin;
  p.active = law.active_failure_strain;
  p.dss = law.dss_failure_strain;
  p.passive = law.passive_failure_strain;
  p.rise_active = (1 - begin) / radius;
  p.rise_dss = law.dss_ratio / radius;
  p.rise_passive = (law.passive_ratio + begin) / radius;
  p.per_young_modulus = 1 / young_modulus_of(law);
  p.elastic = elasticity(law);
  p.set_strength(law.undrained_strength);
  return p;
}

}  // namespace berm::material
