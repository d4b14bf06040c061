// SPDX-License-Identifier: BSD-3-Clause
#include "material/modified_cam_clay.hpp"

#include "core/usual.hpp"
#include "material/describe_elasticity.hpp"

#include <algorithm>

namespace berm::material {

void describe(Describe& d, ModifiedCamClay& law)
{
  describe_density(d, law);
  d.value("critical_friction_angle", law.critical_friction_angle,
          {.meaning = "angle of friction at the critical state in triaxial compression, M = 6 sin phi / (3 - sin phi)",
           .unit = "rad",
           .range = {1e-3, 1.2},
           .required = true});
  d.value("compression_index", law.compression_index,
          {.meaning = "lambda, the slope of virgin compression in void ratio against log(p'), natural logarithm",
           .range = positive,
           .required = true});
  d.value("swelling_index", law.swelling_index,
          {.meaning = "kappa, the slope of unloading and reloading, less than compression_index", .range = positive, .required = true});
  d.value("void_ratio", law.void_ratio, {.meaning = "void ratio at the start", .range = positive, .required = true});
  d.value("overconsolidation_ratio", law.overconsolidation_ratio,
          {.meaning = "largest past vertical effective stress divided by that at the start", .range = {1, infinity}});
  describe_deviatoric_shape(d, law.deviatoric_shape);
  describe_pressure_elasticity(d, law);
  declare_usual(d, {{"critical_friction_angle", {10 * degree, 45 * degree}},
                    {"compression_index", {5e-3, 1.5}},
                    {"swelling_index", {5e-4, 0.5}},
                    {"void_ratio", {0.15, 6}},
                    {"overconsolidation_ratio", {1, 100}}});
}

void check(Describe& d, const std::string& path, const ModifiedCamClay& law)
{
  d.check(law.swelling_index < law.compression_index, path + ".swelling_index",
          "must be less than compression_index: soil swells less than it was compressed");
  check_pressures(d, path, law);
}

Real critical_slope(Real friction_angle)
{
  return 6 * std::sin(friction_angle) / (3 - std::sin(friction_angle));
}

Real virgin_stress_ratio(const ModifiedCamClay& law)
{
  const Real slope = critical_slope(law.critical_friction_angle), lambda = law.compression_index, kappa = law.swelling_index;
  const auto missing = [&](Real ratio) {
    return 2 * ratio / (slope * slope - ratio * ratio) * (lambda - kappa) + kappa * ratio / (3 * shear_over_bulk(law.poisson_ratio)) -
           2. / 3 * lambda;
  };
  Real low = 0, high = slope;  // the left side grows from below zero to infinity
  for (int k = 0; k < 60; ++k) {
    const Real middle = (low + high) / 2;
    (missing(middle) < 0 ? low : high) = middle;
  }
  return low;
}

Real virgin_k0(const ModifiedCamClay& law)
{
  const Real ratio = virgin_stress_ratio(law);
  return (3 - ratio) / (3 + 2 * ratio);
}

Elasticity elasticity(const ModifiedCamClay& law)
{
  return prepare(law).elastic;
}

YoungPoisson young_poisson(const ModifiedCamClay& law)
{
  return {young_modulus(elasticity(law)), law.poisson_ratio};
}

std::string law_name(const ModifiedCamClay&)
{
  return "modified Cam clay";
}

std::vector<FieldInfo> state_fields(const ModifiedCamClay&)
{
  return {{"preconsolidation_pressure", "preconsolidation pressure p_c", "Pa"}};
}

void initial_state(const ModifiedCamClay& law, const SymTensor<3>& stress, Real* state)
{
  const PreparedModifiedCamClay prepared = prepare(law);
  const Real ratio = virgin_stress_ratio(law), slope_square = 1 / prepared.per_slope_square;
  const Real vertical = law.overconsolidation_ratio * std::max(Real(0), -stress[1]), past = vertical * 3 / (3 + 2 * ratio);
  const Invariants now = equivalent_invariants(prepared.shape, stress, law.min_pressure);
  state[0] = std::max(
      {past * (1 + ratio * ratio / slope_square), now.pressure + now.q * now.q / (slope_square * now.pressure), 2 * law.min_pressure});
}

PreparedModifiedCamClay prepare(const ModifiedCamClay& law)
{
  const Real slope = critical_slope(law.critical_friction_angle), volume = 1 + law.void_ratio;
  PreparedModifiedCamClay prepared;
  prepared.moduli = {volume / law.swelling_index, shear_over_bulk(law.poisson_ratio), law.min_pressure, law.max_pressure};
  prepared.elastic = stiffest(prepared.moduli);
  prepared.shape = law.deviatoric_shape;
  prepared.per_slope_square = 1 / (slope * slope);
  prepared.hardening = volume / (law.compression_index - law.swelling_index);
  return prepared;
}

}  // namespace berm::material
