// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_footing_test.cpp
#include "structures/penetration/footing.hpp"

#include "core/axes.hpp"
#include "formulas/footing.hpp"
#include "mesh/seabed.hpp"
#include "os/error.hpp"
#include "problem/ground.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/kind.hpp"
#include "structures/base/little_cohesion.hpp"
#include "structures/penetration/code_envelope.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::penetration {
namespace {

using base::PublishedCurve, base::PublishedEnvelope;
using formulas::Base, formulas::Formula;

constexpr Real base_tolerance = 1e-6;  // of D
constexpr int curve_points = 60;

/// The footing in the plane of the load, or in space, before the first stage.
template <int dim>
struct Lying {
  Vec<dim> center;
  Real lowest;
  Axes<dim> axes;

  explicit Lying(const settings::Case& c) : center(), lowest(0), axes(axes_of<dim>(bodies::to_vec<dim>(c.gravity)))
  {
    const bodies::RigidShape<dim> shape = make_shape<dim>(c.rigid[main_rigid(c)].second.shape);
    center = center_of<dim>(shape);
    lowest = bodies::lowest_level<dim>(shape, axes.up_vector());
  }
};

void refuse_geometry(const settings::Case& c)
{
  if (c.geometry == settings::Geometry::axisymmetric)
    throw KeyError(
        "geometry: around an axis a footing goes straight down only, as berm run does; an envelope needs geometry = \"space\" with "
        "symmetry = [\"z\"], or \"plane_strain\"");
  if (std::find(c.symmetry.begin(), c.symmetry.end(), "x") != c.symmetry.end())
    throw KeyError(
        "symmetry: a footing that is dragged along x and rotated about z is not its own mirror image across x: an envelope needs "
        "symmetry = [\"z\"], and a half of the mesh");
}

template <int dim>
base::EmbeddedBody embedded_in(const settings::Case& c)
{
  const auto& [name, rigid] = c.rigid[main_rigid(c)];
  const std::optional<base::BodyProfile> body = base::body_profile(rigid.shape);
  const Lying<dim> lying(c);
  if (lying.axes.up != 1 || lying.axes.sign < 0) throw KeyError("gravity: the envelope of a footing needs gravity along -y");
  if (!body || body->disk || body->shoulder > base_tolerance * body->width)
    throw KeyError(fmt::format("rigid.{}.shape: the envelope of a footing needs a flat, level base", name));
  if (std::abs((body->left + body->right) / 2 - lying.center[0]) > base_tolerance * body->width)
    throw KeyError(fmt::format("rigid.{}.shape: the envelope of a footing needs its centre above the middle of its base", name));
  base::EmbeddedBody footing{body->width, problem::ground_of(c).level_at(lying.center[0], c.surface) - lying.lowest,
                             lying.center[1] - lying.lowest};
  if (footing.embedment < -base_tolerance * footing.width)
    throw KeyError(
        fmt::format("rigid.{}.center: the base of the footing lies {:g} m above the bed; an envelope needs it on the bed or in it", name,
                    -footing.embedment));
  if (const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    const mesh::SeabedLayout layout = layout_of(*seabed);
    if (body->left < layout.left || body->right > layout.right)
      throw KeyError(
          fmt::format("rigid.{}.center: the footing reaches beyond a wall of the mesh; an envelope needs the whole footing", name));
  }
  return footing;
}

/// A footing on the soil that it touches.
struct OnSoil {
  base::EmbeddedBody footing;
  Real area = 0;  ///< m2 (of a strip m2 per metre run); NaN where it is not known
  bool strip = false, round = false, level = false, at_surface = false;
  settings::BodySoil soil;
  material::Strength strength;
  const contact::ContactSettings* contact = nullptr;

  /// A formula as it holds here: all are those of a footing on a level surface.
  Formula here(Formula formula) const
  {
    formula.valid = formula.valid && at_surface;
    return formula;
  }
};

Real area_of(const settings::Case& c, Real width)
{
  const bodies::RigidShapeSettings& shape = c.rigid[main_rigid(c)].second.shape;
  if (c.geometry != settings::Geometry::space) return width;
  if (bodies::is_round_from_above(shape)) return pi * width * width / 4;
  const auto* box = std::get_if<bodies::BoxSettings>(&shape);
  return box == nullptr ? nan : width * box->size[2];
}

formulas::FoundationBase base_of_code(const OnSoil& on)
{
  using Shape = formulas::FoundationBase::Shape;
  const Real B = on.footing.width;
  return {on.strip   ? Shape::strip
          : on.round ? Shape::circle
                     : Shape::rectangle,
          B, on.strip || on.round ? 0 : on.area / B, std::max(Real(0), on.footing.embedment)};
}

/// The clay as the code has it: at the base, its growth over a width below it, its mean above.
formulas::ClayOfFoundation clay_of_code(const OnSoil& on, Real roughness, Real gravity)
{
  constexpr int slices = 20;
  const Real depth = std::max(Real(0), on.footing.embedment), B = on.footing.width;
  const auto strength = [&](Real z) { return strength_at_rest(on.soil.at("", z))->cohesion; };
  Real above = 0;
  for (int k = 0; k < slices; ++k) above += strength((k + 0.5) / slices * depth) / slices;
  return {strength(depth), (strength(depth + B) - strength(depth)) / B, above, std::min(roughness, Real(1)),
          gravity * on.soil.mass_above("", depth)};
}

/// The largest H/(B s_u) that the whole width of a strip carries beside v = V/(B s_u).
Real largest_h(Real v)
{
  Real low = 0, high = 1;
  if (v <= formulas::n_c_inclined(1).value * (1 + base_tolerance)) return 1;
  for (int k = 0; k < 60; ++k) {
    const Real middle = (low + high) / 2;
    (formulas::n_c_inclined(middle).value > v ? low : high) = middle;
  }
  return low;
}

/// The sections of the moments that a strip carries on its effective width, as lower bounds.
void add_effective_width(const OnSoil& on, Real slides_at, PublishedEnvelope& published)
{
  const Real unit = published.unit, unit_of_moment = unit * on.footing.width, v_max = formulas::n_c(0).value;
  const Formula any = on.here(formulas::strip_moment_on_effective_width(1, 0));
  PublishedCurve without_H{base::titled("effective width B - 2 M/V, a lower bound", any), {}, {}};
  for (int k = 0; k <= curve_points; ++k) {
    const Real v = v_max * k / curve_points;
    without_H.V.push_back(unit * v);
    without_H.M.push_back(unit_of_moment * formulas::strip_moment_on_effective_width(v, 0).value);
  }
  published.curves.push_back(without_H);
  if (slides_at < 1) return;  // a smoother base slides before
  for (const Real level : base::section_levels) {
    const Real v = level * v_max;
    const Real most = largest_h(v);
    PublishedCurve section{base::titled(fmt::format("effective width, a lower bound, V = {:g} Vmax", level), any), {}, {}};
    for (int k = -curve_points; k <= curve_points; ++k) {
      const Real h = most * k / curve_points;
      section.H.push_back(unit * h);
      section.M.push_back(unit_of_moment * formulas::strip_moment_on_effective_width(v, std::abs(h)).value);
    }
    published.curves.push_back(section);
  }
}

/// Green's V and H, to where the base slides.
void add_inclined(const OnSoil& on, Real slides_at, PublishedEnvelope& published)
{
  const Formula any = on.here(formulas::n_c_inclined(0));
  PublishedCurve curve{base::titled(any.source.work, any), {0}, {published.unit * slides_at}};
  for (int k = curve_points; k >= 0; --k) {
    const Real h = slides_at * std::sin(pi / 2 * k / curve_points);
    curve.V.push_back(published.unit * formulas::n_c_inclined(h).value);
    curve.H.push_back(published.unit * h);
  }
  published.curves.push_back(curve);
}

Formula times(Formula formula, Real unit)
{
  return formula.value *= unit, formula;
}

/// What is exact, or a bound, of a strip on uniform clay that carries `ratio` s_u along its base.
void add_strip(const OnSoil& on, Real ratio, PublishedEnvelope& published)
{
  add_inclined(on, ratio, published);
  add_effective_width(on, ratio, published);
  const bool sticks = rules_of(on.contact->scheme).tied || std::isinf(on.contact->tension);
  if (!sticks) return;
  const Formula arc = times(on.here(formulas::strip_moment_of_arc()), published.unit * on.footing.width);
  published.numbers.push_back({"M_max_arc", arc, true});
  published.curves.push_back({base::titled("arc through both edges, an upper bound", arc), {0}, {}, {arc.value}});
}

PublishedEnvelope for_clay(const OnSoil& on, Real gravity)
{
  PublishedEnvelope published;
  const Real strength = strength_at_rest(on.soil.at("", 0))->cohesion;
  published.unit = on.area * strength;
  published.unit_name = "(A sᵤ)";
  const Real ratio = base::interface_ratio(*on.contact, strength);
  if (std::isnan(ratio)) {
    published.remark = "the formulas for clay have adhesion to the base, not friction: there is no curve to compare with";
    return published;
  }
  constexpr formulas::Source sliding{formulas::Label::exact, "the base slides", "at the surface, V up to half of V_max"};
  const Real growth = (strength_at_rest(on.soil.at("", on.footing.width))->cohesion - strength) / strength;
  if (on.strip || on.round) {
    const Base base = ratio >= 1 ? Base::rough : Base::smooth;
    Formula N = on.round ? formulas::n_c_circle(growth, base) : formulas::n_c_strip(growth, base);
    N.valid = N.valid && (ratio >= 1 || ratio <= 0 || (on.strip && growth == 0));
    published.numbers.push_back({"V_max", times(on.here(N), published.unit)});
  }
  published.numbers.push_back({"H_max", times(on.here(formulas::formula(ratio, sliding, true)), published.unit)});
  if (growth != 0)
    published.remark = "the strength grows with depth: Green's curve and that of the effective width are of uniform clay and not shown";
  if (on.strip && growth == 0) add_strip(on, ratio, published);
  if (on.level) add_code_on_clay(base_of_code(on), clay_of_code(on, ratio, gravity), published);
  return published;
}

PublishedEnvelope for_sand(const OnSoil& on, Real unit_weight)
{
  PublishedEnvelope published;
  published.unit = unit_weight * on.footing.width * on.area;
  published.unit_name = "(γ' D A)";
  if (on.at_surface)
    add_code_on_sand(base_of_code(on), {on.strength.friction_angle, unit_weight},
                     rules_of(on.contact->scheme).tied ? on.strength.friction_angle : on.contact->friction_angle, published);
  if (!on.strip && !on.round) return published;
  const Real phi = on.strength.friction_angle;
  const bool tied = rules_of(on.contact->scheme).tied;
  const Base base = tied || on.contact->friction_angle >= phi ? Base::rough : Base::smooth;
  Formula N = on.round ? formulas::n_gamma_circle(phi, base) : formulas::n_gamma(phi, base);
  N.valid = N.valid && std::abs(on.strength.dilation_angle - phi) < associated && (base == Base::rough || on.contact->friction_angle == 0);
  N = on.here(N);
  N.value *= published.unit / 2;
  published.numbers.push_back({"V_max", N});
  published.curves.push_back({base::titled("Vmax, characteristics", N), {N.value}, {0}});
  return published;
}

}  // namespace

base::EmbeddedBody embedded_footing(const settings::Case& c)
{
  refuse_geometry(c);
  return c.dimension() == 2 ? embedded_in<2>(c) : embedded_in<3>(c);
}

PublishedEnvelope footing_envelope(const settings::Case& c)
{
  PublishedEnvelope unknown;
  unknown.remark = "no formula is known for this soil: neither clay (phi = 0) nor sand (c cot phi up to 5 % of gamma' D)";
  const std::optional<settings::BodySoil> soil = base::touched_soil(c);
  const std::optional<material::Material> material = base::touched_material(c);
  const std::optional<material::Strength> strength = material ? strength_at_rest(*material) : std::nullopt;
  if (!soil || !strength) return unknown;
  OnSoil on{.footing = embedded_footing(c),
            .strip = c.geometry == settings::Geometry::plane_strain,
            .soil = *soil,
            .strength = *strength,
            .contact = base::contact_of_body(c)};
  on.area = area_of(c, on.footing.width);
  on.round = !on.strip && bodies::is_round_from_above(c.rigid[main_rigid(c)].second.shape);
  on.level = problem::ground_of(c).line.level();
  on.at_surface = on.level && std::abs(on.footing.embedment) <= base_tolerance * on.footing.width;
  if (std::isnan(on.area)) return unknown;
  const Real unit_weight = base::body_scale(c).unit_weight;
  if (strength->friction_angle == 0 && strength->cohesion > 0) return for_clay(on, base::body_scale(c).gravity_level * standard_gravity);
  if (strength->friction_angle > 0 && unit_weight > 0 &&
      base::has_little_cohesion(strength->cohesion, strength->friction_angle, unit_weight, on.footing.width))
    return for_sand(on, unit_weight);
  return unknown;
}

}  // namespace berm::penetration
