// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/pipe/published_test.cpp
#include "structures/pipe/pipe_soil.hpp"

#include "structures/base/driven_body.hpp"

#include <algorithm>

namespace berm::pipe {

formulas::PipeInClay ClayAround::at(Real embedment) const
{
  const auto strength_at = [&](Real depth) { return strength_at_rest(soil.at("", above + depth))->cohesion; };
  const Real strength = strength_at(embedment);
  Real strength_gradient = 0;
  for (const Real part : {0.25, 0.5, 0.75, 1.})
    if (const Real below = strength_at(embedment + part * diameter); below != strength)
      strength_gradient = (below - strength) / (part * diameter);
  const Real roughness = adhesion_factor > 0 ? adhesion_factor : std::isnan(adhesion) ? adhesion : std::min(Real(1), adhesion / strength);
  return {diameter, embedment, strength, roughness, strength_gradient, unit_weight};
}

PipeSoil pipe_soil(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const std::optional<bodies::DiskOutline> circle = base::circle_of(c);
  if (!circle) return NoFormula{"The published formulas are for pipes; the rigid body of this run is not a circle."};
  if (c.geometry != settings::Geometry::plane_strain)
    return NoFormula{fmt::format("The published formulas are per metre of pipe in plane strain; this run is {}.",
                                 c.geometry == settings::Geometry::space ? "three-dimensional" : "axisymmetric")};
  if (std::isnan(base::modelled_part(c)))
    return NoFormula{"The published formulas are for a whole pipe; a wall of the mesh cuts the pipe of this run."};
  const std::optional<settings::BodySoil> touched = base::touched_soil(run);
  const Real depth = base::soil_depth(c, run.ground, base::reference_depth(c, run.ground));
  const std::optional<material::Strength> law = touched ? strength_at_rest(touched->at("", depth)) : std::nullopt;
  if (!law) return NoFormula{"No formula is known for this soil: its strength is not given by cohesion and friction."};
  const contact::ContactSettings& contact = *base::contact_of_body(c);
  const bool sticks = rules_of(contact.scheme).tied;
  const Real unit_weight = base::body_scale(run).unit_weight;
  const settings::BodySoil& soil = *touched;
  const bool cohesive = law->cohesion > 0 || std::any_of(soil.materials.begin(), soil.materials.end(), [](const material::Material& one) {
                          const std::optional<material::Strength> strength = strength_at_rest(one);
                          return strength && (strength->cohesion > 0 || strength->cohesion_gradient > 0);
                        });
  if (soil.materials.size() > 1)
    for (const material::Material& one : soil.materials)
      if (law->friction_angle > 0 || strength_at_rest(one)->friction_angle > 0)
        return NoFormula{"The published formulas are for clay or for one sand; this soil has other layers."};
  const Real diameter = 2 * circle->radius;
  // The largest within a diameter below.
  Real cohesion = law->cohesion;
  for (const Real part : {0.5, 1.})
    if (const std::optional<material::Strength> below = strength_at_rest(soil.at("", depth + part * diameter)))
      cohesion = std::max(cohesion, below->cohesion);
  if (law->friction_angle > 0 && cohesion <= SandAround::max_cohesion * unit_weight * diameter && unit_weight > 0)
    return SandAround{
        diameter, unit_weight, law->friction_angle, law->dilation_angle, sticks ? law->friction_angle : contact.friction_angle, cohesion};
  if (law->friction_angle == 0 && cohesive) {
    const bool slips = !sticks && contact.friction_angle == 0;
    const Real adhesion = sticks ? infinity : slips ? contact.adhesion : nan;
    return ClayAround{diameter,
                      unit_weight,
                      soil,
                      adhesion,
                      base::soil_depth(c, run.ground, 0),
                      slips ? contact.adhesion_factor : 0,
                      sticks || contact.tension > 0};
  }
  return NoFormula{"No formula is known for this soil: it is neither clay (φ = 0) nor sand (c under 0.1 γ' D) with weight."};
}

}  // namespace berm::pipe
