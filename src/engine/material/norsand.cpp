// SPDX-License-Identifier: BSD-3-Clause
#include "material/norsand.hpp"

#include "core/usual.hpp"
#include "material/describe_elasticity.hpp"
#include "material/modified_cam_clay.hpp"

namespace berm::material {

namespace {

constexpr Real kilopascal = 1e3;

bool is_undrained(const NorSand& law)
{
  return law.water && law.water->drainage == Drainage::undrained;
}

}  // namespace

void describe(Describe& d, NorSand& law)
{
  describe_density(d, law);
  d.value("critical_friction_angle", law.critical_friction_angle,
          {.meaning = "angle of friction at the critical state in triaxial compression, M = 6 sin phi / (3 - sin phi)",
           .unit = "rad",
           .range = {1e-3, 1.2},
           .required = true});
  d.value("critical_void_ratio", law.critical_void_ratio,
          {.meaning = "Gamma, the void ratio of the critical state at p' = 1 kPa", .range = positive, .required = true});
  d.value("critical_line_slope", law.critical_line_slope,
          {.meaning = "lambda_e, the decrease of the void ratio of the critical state with log(p'), natural logarithm",
           .range = positive,
           .required = true});
  d.value("volumetric_coupling", law.volumetric_coupling,
          {.meaning = "N: how much less than M the stress ratio at the image state is, away from the critical state; 0.2 to 0.45",
           .range = {0, 0.9},
           .required = true});
  d.value("dilatancy", law.dilatancy,
          {.meaning = "chi_tc: least dilatancy divided by the state parameter, D_min = chi_tc psi, in triaxial compression; 2.5 to 4.5",
           .range = positive,
           .required = true});
  d.value("hardening_modulus", law.hardening_modulus,
          {.meaning = "plastic hardening modulus H at psi = 0; 50 to 500", .range = positive, .required = true});
  d.value("hardening_slope", law.hardening_slope, {.meaning = "decrease of H with the state parameter", .range = not_negative});
  d.value("void_ratio", law.void_ratio, {.meaning = "void ratio at the start; or state_parameter", .range = positive});
  d.value("state_parameter", law.state_parameter,
          {.meaning = "psi at the start: void ratio less that of the critical state at the same p', below 0 in dense sand",
           .range = {-0.5, 0.5}});
  d.value("overconsolidation_ratio", law.overconsolidation_ratio,
          {.meaning = "largest past p' divided by that at the start, at the same q / p'", .range = {1, infinity}});
  d.value("rigidity", law.rigidity, {.meaning = "G / p'; 200 to 1000", .range = positive, .required = true});
  describe_deviatoric_shape(d, law.deviatoric_shape);
  d.value(
      "bedding_loss", law.bedding_loss,
      {.meaning =
           "fraction of the dilatancy that is lost where sigma_1 lies along the bedding instead of perpendicular to it, as in the tests "
           "that gave dilatancy; 0.1 to 0.4 in poured sand",
       .range = {0, 0.9}});
  d.value("bedding_curvature", law.bedding_curvature,
          {.meaning = "c: with sigma_1 at an angle a to the normal of the bedding, bedding_loss t (1 + c (1 - t)) is lost, t = sin^2 a",
           .range = {-1, 3}});
  d.value("bedding_angle", law.bedding_angle,
          {.meaning = "of the bedding planes to the x axis, from x to y; fixed in space", .unit = "rad"});
  describe_bands(d, law);
  describe_pressure_elasticity(d, law);
  declare_usual(d, {{"critical_friction_angle", {10 * degree, 45 * degree}},
                    {"critical_void_ratio", {0.4, 2.5}},
                    {"critical_line_slope", {3e-3, 0.3}},
                    {"dilatancy", {1, 10}},
                    {"hardening_modulus", {10, 2000}},
                    {"void_ratio", {0.15, 3}},
                    {"overconsolidation_ratio", {1, 100}},
                    {"rigidity", {50, 5000}}});
}

void check(Describe& d, const std::string& path, const NorSand& law)
{
  d.check(law.void_ratio.has_value() != law.state_parameter.has_value(), path + ".void_ratio",
          law.void_ratio ? "cannot be combined with state_parameter: give one of them" : "is missing: give void_ratio or state_parameter");
  d.check(law.dilatancy * law.critical_line_slope < critical_slope(law.critical_friction_angle), path + ".dilatancy",
          "times critical_line_slope must be less than M: no sand dilates so much");
  check_pressures(d, path, law);
  check_bands(d, path, law);
  d.check(!given_band_width(law) || !is_undrained(law), path + (law.d50 ? ".d50" : ".band_width"),
          "is a width for sand that softens as it dilates, which undrained soil cannot");
}

Elasticity elasticity(const NorSand& law)
{
  return prepare(law).elastic;
}

YoungPoisson young_poisson(const NorSand& law)
{
  return {young_modulus(elasticity(law)), law.poisson_ratio};
}

std::string law_name(const NorSand&)
{
  return "NorSand";
}

std::vector<FieldInfo> state_fields(const NorSand&)
{
  return {{"image_pressure", "image pressure p_i", "Pa"}, {"void_ratio", "void ratio", ""}};
}

void initial_state(const NorSand& law, const SymTensor<3>& stress, Real* state)
{
  const PreparedNorSand prepared = prepare(law);
  const Invariants now = equivalent_invariants(prepared.shape, stress, law.min_pressure);
  const Real log_pressure = std::log(now.pressure);
  state[1] = law.void_ratio ? *law.void_ratio : prepared.gamma - prepared.lambda * log_pressure + law.state_parameter.value_or(0);
  // M_i depends on p_i only a little: each pass makes the error smaller by a tenth or less.
  Real log_image = log_pressure;
  for (int k = 0; k < 50; ++k)
    log_image = log_pressure + std::log(law.overconsolidation_ratio) +
                now.q / now.pressure / image_state(prepared, state[1], log_pressure, log_image).slope - 1;
  state[0] = std::max(std::exp(log_image), law.min_pressure);
}

std::optional<Real> band_width(const NorSand& law)
{
  return given_band_width(law);
}

NorSand with_grain_size(NorSand law, Real d50)
{
  return is_undrained(law) ? law : with_grains(std::move(law), d50);
}

Real most_band_strain(const NorSand& law)
{
  const Real psi = law.void_ratio ? *law.void_ratio - law.critical_void_ratio : law.state_parameter.value_or(0);
  if (psi >= 0) return infinity;
  return 1.5 * law.rigidity / (law.dilatancy * law.dilatancy * -psi * (1 + law.critical_void_ratio));
}

NorSand regularised_for(NorSand law, Real size)
{
  const std::optional<Real> width = band_width(law);
  if (!width) return law;
  law.band_strain = std::max(Real(1), std::min(strain_in_band(*width, size), most_band_strain(law)));
  law.band_width.reset();
  law.d50.reset();
  return law;
}

PreparedNorSand prepare(const NorSand& law)
{
  const Real slope = critical_slope(law.critical_friction_angle), lambda = law.critical_line_slope;
  PreparedNorSand prepared;
  prepared.moduli = {law.rigidity / shear_over_bulk(law.poisson_ratio), shear_over_bulk(law.poisson_ratio), law.min_pressure,
                     law.max_pressure};
  prepared.elastic = stiffest(prepared.moduli);
  prepared.shape = law.deviatoric_shape;
  prepared.slope = slope;
  prepared.gamma = law.critical_void_ratio + lambda * std::log(kilopascal);
  prepared.lambda = lambda;
  prepared.coupling = law.volumetric_coupling * law.dilatancy / (1 - law.dilatancy * lambda / slope);
  prepared.dilatancy = law.dilatancy;
  prepared.hardening = law.hardening_modulus;
  prepared.hardening_slope = law.hardening_slope;
  prepared.band_strain = law.band_strain;
  prepared.bedding_loss = law.bedding_loss;
  prepared.bedding_curvature = law.bedding_curvature;
  prepared.normal_xx = (1 - std::cos(2 * law.bedding_angle)) / 2;
  prepared.normal_yy = 1 - prepared.normal_xx;
  prepared.normal_xy = -std::sin(2 * law.bedding_angle);
  return prepared;
}

}  // namespace berm::material
