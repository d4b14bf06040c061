// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/driven_body.hpp"
#include "bodies/fill.hpp"

#include "core/axes.hpp"
#include "mesh/seabed.hpp"
#include "problem/ground.hpp"
#include "structures/base/kind.hpp"

#include <Eigen/Core>
#include <algorithm>

namespace berm::base {

const contact::ContactSettings* contact_of_body(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  const contact::ContactSettings* found = nullptr;
  for (const auto& [name, contact] : c.contact)
    if (rigid != none && contact.rigid == c.rigid[rigid].first) found = &contact;
  return found;
}

Real interface_ratio(const contact::ContactSettings& contact, Real strength)
{
  if (rules_of(contact.scheme).tied) return 1;
  if (contact.friction_angle > 0 || !(strength > 0)) return nan;
  return std::min(Real(1), contact.adhesion_factor > 0 ? contact.adhesion_factor : contact.adhesion / strength);
}

std::optional<settings::BodySoil> touched_soil(const settings::Case& c)
{
  const contact::ContactSettings* contact = contact_of_body(c);
  const Index body = contact == nullptr ? none : index_of(c.body, contact->body);
  if (body == none || index_of(c.material, c.body[body].second.material) == none) return {};
  return soil_of(c, c.body[body].second);
}

std::optional<settings::BodySoil> touched_soil(const record::RunRecord& run)
{
  std::optional<settings::BodySoil> soil = touched_soil(run.settings);
  if (!soil || !run.summary) return soil;
  const auto noted = run.summary->text.find(region_entry);
  if (noted == run.summary->text.end()) return soil;
  const auto found = soil->of_region.find(noted->second);
  if (found == soil->of_region.end()) return soil;
  settings::BodySoil one = settings::soil_of_one(soil->materials[found->second], soil->names[found->second]);
  one.gravity = soil->gravity, one.vertical_stress_at_start = soil->vertical_stress_at_start;
  return one;
}

Real soil_depth(const settings::Case& c, const problem::Ground& ground, Real w)
{
  const Index rigid = main_rigid(c);
  if (rigid == none || c.dimension() != 2) return w;
  const Axes<2> axes = axes_of<2>(bodies::to_vec<2>(c.gravity));
  return ground.soil_depth_at(center_of<2>(make_shape<2>(c.rigid[rigid].second.shape))[axes.along], w, c.surface);
}

Real reference_depth(const settings::Case& c)
{
  return reference_depth(c, problem::ground_of(c));
}

Real reference_depth(const settings::Case& c, const problem::Ground& ground)
{
  const Index rigid = main_rigid(c);
  if (rigid == none) return 0;
  const auto lowest = [&](auto gravity) {
    constexpr int dim = decltype(gravity)::RowsAtCompileTime;
    const Axes<dim> axes = axes_of<dim>(gravity);
    const bodies::RigidShape<dim> shape = make_shape<dim>(c.rigid[rigid].second.shape);
    const Real surface = ground.level_at(center_of<dim>(shape)[axes.along], c.surface);
    return axes.sign * surface - bodies::lowest_level<dim>(shape, axes.up_vector());
  };
  Real depth = c.dimension() == 2 ? lowest(bodies::to_vec<2>(c.gravity)) : lowest(bodies::to_vec<3>(c.gravity));
  if (!std::isfinite(depth)) depth = 0;
  if (!c.small_strain())
    for (const settings::StageSettings& stage : c.stage)
      if (stage.kind == settings::StageKind::push) depth = std::max(depth, stage.until.embedment.value_or(0));
  return std::max(Real(0), depth);
}

std::optional<material::Material> touched_material(const settings::Case& c)
{
  const std::optional<settings::BodySoil> soil = touched_soil(c);
  return soil ? std::optional(soil->at("", soil_depth(c, problem::ground_of(c), reference_depth(c)))) : std::nullopt;
}

namespace {

/// The scale of a case on this ground whose main rigid body touches this soil.
BodyScale scale_in(const settings::Case& c, const problem::Ground& ground, const std::optional<settings::BodySoil>& touched)
{
  const Real gravity = Eigen::Map<const Eigen::VectorXd>(c.gravity.data(), static_cast<Eigen::Index>(c.gravity.size())).norm();
  BodyScale scale{0, 0, gravity / standard_gravity, c.method == settings::Method::mpm, c.force_dimension()};
  const Index rigid = main_rigid(c);
  if (rigid == none) return scale;
  const bodies::RigidShapeSettings& shape = c.rigid[rigid].second.shape;
  const bool driven = std::any_of(c.stage.begin(), c.stage.end(), [](const settings::StageSettings& stage) {
    return stage.kind == settings::StageKind::push || stage.kind == settings::StageKind::drag;
  });
  if (driven || is_loaded_sideways(c))
    scale.width = c.dimension() == 2 ? width_of<2>(make_shape<2>(shape)) : width_of<3>(make_shape<3>(shape));
  if (!touched) return scale;
  const Real depth = soil_depth(c, ground, reference_depth(c, ground));
  const material::Material material = touched->at("", depth);
  scale.unit_weight = density(material) * gravity;
  const std::optional<material::Strength> soil = strength_at_rest(material);
  if (soil && soil->friction_angle == 0) {
    scale.strength = soil->cohesion;
    if (varies(*touched)) scale.strength_depth = depth;
  }
  return scale;
}

}  // namespace

BodyScale body_scale(const settings::Case& c)
{
  return scale_in(c, problem::ground_of(c), touched_soil(c));
}

BodyScale body_scale(const record::RunRecord& run)
{
  const std::optional<settings::BodySoil> soil = touched_soil(run);
  BodyScale scale = scale_in(run.settings, run.ground, soil);
  const run_folder::Quantity* reached = run.quantity("w_end_of_push");
  if (!(scale.strength_depth > 0) || reached == nullptr || !(reached->value > 0)) return scale;
  scale.strength_depth = soil_depth(run.settings, run.ground, reached->value);
  scale.strength = strength_at_rest(soil->at("", scale.strength_depth))->cohesion;
  return scale;
}

bool drives_a_body(const settings::Case& c)
{
  return body_scale(c).width > 0;
}

std::string body_word(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  std::string word = rigid == none ? "body" : c.rigid[rigid].first;
  std::replace(word.begin(), word.end(), '_', ' ');
  return word;
}

std::optional<bodies::DiskOutline> circle_of(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  return rigid == none ? std::nullopt : bodies::pipe_section(c.rigid[rigid].second.shape);
}

Real modelled_part(const settings::Case& c)
{
  const std::optional<bodies::DiskOutline> circle = circle_of(c);
  if (!circle) return nan;
  const auto* seabed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (seabed == nullptr) return 1;
  const mesh::SeabedLayout layout = layout_of(*seabed);
  const Real x = circle->center[0], radius = circle->radius, round_off = 1e-9 * radius;
  if (x - radius >= layout.left && x + radius <= layout.right) return 1;
  return std::abs(x - layout.left) < round_off || std::abs(x - layout.right) < round_off ? 0.5 : nan;
}

bool has_prototype(const BodyScale& scale)
{
  return scale.gravity_level > 0 && std::abs(scale.gravity_level - 1) > 0.05;
}

Real averaging_half(const BodyScale& scale)
{
  return scale.noisy ? averaging_half_width * scale.width : 0;
}

Real near_cell_size(const settings::Case& c)
{
  if (c.method == settings::Method::fem && c.fem.contact_size) return *c.fem.contact_size;
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) return bed->near_size;
  const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh);
  if (box == nullptr) return nan;
  Real size = 0;
  for (std::size_t d = 0; d < box->size.size(); ++d) size = std::max(size, box->size[d] / box->cells[d]);
  return size;
}

NearCells near_cells(const record::RunRecord& run)
{
  const Real named = near_cell_size(run.settings), found = run.check("cells_at_body_first_m"),
             largest = run.check("cells_at_body_largest_m");
  const Real first = std::isnan(named) ? found : named;
  return {first, first * largest / found};
}

Real near_particles(const settings::Case& c)
{
  if (c.method == settings::Method::fem || c.body.empty()) return nan;
  const contact::ContactSettings* contact = contact_of_body(c);
  const Index body = contact == nullptr ? 0 : index_of(c.body, contact->body);
  const bodies::BodySettings& settings = c.body[body].second;
  const Real spacing = settings.block ? settings.block->spacing : settings.disk ? settings.disk->spacing : 0;
  if (spacing > 0) return std::pow(std::round(near_cell_size(c) / spacing), c.dimension());
  const auto near = settings.region_particles_per_cell.find("near");
  if (near != settings.region_particles_per_cell.end()) return near->second;
  return filled_particles(settings, c.dimension());
}

bool covers_the_mesh(const settings::Case& c)
{
  const Index rigid = main_rigid(c);
  const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh);
  if (rigid == none || box == nullptr || c.dimension() != 2) return false;
  const bodies::RigidShape<2> shape = bodies::make_shape<2>(c.rigid[rigid].second.shape);
  const int along = axes_of<2>(bodies::to_vec<2>(c.gravity)).along;
  Vec<2> right = Vec<2>::Zero();
  right[along] = 1;
  const Real lower = box->lower.empty() ? 0 : box->lower[along];
  return bodies::lowest_level<2>(shape, right) <= lower && -bodies::lowest_level<2>(shape, Vec<2>(-right)) >= lower + box->size[along];
}

int filled_particles(const bodies::BodySettings& body, int dim)
{
  return body.particles_per_cell > 0 ? body.particles_per_cell
         : dim == 2                  ? bodies::usual_particles_per_cell<2>
                                     : bodies::usual_particles_per_cell<3>;
}

}  // namespace berm::base
