// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/lateral/codes_test.cpp
#include "structures/lateral/axial_codes.hpp"

#include "formulas/pile_axial.hpp"
#include "structures/penetration/soil_profile.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::lateral {
namespace {

constexpr int usual_slices = 8;  // of a pile without depth slices

text::HtmlCell number(Real value)
{
  return {text::table_number(value), true};
}

}  // namespace

Real AxialCode::shaft_force() const
{
  Real sum = 0;
  for (const Slice& slice : shaft) sum += slice.t.value * slice.thickness;
  return sum;
}

Real AxialCode::friction_share(Real displacement) const
{
  return clay ? formulas::api_clay_friction_share(displacement, diameter) : formulas::api_sand_friction_share(displacement);
}

Real AxialCode::base_share(Real displacement) const
{
  return formulas::api_base_share(displacement, diameter);
}

std::optional<AxialCode> axial_code(const LateralRun& run)
{
  const settings::Case& c = run.record.settings;
  const contact::ContactSettings* contact = base::contact_of_body(c);
  if (run.empty() || contact == nullptr) return {};
  const auto& rigid = c.rigid[main_rigid(c)].second;
  const std::optional<base::BodyProfile> body = base::body_profile(rigid.shape);
  const penetration::SoilProfile soil(run.record);
  AxialCode code;
  code.clay = run.strength > 0, code.diameter = run.width, code.closed = !body || !(body->bore > 0);
  if (!code.clay && !(soil.at(run.path.length / 2).friction_angle > 0 && contact->friction_angle > 0)) return {};
  const int slices = rigid.depth_slices > 0 ? rigid.depth_slices : usual_slices;
  const Real thickness = run.path.length / slices, around = pi * run.width;
  for (int k = 0; k < slices; ++k) {
    const Real z = (k + 0.5) * thickness;
    const penetration::SoilAt at = soil.at(z);
    formulas::Formula t = code.clay ? formulas::api_clay_friction(at.strength, at.overburden)
                                    : formulas::api_sand_friction(at.overburden, contact->friction_angle, code.closed);
    t.value *= around;
    code.shaft.push_back({z, thickness, t});
  }
  const penetration::SoilAt below = soil.at(run.path.length);
  code.base = code.clay ? formulas::api_clay_base(below.strength) : formulas::api_sand_base(below.overburden, contact->friction_angle);
  code.base.value *= pi * run.width * run.width / 4;
  return code;
}

std::string axial_table(const LateralRun& run, const std::string& id)
{
  const std::optional<AxialCode> code = axial_code(run);
  if (!code) return "";
  const formulas::Source& source = code->base.source;
  text::HtmlTable table(id, fmt::format("{}: axial resistance by {} ({})", run.record.name, citation(source), word_of(source.label)));
  table.columns({{"depth below the seabed, m"}, {"t, kN/m", true}, {"up to that depth, kN", true}});
  Real sum = 0;
  for (const AxialCode::Slice& slice : code->shaft) {
    sum += slice.t.value * slice.thickness;
    table.row({{text::table_number(slice.z)}, number(slice.t.value / 1e3), number(sum / 1e3)}, slice.t.valid ? "" : "out_of_range");
  }
  if (code->closed) table.row({{"base, Q in kN"}, number(code->base.value / 1e3), number((sum + code->base.value) / 1e3)});
  const std::string mobilised =
      code->clay ? fmt::format("t at {}, 0.9 of it from twice that on", text::length_words(0.01 * run.width)) : "t at 2.54 mm";
  return table.html() +
         text::html_paragraph(fmt::format("Mobilised along the axis: {}; Q at {}{}. berm export --to py has the curves.", mobilised,
                                          text::length_words(0.1 * run.width), code->closed ? "" : " (none of an open end here)"),
                              "quiet");
}

}  // namespace berm::lateral
