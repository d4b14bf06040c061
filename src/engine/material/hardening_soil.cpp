// SPDX-License-Identifier: BSD-3-Clause
#include "material/hardening_soil.hpp"

#include "core/usual.hpp"
#include "material/describe_elasticity.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::material {

namespace {

/// A stress counted from the apex, compression positive, Pa: P, q, and the strain gamma_p whose shear surface passes through it.
struct StressPoint {
  Real pressure, q, strain;
};

Real initial_modulus(const HardeningSoil& law)
{
  return 2 * law.secant_modulus / (2 - law.failure_ratio);
}

Real apex(const HardeningSoil& law)
{
  return law.cohesion / std::tan(law.friction_angle);
}

/// The law whose strength is that over F.
HardeningSoil reduced(HardeningSoil law)
{
  if (law.safety_factor == 1) return law;
  law.cohesion /= law.safety_factor;
  law.friction_angle = std::atan(std::tan(law.friction_angle) / law.safety_factor);
  law.dilation_angle = std::min(law.dilation_angle, law.friction_angle);
  return law;
}

/// What does not depend on alpha and H.
PreparedHardeningSoil prepare_shear(const HardeningSoil& law)
{
  const Real sine = std::sin(law.friction_angle), dilation = std::sin(law.dilation_angle);
  const Elasticity at_reference = elasticity(law.unloading_modulus, law.poisson_ratio);
  PreparedHardeningSoil p;
  p.bulk = at_reference.bulk;
  p.shear_over_bulk = at_reference.shear / at_reference.bulk;
  p.exponent = law.stiffness_exponent;
  p.apex = apex(law);
  p.least = law.min_pressure;
  p.per_reference = 1 / (law.reference_pressure + p.apex);
  p.largest_factor = std::pow((law.max_pressure + p.apex) * p.per_reference, p.exponent);
  // Half of that of triaxial extension at failure, which is the smallest.
  p.least_part = 1.5 * (1 - sine) / (3 + sine);
  p.sine = sine;
  p.k = sine / (1 - sine);
  p.sine_cv = (sine - dilation) / (1 - sine * dilation);
  p.failure_ratio = law.failure_ratio;
  p.softness = initial_modulus(law) / law.unloading_modulus;
  p.per_strain = initial_modulus(law) * p.per_reference / (4 * p.k);
  if (law.small_strain_shear_modulus && law.shear_strain_at_70_percent) {
    p.small_strain = {*law.small_strain_shear_modulus / at_reference.shear, 0.385 / *law.shear_strain_at_70_percent};
    p.small_strain_exponent = 1 + law.unloading_modulus / (2 * law.secant_modulus);
  }
  p.elastic = scaled(at_reference, p.largest_factor * p.small_strain.ratio);
  return p;
}

Real sine_of_dilation(const PreparedHardeningSoil& law, Real mobilised)
{
  return std::max((mobilised - law.sine_cv) / (1 - mobilised * law.sine_cv), Real(0));
}

StressPoint stress_point(const PreparedHardeningSoil& law, SymTensor<3> stress)
{
  const Real mean = trace(stress) / 3, pressure = std::max(law.apex - mean, law.least);
  for (int k = 0; k < 3; ++k) stress[k] -= mean;
  const Real q = std::sqrt(1.5 * double_dot(stress, stress));
  const DeviatorShape<Real> shape = deviator_shape(stress, q);
  const Real smallest = std::max(pressure - shape.smallest * q, law.least_part * pressure);
  const bool fails = q >= pressure * stress_ratio(law.sine, shape.lode);
  const Real sine = fails ? law.sine : mobilised_sine(q / pressure, shape.lode).value;
  const Real y = std::min(sine / (1 - sine) / law.k, Real(1));
  const Real hyperbola = y / (1 - law.failure_ratio * y) - law.softness * y;
  return {pressure, q, hyperbola / (law.per_strain * std::pow(smallest * law.per_reference, law.exponent - 1))};
}

/// Virgin compression at the vertical stress reference_pressure, a step of it per Pa of vertical stress: with P / (P + dP) the stress keeps its direction from
/// the apex. The strains of elasticity and shear hardening are known, the cap makes what the oedometer modulus leaves.
struct VirginCompression {
  Real axial, across;          ///< elastic strains
  Real volumetric, shear;      ///< plastic strains of shear hardening
  Real vertical, pressure, q;  ///< from the apex, Pa
  Real step, ratio;            ///< dP / P, and s3 / s1

  /// The largest oedometer modulus for which the cap has work to do, Pa.
  Real largest_modulus() const { return 1 / std::max(axial + 2 * across + volumetric, axial - across + 1.5 * shear); }
  /// The strains of the cap.
  Real cap_volumetric(Real modulus) const { return 1 / modulus - axial - 2 * across - volumetric; }
  Real cap_shear(Real modulus) const { return 2. / 3 * (1 / modulus - axial + across) - shear; }
};

VirginCompression virgin_compression(const HardeningSoil& law, const PreparedHardeningSoil& prepared)
{
  const Real vertical = law.reference_pressure, horizontal = virgin_k0(law) * vertical, s1 = vertical + prepared.apex,
             s3 = horizontal + prepared.apex;
  const Real modulus = law.unloading_modulus * std::pow(s3 * prepared.per_reference, prepared.exponent), nu = law.poisson_ratio,
             ratio = s3 / s1;
  const StressPoint point = stress_point(prepared, {{-horizontal, -vertical, -horizontal}});
  const Real strain = (1 - prepared.exponent) * point.strain / s1, dilation = sine_of_dilation(prepared, (s1 - s3) / (s1 + s3));
  return {(1 - 2 * nu * ratio) / modulus,
          (ratio - nu * (1 + ratio)) / modulus,
          -dilation * strain,
          (3 - dilation) / 6 * strain,
          s1,
          point.pressure,
          point.q,
          1 / s1,
          ratio};
}

}  // namespace

void describe(Describe& d, HardeningSoil& law)
{
  // 60 degrees, and a little for rounding.
  constexpr Real steepest = 1.0472;
  describe_density(d, law);
  d.value("cohesion", law.cohesion, {.meaning = "effective cohesion c'", .unit = "Pa", .range = not_negative});
  d.value("friction_angle", law.friction_angle,
          {.meaning = "effective angle of friction phi' at failure, in triaxial compression and extension",
           .unit = "rad",
           .range = {1e-3, steepest},
           .required = true});
  d.value("dilation_angle", law.dilation_angle,
          {.meaning = "angle of dilation psi at failure, not larger than friction_angle; below failure it follows from Rowe's stress "
                      "dilatancy, and soil does not contract in shear",
           .unit = "rad",
           .range = {0, steepest}});
  d.value("secant_modulus", law.secant_modulus,
          {.meaning = "E50_ref: secant modulus at half the strength in drained triaxial compression, at a cell pressure of "
                      "reference_pressure, by shear "
                      "hardening alone: in normally consolidated soil the cap adds strain, a tenth in sand and up to a half in clay",
           .unit = "Pa",
           .range = positive,
           .required = true});
  d.value("oedometer_modulus", law.oedometer_modulus,
          {.meaning = "Eoed_ref: tangent modulus of virgin one-dimensional compression at a vertical stress of reference_pressure",
           .unit = "Pa",
           .range = positive,
           .required = true});
  d.value("unloading_modulus", law.unloading_modulus,
          {.meaning = "Eur_ref: Young's modulus of unloading and reloading where the smallest principal stress is reference_pressure",
           .unit = "Pa",
           .range = positive,
           .required = true});
  d.value("stiffness_exponent", law.stiffness_exponent,
          {.meaning = "m: all moduli are in proportion to ((sigma_3' + c cot phi) / (reference_pressure + c cot phi))^m; 0.4 to 0.7 in "
                      "sand, up to 1 in "
                      "soft clay",
           .range = {0, 1},
           .required = true});
  d.value("reference_pressure", law.reference_pressure, {.meaning = "p_ref, to which the moduli refer", .unit = "Pa", .range = positive});
  d.value("failure_ratio", law.failure_ratio,
          {.meaning = "R_f: strength divided by the asymptote of the hyperbola of stress and strain", .range = {0.1, 0.99}});
  d.value("virgin_k0", law.virgin_k0,
          {.meaning = "K0_nc: ratio of horizontal to vertical effective stress in virgin one-dimensional compression; left out: 1 - "
                      "sin(friction_angle)",
           .range = {0.05, 0.9}});
  d.value(
      "overconsolidation_ratio", law.overconsolidation_ratio,
      {.meaning = "largest past vertical effective stress divided by that at the start; 1: the surfaces pass through the initial stress",
       .range = {1, infinity}});
  d.value("small_strain_shear_modulus", law.small_strain_shear_modulus,
          {.meaning =
               "G0_ref: shear modulus at very small strains where the smallest principal stress is reference_pressure; left out: that of "
               "unloading_modulus",
           .unit = "Pa",
           .range = positive});
  d.value("shear_strain_at_70_percent", law.shear_strain_at_70_percent,
          {.meaning = "gamma_07: shear strain at which the secant shear modulus of soil that does not yield has fallen to 72.2 % of "
                      "small_strain_shear_modulus; "
                      "1e-4 to 2e-4 in sand",
           .range = {1e-6, 0.1}});
  describe_pressure_elasticity(d, law);
  declare_usual(d, {{"friction_angle", {15 * degree, 50 * degree}},
                    {"secant_modulus", {5e5, 2e8}},
                    {"oedometer_modulus", {5e5, 2e8}},
                    {"unloading_modulus", {1e6, 1e9}},
                    {"overconsolidation_ratio", {1, 100}}});
}

void check(Describe& d, const std::string& path, const HardeningSoil& law)
{
  d.check(law.dilation_angle <= law.friction_angle, path + ".dilation_angle",
          "the dilation angle cannot be larger than the friction angle");
  const bool unloads = initial_modulus(law) < law.unloading_modulus;
  d.check(unloads, path + ".unloading_modulus",
          fmt::format("must be larger than 2 secant_modulus / (2 - failure_ratio) = {:.4g} Pa, the stiffness at the start of loading",
                      initial_modulus(law)));
  const PreparedHardeningSoil prepared = prepare_shear(law);
  const Real s1 = law.reference_pressure + prepared.apex, s3 = virgin_k0(law) * law.reference_pressure + prepared.apex;
  const bool stands = s1 - s3 < prepared.sine * (s1 + s3);
  d.check(stands, path + ".virgin_k0", "is below that of failure, (1 - sin phi) / (1 + sin phi)");
  if (unloads && stands) {
    const Real most = largest_oedometer_modulus(law);
    d.check(most > 0 && law.oedometer_modulus < most, path + ".oedometer_modulus",
            fmt::format("must be less than {:.4g} Pa: with virgin_k0 and the other moduli no cap makes soil so stiff", most));
  }
  d.check(law.small_strain_shear_modulus.has_value() == law.shear_strain_at_70_percent.has_value(), path + ".shear_strain_at_70_percent",
          "and small_strain_shear_modulus belong together: give both or none");
  const Real unloading = elasticity(law.unloading_modulus, law.poisson_ratio).shear;
  d.check(!law.small_strain_shear_modulus || *law.small_strain_shear_modulus > unloading, path + ".small_strain_shear_modulus",
          fmt::format("must be larger than the shear modulus from unloading_modulus, {:.4g} Pa", unloading));
  check_pressures(d, path, law);
}

Elasticity elasticity(const HardeningSoil& law)
{
  return prepare_shear(law).elastic;
}

YoungPoisson young_poisson(const HardeningSoil& law)
{
  return {young_modulus(elasticity(law)), law.poisson_ratio};
}

std::vector<FieldInfo> state_fields(const HardeningSoil& law)
{
  std::vector<FieldInfo> fields = {{"plastic_shear_strain", "plastic shear strain gamma_p", ""},
                                   {"preconsolidation_pressure", "preconsolidation pressure p_c + c cot phi", "Pa"}};
  if (!law.small_strain_shear_modulus) return fields;
  constexpr unsigned travel = everywhere & ~to_frame;
  for (const char* of : {"xx", "yy", "zz", "xy", "yz", "zx"})
    fields.push_back(
        {std::string("strain_since_reversal_") + of, std::string("deviatoric strain since the last reversal, ") + of, "", 1, travel});
  fields.push_back({"largest_branch_strain", "largest shear strain since the last reversal", "", 1, travel});
  fields.push_back({"branch_retreat", "shear strain reversed since then", "", 1, travel});
  fields.push_back({"first_loading_strain", "largest shear strain of first loading", ""});
  fields.push_back({"branch_start", "shear strain between the end of first loading and the last reversal", "", 1, travel});
  return fields;
}

Real virgin_k0(const HardeningSoil& law)
{
  return law.virgin_k0.value_or(1 - std::sin(law.friction_angle));
}

Real largest_oedometer_modulus(const HardeningSoil& law)
{
  return virgin_compression(law, prepare_shear(law)).largest_modulus();
}

HardeningSoil without_dilation(HardeningSoil law)
{
  law.at_max_volume = true;
  return law;
}

void initial_state(const HardeningSoil& law, const SymTensor<3>& stress, Real* state)
{
  const PreparedHardeningSoil prepared = prepare(law);
  const auto radius = [&](const StressPoint& s) { return std::hypot(s.pressure, s.q * std::sqrt(prepared.per_alpha_square)); };
  const StressPoint now = stress_point(prepared, stress);
  state[0] = now.strain;
  state[1] = radius(now);
  if (law.overconsolidation_ratio > 1) {
    const Real vertical = law.overconsolidation_ratio * std::max(Real(0), -stress[1]), horizontal = virgin_k0(law) * vertical;
    const StressPoint past = stress_point(prepared, {{-horizontal, -vertical, -horizontal}});
    state[0] = std::max(state[0], past.strain);
    state[1] = std::max(state[1], radius(past));
  }
}

std::optional<HardeningSoil> with_strength_over(HardeningSoil law, Real factor)
{
  law.safety_factor *= factor;
  return law;
}

std::optional<Strength> strength_at_rest(const HardeningSoil& law)
{
  const HardeningSoil weaker = reduced(law);
  return Strength{weaker.cohesion, 0, weaker.friction_angle, weaker.dilation_angle};
}

PreparedHardeningSoil prepare(const HardeningSoil& law)
{
  PreparedHardeningSoil p = prepare_shear(reduced(law));
  const VirginCompression virgin = virgin_compression(law, prepare_shear(law));
  const Real volumetric = virgin.cap_volumetric(law.oedometer_modulus), shear = virgin.cap_shear(law.oedometer_modulus);
  // The flow of the cap, q / (alpha^2 P).
  p.per_alpha_square = shear / volumetric * virgin.pressure / virgin.q;
  const Real cap = std::hypot(virgin.pressure, virgin.q * std::sqrt(p.per_alpha_square));
  p.cap_modulus = cap * virgin.step / (volumetric * std::pow(cap * p.per_reference, p.exponent));
  if (law.at_max_volume) p.sine_cv = p.sine;
  return p;
}

}  // namespace berm::material
