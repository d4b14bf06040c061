// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "structures/pipe/published.hpp"

#include "formulas/f114.hpp"
#include "formulas/pipe_in_clay.hpp"
#include "formulas/pipe_in_sand.hpp"
#include "mesh/seabed.hpp"
#include "os/error.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/little_cohesion.hpp"
#include "structures/pipe/pipe_soil.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::pipe {
namespace {

using base::PublishedCurve;
using base::PublishedEnvelope;

constexpr int curve_points = 100;

/// The soil that touches the pipe.
struct PipeInSoil {
  base::EmbeddedBody pipe;
  std::optional<material::Strength> strength;  ///< empty: none of cohesion and friction
  const contact::ContactSettings* contact = nullptr;
  Real unit_weight = 0;  ///< N/m3
  std::optional<settings::BodySoil> soil;
  Real above = 0;     ///< m, depth in the soil from which embedment counts
  bool level = true;  ///< the ground

  /// A formula as it holds here: all are those of a level bed.
  formulas::Formula on_this_ground(formulas::Formula formula) const
  {
    if (level) return formula;
    formula.valid = false;
    formula.source.range = "a level bed";
    return formula;
  }
};

PipeInSoil pipe_in_soil(const settings::Case& c)
{
  const std::optional<material::Material> material = base::touched_material(c);
  const problem::Ground ground = problem::ground_of(c);
  return {embedded_pipe(c),         material ? strength_at_rest(*material) : std::nullopt,
          base::contact_of_body(c), base::body_scale(c).unit_weight,
          base::touched_soil(c),    base::soil_depth(c, ground, 0),
          ground.line.level()};
}

PublishedEnvelope for_clay(const PipeInSoil& soil)
{
  PublishedEnvelope published;
  const formulas::PipeInClay around = ClayAround{soil.pipe.width, soil.unit_weight, *soil.soil, 0, soil.above}.at(soil.pipe.embedment);
  const formulas::PipeInClay pipe{soil.pipe.width,          soil.pipe.embedment,
                                  around.strength,          base::interface_ratio(*soil.contact, soil.strength->cohesion),
                                  around.strength_gradient, soil.unit_weight};
  published.unit = pipe.diameter * pipe.strength;
  published.unit_name = "(D sᵤ)";
  if (std::isnan(pipe.roughness)) {
    published.remark = "the formulas for clay have adhesion to the pipe, not friction: there is no curve to compare with";
    return published;
  }
  const Real buoyancy = soil.unit_weight > 0 ? soil.unit_weight * formulas::f114_penetrated_area(pipe.diameter, pipe.embedment) : 0;
  const auto with_buoyancy = [&](formulas::Formula formula) { return formula.value += buoyancy, formula; };
  const formulas::Formula V_max = soil.on_this_ground(clay_vertical(pipe)), H_max = soil.on_this_ground(clay_horizontal(pipe)),
                          smooth = soil.on_this_ground(clay_vertical_smooth(pipe));
  published.numbers = {{"V_max", with_buoyancy(V_max)}, {"H_max", H_max}};
  const formulas::Formula any = soil.on_this_ground(clay_envelope(pipe, V_max.value / 2, V_max.value, H_max.value));
  PublishedCurve curve{base::titled(any.source.work, any), {}, {}};
  for (int k = 0; k <= curve_points; ++k) {
    const Real V = V_max.value * k / curve_points;
    curve.V.push_back(V + buoyancy);
    curve.H.push_back(clay_envelope(pipe, V, V_max.value, H_max.value).value);
  }
  published.curves.push_back(curve);
  if (smooth.valid) {
    published.numbers.push_back({"V_max_slip_lines", with_buoyancy(smooth)});
    published.curves.push_back({base::titled("Vmax, slip lines", smooth), {smooth.value + buoyancy}, {0}});
  }
  return published;
}

PublishedEnvelope for_sand(const PipeInSoil& soil, const base::EnvelopeEnds& ends)
{
  PublishedEnvelope published;
  const formulas::PipeInSand pipe{soil.pipe.width, soil.pipe.embedment, soil.unit_weight, soil.strength->friction_angle,
                                  soil.contact->friction_angle};
  published.unit = pipe.unit_weight * pipe.diameter * pipe.diameter;
  published.unit_name = "(γ' D²)";
  formulas::Formula V_max = sand_vertical(pipe);
  if (soil.strength->dilation_angle != soil.strength->friction_angle) {
    V_max.valid = false;
    V_max.source.range = "dilation angle = phi";
  }
  V_max = soil.on_this_ground(V_max);
  if (std::isfinite(V_max.value)) {
    published.numbers.push_back({"V_max", V_max});
    published.curves.push_back({base::titled("Vmax, characteristics", V_max), {V_max.value}, {0}});
  }
  std::vector<Real> V, H;
  for (std::size_t k = 0; k < ends.V.size(); ++k)
    if (ends.V[k] >= 0 && ends.V[k] < ends.V_max && ends.H[k] > 0) V.push_back(ends.V[k]), H.push_back(ends.H[k]);
  const formulas::YieldSurface surface = formulas::fit_zhang(V, H, ends.V_max);
  if (!std::isfinite(surface.mu) || !std::isfinite(surface.beta)) return published;
  // Two parameters through the run's own points: whoever first wrote the parabola, nothing is quoted here.
  constexpr formulas::Source fitted{formulas::Label::fit, "parabola through the ends of the probes, by least squares", "0 <= V <= V_max"};
  const formulas::Formula any = soil.on_this_ground(formulas::formula(surface.mu, fitted, true));
  published.numbers.push_back({"parabola_mu", formula(surface.mu, any.source, any.valid)});
  published.numbers.push_back({"parabola_beta", formula(surface.beta, any.source, any.valid)});
  PublishedCurve curve{
      base::titled(fmt::format("H = mu (V/Vmax + beta)(Vmax - V) fitted, mu = {:.3f}, beta = {:.3f}", surface.mu, surface.beta), any),
      {},
      {}};
  for (int k = 0; k <= curve_points; ++k) {
    const Real at = ends.V_max * k / curve_points;
    curve.V.push_back(at);
    curve.H.push_back(zhang_envelope(surface, at, ends.V_max).value);
  }
  published.curves.push_back(curve);
  return published;
}

/// Says that the ground is not level, where nothing else is to be said.
PublishedEnvelope with_ground(const PipeInSoil& soil, PublishedEnvelope published)
{
  if (!soil.level && published.remark.empty())
    published.remark = "the formulas are for a level bed, and the ground of this case is not: they show the order of magnitude only";
  return published;
}

}  // namespace

base::EmbeddedBody embedded_pipe(const settings::Case& c)
{
  if (c.geometry != settings::Geometry::plane_strain)
    throw KeyError("geometry: the envelope of a pipe is that in plane strain; it needs geometry = \"plane_strain\"");
  const auto drive = std::find_if(c.stage.begin(), c.stage.end(), [](const settings::StageSettings& stage) {
    return stage.kind == settings::StageKind::push || stage.kind == settings::StageKind::drag;
  });
  const Index main = drive != c.stage.end() && !drive->rigid.empty() ? index_of(c.rigid, drive->rigid) : c.rigid.empty() ? none : 0;
  if (main == none) throw KeyError("rigid: an envelope needs a pipe: a rigid body with shape = \"circle\"");
  const auto& [name, rigid] = c.rigid[main];
  const std::optional<bodies::DiskOutline> circle = bodies::pipe_section(rigid.shape);
  if (!circle)
    throw KeyError(
        fmt::format("rigid.{}.shape: an envelope is that of a pipe, \"circle\", or of a footing, which a push drives first", name));
  const base::EmbeddedBody pipe{2 * circle->radius,
                                problem::ground_of(c).level_at(circle->center[0], c.surface) - (circle->center[1] - circle->radius)};
  if (!(pipe.embedment > 0))
    throw KeyError(
        fmt::format("rigid.{}.center: the lowest point of the pipe lies {:g} m above the bed; an envelope needs a pipe that lies in it",
                    name, -pipe.embedment));
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const mesh::SeabedLayout layout = layout_of(*seabed);
    if (circle->center[0] - pipe.width / 2 < layout.left || circle->center[0] + pipe.width / 2 > layout.right)
      throw KeyError(fmt::format("rigid.{}.center: the pipe reaches beyond a wall of the mesh; an envelope needs the whole pipe", name));
  }
  return pipe;
}

PublishedEnvelope pipe_envelope(const settings::Case& c, const base::EnvelopeEnds& ends)
{
  const PipeInSoil soil = pipe_in_soil(c);
  if (soil.strength && soil.strength->friction_angle == 0 && soil.strength->cohesion > 0) return with_ground(soil, for_clay(soil));
  if (soil.strength && soil.strength->friction_angle > 0 && soil.unit_weight > 0 &&
      base::has_little_cohesion(soil.strength->cohesion, soil.strength->friction_angle, soil.unit_weight, soil.pipe.width))
    return with_ground(soil, for_sand(soil, ends));
  PublishedEnvelope published;
  published.remark = "no formula is known for this soil: neither clay (phi = 0) nor sand (c cot phi up to 5 % of gamma' D)";
  return published;
}

}  // namespace berm::pipe
