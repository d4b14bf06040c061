// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_published.hpp"

#include "formulas/design_code.hpp"
#include "structures/pipe/pipe_case.hpp"

#include <fmt/format.h>

namespace berm::envelope {
namespace {

constexpr int curve_points = 100;

/// The soil that touches the pipe.
struct PipeInSoil {
  EmbeddedPipe pipe;
  std::optional<material::Strength> strength;  ///< empty: none of cohesion and friction
  const contact::ContactSettings* contact = nullptr;
  Real unit_weight = 0;  ///< N/m3
};

PipeInSoil pipe_in_soil(const problem::Case& c)
{
  const material::Material* material = pipe::touched_material(c);
  return {embedded_pipe(c), material == nullptr ? std::nullopt : strength_at_rest(*material), pipe::contact_of_pipe(c),
          pipe::pipe_scale(c).unit_weight};
}

std::string titled(const std::string& title, const formulas::Formula& formula)
{
  const std::string where = formula.valid ? "" : fmt::format("; out of range: {}", formula.source.range);
  return fmt::format("{} [{}{}]", title, word_of(formula.source.label), where);
}

/// The shear strength of the interface over that of the clay; NaN where it is a friction.
Real roughness_of(const PipeInSoil& soil)
{
  if (soil.contact->scheme == contact::Scheme::tied) return 1;
  if (soil.contact->friction_angle > 0) return std::numeric_limits<Real>::quiet_NaN();
  return std::min(Real(1), soil.contact->adhesion / soil.strength->cohesion);
}

Published for_clay(const PipeInSoil& soil)
{
  Published published;
  const formulas::PipeInClay pipe{soil.pipe.diameter, soil.pipe.embedment, soil.strength->cohesion, roughness_of(soil), 0,
                                  soil.unit_weight};
  published.unit = pipe.diameter * pipe.strength;
  published.unit_name = "(D s_u)";
  if (std::isnan(pipe.roughness)) {
    published.remark = "the formulas for clay know adhesion to the pipe, not friction: there is no curve to compare with";
    return published;
  }
  const Real buoyancy = soil.unit_weight > 0 ? soil.unit_weight * formulas::f114_penetrated_area(pipe.diameter, pipe.embedment) : 0;
  const auto with_buoyancy = [&](formulas::Formula formula) { return formula.value += buoyancy, formula; };
  const formulas::Formula V_max = clay_vertical(pipe), H_max = clay_horizontal(pipe), smooth = clay_vertical_smooth(pipe);
  published.numbers = {{"V_max", with_buoyancy(V_max)}, {"H_max", H_max}};
  const formulas::Formula any = clay_envelope(pipe, V_max.value / 2, V_max.value, H_max.value);
  PublishedCurve curve{titled(any.source.work, any), {}, {}};
  for (int k = 0; k <= curve_points; ++k) {
    const Real V = V_max.value * k / curve_points;
    curve.V.push_back(V + buoyancy);
    curve.H.push_back(clay_envelope(pipe, V, V_max.value, H_max.value).value);
  }
  published.curves.push_back(curve);
  if (smooth.valid) {
    published.numbers.push_back({"V_max_slip_lines", with_buoyancy(smooth)});
    published.curves.push_back({titled("Vmax, slip lines", smooth), {smooth.value + buoyancy}, {0}});
  }
  const bool ends = pipe.roughness == 0 || pipe.roughness == 1;
  if (ends && formulas::within(pipe.embedment / pipe.diameter, 0.5, 0.5)) {
    const formulas::MurffBounds& bounds = pipe.roughness == 0 ? formulas::murff_smooth : formulas::murff_rough;
    published.curves.push_back({fmt::format("Vmax, {} [{}]", formulas::murff_source.work, formulas::word_of(formulas::murff_source.label)),
                                {bounds.lower * published.unit + buoyancy, bounds.upper * published.unit + buoyancy},
                                {0, 0}});
  }
  return published;
}

Published for_sand(const PipeInSoil& soil, const std::vector<EnvelopeRow>& rows)
{
  Published published;
  const formulas::PipeInSand pipe{soil.pipe.diameter, soil.pipe.embedment, soil.unit_weight, soil.strength->friction_angle,
                                  soil.contact->friction_angle};
  published.unit = pipe.unit_weight * pipe.diameter * pipe.diameter;
  published.unit_name = "(γ' D²)";
  formulas::Formula V_max = sand_vertical(pipe);
  if (soil.strength->dilation_angle != soil.strength->friction_angle) {
    V_max.valid = false;
    V_max.source.range = "dilation angle = phi";
  }
  if (std::isfinite(V_max.value)) {
    published.numbers.push_back({"V_max", V_max});
    published.curves.push_back({titled("Vmax, characteristics", V_max), {V_max.value}, {0}});
  }
  const EnvelopeExtremes extremes = extremes_of(rows);
  std::vector<Real> V, H;
  for (const EnvelopeRow& row : rows)
    if (const EnvelopePoint& end = row.result.end; end.V >= 0 && end.V < extremes.V_max && end.H > 0)
      V.push_back(end.V), H.push_back(end.H);
  const formulas::YieldSurface surface = formulas::fit_zhang(V, H, extremes.V_max);
  if (!std::isfinite(surface.mu) || !std::isfinite(surface.beta)) return published;
  const formulas::Formula any = zhang_envelope(surface, 0, extremes.V_max);
  published.numbers.push_back({"zhang_mu", formula(surface.mu, any.source, any.valid)});
  published.numbers.push_back({"zhang_beta", formula(surface.beta, any.source, any.valid)});
  PublishedCurve curve{titled(fmt::format("Zhang's surface fitted, mu = {:.3f}, beta = {:.3f}", surface.mu, surface.beta), any), {}, {}};
  for (int k = 0; k <= curve_points; ++k) {
    const Real at = extremes.V_max * k / curve_points;
    curve.V.push_back(at);
    curve.H.push_back(zhang_envelope(surface, at, extremes.V_max).value);
  }
  published.curves.push_back(curve);
  return published;
}

}  // namespace

Published published_for(const problem::Case& c, const std::vector<EnvelopeRow>& rows)
{
  const PipeInSoil soil = pipe_in_soil(c);
  if (soil.strength && soil.strength->friction_angle == 0 && soil.strength->cohesion > 0) return for_clay(soil);
  if (soil.strength && soil.strength->friction_angle > 0 && soil.strength->cohesion == 0 && soil.unit_weight > 0)
    return for_sand(soil, rows);
  Published published;
  published.remark = "no formula is known for this soil: neither clay (phi = 0) nor sand (c = 0)";
  return published;
}

}  // namespace berm::envelope
