// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/picture/model_picture_test.cpp
#include "picture/legend.hpp"

#include "os/text_of_list.hpp"
#include "picture/stage_words.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/soil_words.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <set>

namespace berm::picture {
namespace {

constexpr Real line_height = 19, indent = 34, letters = 11;
constexpr std::size_t max_stages = 14;

/// Entries below one another: a sign, then words beside it.
class Column {
public:
  Column(Canvas& canvas, const Vec<2>& at, Real width) : canvas_(canvas), at_(at), width_(width) {}

  void heading(const std::string& words)
  {
    at_[1] += 6;
    canvas_.text(at_ + Vec<2>(0, 6), words, {.size = 12, .bold = true});
    at_[1] += line_height + 3;
  }

  /// The sign is drawn around the point that it gets.
  void entry(const std::string& words, const std::function<void(const Vec<2>&)>& sign)
  {
    sign(at_ + Vec<2>(12, 6));
    for (const std::string& line : Canvas::wrapped(words, letters, width_ - indent)) {
      canvas_.text(at_ + Vec<2>(indent, 6), line, {.size = letters});
      at_[1] += line_height;
    }
    at_[1] += 3;
  }

  void swatch(const std::string& words, const std::string& color, const LineStyle& rim)
  {
    entry(words, [&](const Vec<2>& c) {
      canvas_.polygon(box(c, 8), color);
      canvas_.outline(box(c, 8), rim);
    });
  }
  void bar(const std::string& words, const std::string& color)
  {
    entry(words, [&](const Vec<2>& c) { canvas_.polygon(box(c, 2), color); });
  }
  Real level() const { return at_[1]; }

private:
  static Points box(const Vec<2>& c, Real half)
  {
    return {Vec<2>(c + Vec<2>(-12, -half)), Vec<2>(c + Vec<2>(12, -half)), Vec<2>(c + Vec<2>(12, half)), Vec<2>(c + Vec<2>(-12, half))};
  }

  Canvas& canvas_;
  Vec<2> at_;
  Real width_;
};

/// "2 kPa + 1.5 kPa/m z".
std::string with_depth(Real at_surface, Real gradient)
{
  std::string words = text::stress_words(at_surface);
  if (gradient != 0) words += fmt::format(" + {}/m z", text::stress_words(gradient));
  return words;
}

/// Parts between ", " that lines are broken after, not within.
std::string together(const std::string& words)
{
  std::string kept;
  for (std::size_t k = 0; k < words.size(); ++k)
    kept += words[k] == ' ' && k > 0 && words[k - 1] != ',' && words[k - 1] != ':' ? std::string("\u00a0") : std::string(1, words[k]);
  return kept;
}

std::string name_of(const SoilKind& kind)
{
  return kind.material == kind.body ? kind.material : fmt::format("{} (body {})", kind.material, kind.body);
}

std::string soil_words(const settings::Case& c, const SoilKind& kind)
{
  const material::Material& material = c.material[index_of(c.material, kind.material)].second;
  std::string words = name_of(kind) + ": " + law_name(material);
  if (const std::optional<material::Strength> strength = strength_at_rest(material)) {
    const std::string c_words = with_depth(strength->cohesion, strength->cohesion_gradient);
    if (strength->friction_angle > 0)
      words += fmt::format(", φ = {}, ψ = {}, c = {}", text::angle_words(strength->friction_angle),
                           text::angle_words(strength->dilation_angle), c_words);
    else
      words += ", sᵤ = " + (shansep(material) != nullptr ? formula_words(*shansep(material)) : c_words);
  }
  const auto [E, nu] = young_poisson(material);
  words += fmt::format(", E = {}, ν = {}, ρ = {:.0f} kg/m³", text::stress_words(E), text::number_words(nu), density(material));
  const bodies::BodySettings& body = c.body[index_of(c.body, kind.body)].second;
  if (body.has_k0()) words += ", K₀ = " + base::k0_in_words(body.at_rest(), body.sin_friction);
  return together(words);
}

/// Of what is drawn.
void soils(Column& column, const Model& model, const std::function<std::string(const SoilKind&)>& words)
{
  std::set<Index> seen;
  for (const Piece& piece : model.ground.pieces) seen.insert(piece.kind);
  for (const NamedOutline& body : model.sketch.bodies) seen.insert(kind_of(model.ground, body.name));
  for (const EarthworkSketch& work : model.sketch.earthworks)
    if (!work.material.empty()) seen.insert(kind_of(model.ground, work.body, work.material));
  for (Index kind = 0; kind < static_cast<Index>(model.ground.kinds.size()); ++kind)
    if (seen.contains(kind)) column.swatch(words(model.ground.kinds[kind]), soil_color(kind), {surface_color, 1});
  for (const EarthworkSketch& work : model.sketch.earthworks) {
    const bool fills = !work.material.empty();
    column.swatch(work.words, fills ? soil_color(kind_of(model.ground, work.body, work.material)) : "none",
                  {fills ? surface_color : load_color, 1.6, dashed});
  }
}

std::string rigid_words(const std::string& name, const bodies::RigidSettings& rigid, const Outline& outline)
{
  const Extent extent = extent_of(outline);
  std::string words = name + ": ";
  if (std::holds_alternative<DiskOutline>(outline))
    words += "circle, D = " + text::length_words(extent.size()[0]);
  else if (std::holds_alternative<PlaneOutline>(outline))
    words += "half-plane";
  else
    words += fmt::format("{} × {}", text::length_words(extent.size()[0]), text::length_words(extent.size()[1]));
  if (rigid.mass > 0) words += fmt::format(", {:.4g} kg/m", rigid.mass);
  if (rigid.motion == bodies::Motion::free) words += ", free";
  if (rigid.rotation == bodies::Rotation::free) words += ", may turn";
  return words;
}

std::string contact_words(const std::string& name, const contact::ContactSettings& contact)
{
  std::string words = fmt::format("{}: {} on {}", name, contact.body, contact.rigid.empty() ? contact.other_body : contact.rigid);
  if (rules_of(contact.scheme).tied) return words + ", tied";
  words += ", δ = " + text::angle_words(contact.friction_angle);
  if (contact.adhesion > 0) words += ", adhesion " + text::stress_words(contact.adhesion);
  if (contact.adhesion_factor > 0) words += fmt::format(", α = {:.3g}", contact.adhesion_factor);
  for (const contact::SoilInterfaceSettings& soil : contact.soil) {
    words += fmt::format("; beside {} δ = {}", soil.material, text::angle_words(soil.friction_angle));
    if (soil.adhesion > 0) words += ", adhesion " + text::stress_words(soil.adhesion);
    if (soil.adhesion_factor > 0) words += fmt::format(", α = {:.3g}", soil.adhesion_factor);
  }
  if (contact.tension > 0)
    words += ", tension " + (contact.tension < infinity ? text::stress_words(contact.tension) : std::string("unlimited"));
  if (contact.drained) words += ", drained";
  return words;
}

void rigid_bodies(Column& column, const Model& model)
{
  const settings::Case& c = model.settings;
  if (!c.rigid.empty()) column.heading("Rigid bodies");
  for (std::size_t k = 0; k < c.rigid.size(); ++k)
    column.swatch(rigid_words(c.rigid[k].first, c.rigid[k].second, model.sketch.rigid_bodies[k].outline), rigid_color, {rim_color, 1});
  if (!c.contact.empty() || !c.rigid_contact.empty()) column.heading("Contact");
  for (const auto& [name, contact] : c.contact) column.bar(contact_words(name, contact), contact_color);
  for (const auto& [name, contact] : c.rigid_contact)
    column.bar(fmt::format("{}: {} on {}, δ = {}{}", name, contact.rigid, contact.other_rigid, text::angle_words(contact.friction_angle),
                           contact.restitution > 0 ? fmt::format(", restitution {:.3g}", contact.restitution) : ""),
               contact_color);
}

void mesh(Column& column, Canvas& canvas, const Model& model)
{
  column.heading("Mesh and boundaries");
  const Real size = base::near_cell_size(model.settings);
  const std::string cells = std::isnan(size) ? "" : "cells of " + text::length_words(size);
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&model.settings.mesh); bed != nullptr) {
    const Points& zone = model.sketch.fine;
    std::string words =
        fmt::format("fine zone{}, {} × {}{}", bed->slope != 0 ? " along the slope" : "", text::length_words(zone[1][0] - zone[0][0]),
                    text::length_words(zone[3][1] - zone[0][1]), cells.empty() ? "" : ", " + cells);
    if (const Real far = layout_of(*bed).far_size; std::isfinite(far))
      words += fmt::format("; up to {} far from it", text::length_words(far));
    column.swatch(words, "none", {fine_color, 1.4, dashed});
  } else if (!cells.empty()) {
    column.swatch(cells, "none", {"#b0b4ba", 0.8});
  }
  bool hatched = false, wheels = false, along = false;
  for (const HeldSides& held : model.ground.held)
    for (const Side& side : held.sides) {
      const int directions = held.directions & 3;
      const bool across = is_held_across(side.outward, directions);
      hatched |= directions == 3, wheels |= across, along |= directions != 0 && directions != 3 && !across;
    }
  const auto sign = [&](int directions) {
    return [&canvas, directions](const Vec<2>& c) { support_sign(canvas, c - Vec<2>(0, 4), Vec<2>(0, 1), directions); };
  };
  if (hatched) column.entry("held in x and y", sign(3));
  if (wheels) column.entry("held across the boundary", sign(2));
  if (along) column.entry("held along the boundary", sign(1));
  const auto arrow = [&](const Vec<2>& c) { canvas.arrow(c - Vec<2>(12, 0), c + Vec<2>(12, 0), {load_color, 1.5}); };
  for (const auto& [name, support] : model.settings.support) {
    if (support.motion) column.entry("support " + name + motion_words(support), arrow);
    if (support.head)
      column.entry(fmt::format("support {}, water outside with a head of {}{}", name, text::length_words(*support.head),
                               support.stages.empty() ? "" : fmt::format(" in {}", text_of_list(support.stages, ", "))),
                   arrow);
  }
  for (const auto& [name, traction] : model.settings.traction)
    column.entry(fmt::format("traction {} on boundary {}{}", name, traction.boundary,
                             traction.pressure ? ", " + text::stress_words(*traction.pressure) : "") +
                     (traction.pressure_gradient > 0
                          ? fmt::format(" and {} a metre below y = {}", text::stress_words(traction.pressure_gradient),
                                        text::length_words(traction.level.value_or(0)))
                          : ""),
                 arrow);
}

}  // namespace

Real draw_legend(Canvas& canvas, const Model& model, const Vec<2>& at, Real width)
{
  Column column(canvas, at, width);
  column.heading("Soil");
  soils(column, model, [&](const SoilKind& kind) { return soil_words(model.settings, kind); });
  rigid_bodies(column, model);
  mesh(column, canvas, model);
  return column.level();
}

Real draw_names(Canvas& canvas, const Model& model, const Vec<2>& at, Real width)
{
  Column column(canvas, at, width);
  soils(column, model, name_of);
  for (const NamedOutline& rigid : model.sketch.rigid_bodies) column.swatch(rigid.name, rigid_color, {rim_color, 1});
  if (!model.ground.surface.empty()) column.bar("surface", surface_color);
  if (!model.sketch.fine.empty()) column.swatch("fine zone", "none", {fine_color, 1.4, dashed});
  return column.level();
}

Real draw_stages(Canvas& canvas, const Model& model, const Vec<2>& at, Real width)
{
  Column column(canvas, at, width);
  const std::vector<settings::StageSettings>& stages = model.settings.stage;
  if (stages.empty()) return at[1];
  column.heading("Stages");
  for (std::size_t k = 0; k < stages.size() && k < max_stages; ++k)
    column.entry(stage_words(stages[k], model.settings.force_dimension()),
                 [&](const Vec<2>& c) { number_mark(canvas, c, fmt::format("{}", k + 1), stage_color(stages[k].kind)); });
  if (std::any_of(model.sketch.path.begin(), model.sketch.path.end(), [](const PathStep& step) { return !step.known; }))
    column.entry("dashed arrow: the travel is a result of the run", [](const Vec<2>&) {});
  if (stages.size() > max_stages) column.entry(fmt::format("and {} more", stages.size() - max_stages), [](const Vec<2>&) {});
  return column.level();
}

std::string method_words(const Model& model)
{
  const settings::Case& c = model.settings;
  std::string words = fmt::format("{}, {}. {} cells.", c.geometry == settings::Geometry::axisymmetric ? "Axisymmetric" : "Plane strain",
                                  c.method == settings::Method::mpm ? "material point method"
                                  : c.small_strain()                ? "small-strain finite elements around the body in place"
                                                                    : "remeshed finite elements",
                                  text::count_words(model.ground.cells));
  const Vec<2>& gravity = model.sketch.gravity;
  if (gravity.norm() > 0) words += fmt::format(" Gravity {:.3g} g", gravity.norm() / standard_gravity);
  if (gravity[0] != 0 && gravity[1] != 0)
    words += fmt::format(", {} from the vertical axis", text::angle_words(std::atan(std::abs(gravity[0] / gravity[1]))));
  if (gravity.norm() > 0) words += ".";
  return words + " To scale.";
}

}  // namespace berm::picture
