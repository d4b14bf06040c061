// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/setup/setup_section_test.cpp
#include "report/setup/setup_section.hpp"

#include "material/laws.hpp"
#include "picture/stage_words.hpp"
#include "settings/drainage.hpp"
#include "settings/time_scale.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/soil_words.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"
#include "text/run_columns.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

/// The rows of one run.
class Rows {
public:
  explicit Rows(const record::RunRecord& run) : run_(run), case_(run.settings), scale_(base::body_scale(run)) {}

  void add(const std::string& heading, const std::string& words, const std::string& key = "")
  {
    entries_.push_back({key.empty() ? heading : key, text::html_text(heading), text::html_text(words), false, "", ""});
  }
  void length(const std::string& heading, Real metres)
  {
    add(heading, with_prototype(text::length_words(metres), text::length_words(metres * level())));
  }
  std::string with_prototype(const std::string& model, const std::string& prototype) const
  {
    return has_prototype(scale_) && model != prototype ? fmt::format("{} ({})", model, prototype) : model;
  }
  Real level() const { return scale_.gravity_level; }
  const base::BodyScale& scale() const { return scale_; }
  const settings::Case& settings() const { return case_; }
  Real surface_at(Real x) const { return run_.surface_at(x); }
  std::vector<text::RunEntry> list() && { return std::move(entries_); }

private:
  const record::RunRecord& run_;
  const settings::Case& case_;
  base::BodyScale scale_;
  std::vector<text::RunEntry> entries_;
};

void add_law(Rows& rows, const std::string& prefix, const material::MohrCoulomb& law)
{
  rows.add(prefix + "friction angle", text::angle_words(law.friction_angle));
  rows.add(prefix + "dilation angle", text::angle_words(law.dilation_angle));
  if (law.shansep)
    rows.add(prefix + "undrained strength", formula_words(*law.shansep));
  else
    rows.add(prefix + "cohesion", text::stress_words(law.cohesion) + (varies(law) ? " at the surface" : ""));
  if (law.cohesion_gradient != 0) rows.add(prefix + "cohesion per metre of depth", text::stress_words(law.cohesion_gradient));
}

void add_law(Rows& rows, const std::string& prefix, const material::Clay& law)
{
  if (law.shansep)
    rows.add(prefix + "undrained strength", formula_words(*law.shansep));
  else
    rows.add(prefix + "undrained strength", text::stress_words(law.undrained_strength) + (varies(law) ? " at the surface" : ""));
  if (law.undrained_strength_gradient != 0)
    rows.add(prefix + "undrained strength per metre of depth", text::stress_words(law.undrained_strength_gradient));
  rows.add(prefix + "sensitivity", text::number_words(law.sensitivity));
  if (law.sensitivity > 1) rows.add(prefix + "ductility ξ95", text::number_words(law.ductility));
  if (law.rate_parameter > 0)
    rows.add(prefix + "rate parameter", fmt::format("{:.3g} a decade above {:.3g} /s, of {:.3g} times the model's rate", law.rate_parameter,
                                                    law.reference_rate, law.rate_scale));
}

void add_law(Rows& rows, const std::string& prefix, const material::NgiAdp& law)
{
  if (law.shansep)
    rows.add(prefix + "active strength", formula_words(*law.shansep));
  else
    rows.add(prefix + "active strength", text::stress_words(law.undrained_strength) + (varies(law) ? " at the surface" : ""));
  if (law.undrained_strength_gradient != 0)
    rows.add(prefix + "active strength per metre of depth", text::stress_words(law.undrained_strength_gradient));
  rows.add(prefix + "simple shear and passive over active strength", fmt::format("{:.3g}, {:.3g}", law.dss_ratio, law.passive_ratio));
  rows.add(prefix + "shear strain at failure: active, simple shear, passive",
           fmt::format("{:.3g} %, {:.3g} %, {:.3g} %", 100 * law.active_failure_strain, 100 * law.dss_failure_strain,
                       100 * law.passive_failure_strain));
  rows.add(prefix + "initial mobilisation τ0 / active strength", text::number_words(law.initial_mobilisation));
}

void add_shape(Rows& rows, const std::string& prefix, material::DeviatoricShape shape)
{
  if (shape == material::DeviatoricShape::matsuoka_nakai) rows.add(prefix + "strength over direction", "Matsuoka and Nakai");
}

void add_law(Rows& rows, const std::string& prefix, const material::ModifiedCamClay& law)
{
  rows.add(prefix + "critical friction angle", text::angle_words(law.critical_friction_angle));
  add_shape(rows, prefix, law.deviatoric_shape);
  rows.add(prefix + "λ, κ", fmt::format("{:.3g}, {:.3g}", law.compression_index, law.swelling_index));
  rows.add(prefix + "void ratio", text::number_words(law.void_ratio));
  rows.add(prefix + "overconsolidation ratio", text::number_words(law.overconsolidation_ratio));
}

void add_law(Rows& rows, const std::string& prefix, const material::NorSand& law)
{
  rows.add(prefix + "critical friction angle", text::angle_words(law.critical_friction_angle));
  add_shape(rows, prefix, law.deviatoric_shape);
  rows.add(prefix + "critical state line Γ, λe", fmt::format("{:.3g}, {:.3g}", law.critical_void_ratio, law.critical_line_slope));
  rows.add(prefix + "N, χ, H", fmt::format("{:.3g}, {:.3g}, {:.3g}", law.volumetric_coupling, law.dilatancy, law.hardening_modulus));
  if (law.state_parameter) rows.add(prefix + "state parameter ψ", text::number_words(*law.state_parameter));
  if (law.void_ratio) rows.add(prefix + "void ratio", text::number_words(*law.void_ratio));
}

void add_law(Rows& rows, const std::string& prefix, const material::HardeningSoil& law)
{
  const material::Strength strength = strength_at_rest(law).value_or(material::Strength{});
  rows.add(prefix + "cohesion c'", text::stress_words(strength.cohesion));
  rows.add(prefix + "friction angle", text::angle_words(strength.friction_angle));
  rows.add(prefix + "dilation angle", text::angle_words(strength.dilation_angle));
  rows.add(prefix + "E50, Eoed, Eur at " + text::stress_words(law.reference_pressure),
           fmt::format("{}, {}, {}", text::stress_words(law.secant_modulus), text::stress_words(law.oedometer_modulus),
                       text::stress_words(law.unloading_modulus)));
  rows.add(prefix + "m, R_f", fmt::format("{:.3g}, {:.3g}", law.stiffness_exponent, law.failure_ratio));
  rows.add(prefix + "overconsolidation ratio", text::number_words(law.overconsolidation_ratio));
  if (law.small_strain_shear_modulus && law.shear_strain_at_70_percent)
    rows.add(prefix + "G0, γ0.7",
             fmt::format("{}, {:.3g}", text::stress_words(*law.small_strain_shear_modulus), *law.shear_strain_at_70_percent));
}

void add_law(Rows& rows, const std::string& prefix, const material::Hypoplastic& law)
{
  rows.add(prefix + "critical friction angle", text::angle_words(law.critical_friction_angle));
  rows.add(prefix + "h_s, n", fmt::format("{}, {:.3g}", text::stress_words(law.granular_hardness), law.hardness_exponent));
  rows.add(prefix + "e_d0, e_c0, e_i0",
           fmt::format("{:.3g}, {:.3g}, {:.3g}", law.min_void_ratio, law.critical_void_ratio, law.max_void_ratio));
  rows.add(prefix + "α, β", fmt::format("{:.3g}, {:.3g}", law.dilatancy_exponent, law.stiffness_exponent));
  if (law.relative_density) rows.add(prefix + "relative density", text::number_words(*law.relative_density));
  if (law.void_ratio) rows.add(prefix + "void ratio", text::number_words(*law.void_ratio));
  if (law.small_strain > 0)
    rows.add(prefix + "intergranular strain R, m_R, m_T, β_r, χ",
             fmt::format("{:.3g}, {:.3g}, {:.3g}, {:.3g}, {:.3g}", law.small_strain, law.reversal_stiffness, law.turn_stiffness,
                         law.evolution_exponent, law.decay_exponent));
}

/// Of the others the library or nothing.
template <class Law>
void add_law(Rows& rows, const std::string& prefix, const Law& law)
{
  if constexpr (requires { law.library; }) rows.add(prefix + "library", law.library);
}

/// Where the water in the pores goes.
void add_water(Rows& rows, const std::string& prefix, const material::Material& material)
{
  const std::optional<material::PoreWater> water = pore_water(material);
  if (!water) return;
  using enum material::Drainage;
  rows.add(prefix + "water in the pores", water->drainage == drained     ? "drained: no excess pore pressure"
                                          : water->drainage == undrained ? "undrained: it does not flow"
                                                                         : "flows (consolidation)");
  if (const std::optional<material::Hydraulics> flow = hydraulics(material)) {
    rows.add(prefix + "permeability k",
             fmt::format("{:.3g} m/s{}", flow->permeability, flow->kozeny_carman ? ", follows the porosity" : ""));
    rows.add(prefix + "porosity n", text::number_words(flow->porosity));
  }
}

void add_material(Rows& rows, const std::string& prefix, const material::Material& material)
{
  const settings::Case& c = rows.settings();
  const Real gravity = rows.level() * standard_gravity;
  rows.add(prefix + "law", law_name(material));
  rows.add(prefix + "density", fmt::format("{:.4g} kg/m³", density(material)));
  if (gravity > 0)
    rows.add(prefix + "unit weight", rows.with_prototype(text::unit_weight_words(density(material) * gravity),
                                                         text::unit_weight_words(density(material) * standard_gravity)));
  const auto [E, nu] = young_poisson(material);
  const bool by_pressure = visit(
      [](const auto& law) {
        return requires
        {
          law.max_pressure;
        };
      },
      material);
  rows.add(prefix + (by_pressure ? "Young's modulus at the maximum pressure" : "Young's modulus"), text::stress_words(E));
  rows.add(prefix + "Poisson's ratio", text::number_words(nu));
  const auto is_own = [&](const std::string& name) { return &c.material[index_of(c.material, name)].second == &material; };
  for (const auto& [name, body] : c.body) {
    if (body.has_k0() && is_own(body.material)) rows.add(prefix + "K0", base::k0_in_words(body.at_rest(), body.sin_friction));
    for (const bodies::SoilLayerSettings& layer : body.soil_layer)
      if (layer.at_rest().by_history() && is_own(layer.material))
        rows.add(prefix + fmt::format("K0 from {} down", text::length_words(layer.top)),
                 base::k0_in_words(layer.at_rest(), layer.sin_friction));
  }
  visit([&](const auto& law) { add_law(rows, prefix, law); }, material);
  add_water(rows, prefix, material);
}

/// Supports that move, and water outside of them.
void add_supports(Rows& rows)
{
  for (const auto& [name, support] : rows.settings().support) {
    const std::string heading = "support " + name;
    if (support.motion) rows.add(heading, picture::held_words(rows.settings(), support) + picture::motion_words(support));
    if (!support.head) continue;
    rows.add(heading + ": head of the water outside", text::length_words(*support.head) + " above the still sea" +
                                                          (support.ramp > 0 ? ", ramp " + text::time_words(support.ramp) : ""));
  }
}

/// Layers and regions of other materials, and the strength that forces are divided by where it varies.
void add_soils(Rows& rows)
{
  for (const auto& [name, body] : rows.settings().body)
    if (const settings::BodySoil soil = soil_of(rows.settings(), body); soil.materials.size() > 1)
      rows.add(fmt::format("body {}: materials", name), base::layers_in_words(soil));
  for (const base::EarthworkWords& work : base::earthworks_in_words(rows.settings()))
    rows.add(fmt::format("body {}: {}", work.body, work.settings.name), work.words);
  if (const base::BodyScale& scale = rows.scale(); scale.strength_depth > 0)
    rows.add(fmt::format("undrained strength at a depth of {}, that of the lowest point after the push",
                         text::length_words(scale.strength_depth)),
             text::stress_words(scale.strength));
}

void add_rigid(Rows& rows, const std::string& prefix, const bodies::RigidSettings& rigid)
{
  const std::vector<bodies::ShapeSize> sizes = std::visit([](const auto& shape) { return sizes_of(shape); }, rigid.shape);
  for (const auto& [name, size] : sizes) rows.length(prefix + name, size);
  if (sizes.empty()) rows.add(prefix + "shape", std::visit([](const auto& shape) { return name_of(shape); }, rigid.shape));
  if (rows.settings().dimension() == 2 && bodies::pipe_section(rigid.shape))
    rows.length(prefix + "embedment at the start", rows.surface_at(center_of<2>(bodies::make_shape<2>(rigid.shape))[0]) -
                                                       bodies::lowest_level<2>(bodies::make_shape<2>(rigid.shape), Vec<2>::UnitY()));
  if (rigid.mass > 0)
    rows.add(prefix + "mass", fmt::format("{:.4g} {}", rigid.mass, rows.settings().force_dimension() == 2 ? "kg/m" : "kg"));
}

/// The word that the case file has for a parameter.
std::string word_of(const settings::Case& c, const std::string& path)
{
  const std::vector<ParameterEntry> all = parameters_of(c);
  const auto found = std::find_if(all.begin(), all.end(), [&](const ParameterEntry& entry) { return entry.path == path; });
  return found == all.end() ? "not known" : found->value;
}

void add_contact(Rows& rows, const std::string& prefix, const std::string& name, const contact::ContactSettings& contact)
{
  rows.add(prefix + "friction angle", text::angle_words(contact.friction_angle));
  if (contact.adhesion > 0) rows.add(prefix + "adhesion", text::stress_words(contact.adhesion));
  if (contact.adhesion_factor > 0) rows.add(prefix + "adhesion factor α", fmt::format("{:.3g}", contact.adhesion_factor));
  for (const contact::SoilInterfaceSettings& soil : contact.soil) {
    rows.add(prefix + "friction angle beside " + soil.material, text::angle_words(soil.friction_angle));
    if (soil.adhesion > 0) rows.add(prefix + "adhesion beside " + soil.material, text::stress_words(soil.adhesion));
    if (soil.adhesion_factor > 0) rows.add(prefix + "α beside " + soil.material, fmt::format("{:.3g}", soil.adhesion_factor));
  }
  if (softens(contact))
    rows.add(prefix + "sensitivity of the adhesion",
             fmt::format("{:.3g}, 95 % lost after {}", contact.adhesion_sensitivity, text::length_words(contact.adhesion_ductility)));
  if (contact.tension > 0) rows.add(prefix + "tension", contact.tension < infinity ? text::stress_words(contact.tension) : "unlimited");
  if (settings::has_flowing_water(rows.settings(), contact.body) && !contact.rigid.empty())
    rows.add(prefix + "water", contact.drained ? "crosses it (drained)" : "does not cross it");
  if (rows.settings().method == settings::Method::mpm)
    for (const char* key : {"scheme", "detection"})
      rows.add(prefix + key, word_of(rows.settings(), fmt::format("contact.{}.{}", name, key)));
}

void add_rigid_contact(Rows& rows, const std::string& prefix, const contact::RigidContactSettings& contact)
{
  rows.add(prefix + "friction angle", text::angle_words(contact.friction_angle));
  if (contact.restitution > 0) rows.add(prefix + "restitution", fmt::format("{:.3g}", contact.restitution));
}

void add_mesh(Rows& rows)
{
  const settings::Case& c = rows.settings();
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    rows.length("bed: length", bed->length);
    rows.length("bed: depth", bed->depth);
    if (bed->pattern == mesh::SeabedPattern::lattice && c.method == settings::Method::mpm) rows.add("bed: cells", "lattice");
    if (bed->slope != 0) rows.add("bed: slope along x (positive: uphill)", text::angle_words(bed->slope));
    if (bed->trench) rows.length("trench: depth", bed->trench->depth), rows.length("trench: width of its bottom", bed->trench->width);
    if (bed->trench) rows.add("trench: angle of its sides", text::angle_words(bed->trench->side_slope));
    if (bed->trench) rows.length("trench: x of its centre", bed->trench->center);
    if (bed->step)
      rows.length("step: height", bed->step->height), rows.add("step: angle of its face", text::angle_words(bed->step->face_slope));
    if (bed->step) rows.length("step: x where its face begins", bed->step->position);
    if (bed->layer > 0) rows.length("bed: outer layer", bed->layer);
  }
  if (const auto* file = std::get_if<mesh::GmshFile>(&c.mesh))
    rows.add("mesh", "from " + file->file + (file->scale != 1 ? fmt::format(", times {:g}", file->scale) : ""));
  if (const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh))
    for (std::size_t d = 0; d < box->size.size(); ++d)
      rows.length(fmt::format("mesh: length along {}", static_cast<char>('x' + d)), box->size[d]);
  const Real h = base::near_cell_size(c), D = rows.scale().width;
  rows.add(D > 0 ? "cells at the " + base::body_word(c) : "cells", std::isnan(h) ? "not known"
                                                                   : D > 0 ? fmt::format("{} = D/{:.3g}", text::length_words(h), D / h)
                                                                           : text::length_words(h));
}

void add_stages(Rows& rows)
{
  int number = 0;
  for (const settings::StageSettings& stage : rows.settings().stage) {
    const int dimension = rows.settings().force_dimension();
    const std::string until =
        rows.with_prototype(picture::until_words(stage, dimension), picture::until_words(stage, dimension, rows.level()));
    const bool driven = settings::drives(stage.kind);
    rows.add(fmt::format("stage {}", ++number),
             fmt::format("{}: {}{}", stage.name, driven ? picture::drive_words(stage, dimension) + ", until " : "", until));
    if (!stage.load_times.empty()) rows.add(fmt::format("stage {}: load history", number), settings::time_scale_words(stage));
  }
}

/// What the runs are about: the word of their main rigid body where it is one for all, else "body".
std::string subject_of(const std::vector<record::RunRecord>& runs)
{
  const std::string word = base::body_word(runs.front().settings);
  const bool same =
      std::all_of(runs.begin(), runs.end(), [&](const record::RunRecord& run) { return base::body_word(run.settings) == word; });
  return same ? word : "body";
}

std::string prefix_of(const std::string& what, const std::string& name, std::size_t count)
{
  return count > 1 ? fmt::format("{} {}: ", what, name) : what + ": ";
}

}  // namespace

text::HtmlTable compact_table(const std::vector<record::RunRecord>& runs)
{
  text::RunColumns columns("");
  bool models = false;
  for (const record::RunRecord& run : runs) {
    const settings::Case& c = run.settings;
    Rows rows(run);
    models = models || has_prototype(rows.scale());
    rows.add("method", c.method == settings::Method::mpm ? "material point method"
                       : c.small_strain()                ? "finite elements, wished in place"
                                                         : "finite elements, large deformations, remeshed");
    rows.add("gravity", rows.level() > 0 ? fmt::format("{:.4g} g", rows.level()) : "none");
    for (const auto& [name, rigid] : c.rigid)
      add_rigid(rows, c.rigid.size() > 1 ? prefix_of("rigid body", name, c.rigid.size()) : base::body_word(c) + ": ", rigid);
    for (const auto& [name, material] : c.material) add_material(rows, prefix_of("material", name, c.material.size()), material);
    add_soils(rows);
    add_supports(rows);
    for (const auto& [name, contact] : c.contact) add_contact(rows, prefix_of("interface", name, c.contact.size()), name, contact);
    for (const auto& [name, contact] : c.rigid_contact)
      add_rigid_contact(rows, fmt::format("{} against {}: ", contact.rigid, contact.other_rigid), contact);
    add_mesh(rows);
    if (const Real particles = base::near_particles(c); !std::isnan(particles)) {
      const bool lattice = c.body.front().second.regions.empty();
      rows.add("particles per cell", fmt::format("{:.0f}{}", particles, lattice ? " in a square of a cell's size" : ""));
    }
    add_stages(rows);
    columns.run(run.name, std::move(rows).list());
  }
  return columns.table("model-table", fmt::format("Soil, {}, interface and stages{}", subject_of(runs),
                                                  models ? ": the model, in brackets the prototype" : ""));
}

text::HtmlTable computation_table(const std::vector<record::RunRecord>& runs)
{
  text::RunColumns columns("");
  for (const record::RunRecord& run : runs) {
    Rows rows(run);
    const auto text = [&](const std::string& name) {
      if (!run.summary) return std::string("not recorded");
      const auto found = run.summary->text.find(name);
      return found == run.summary->text.end() || found->second.empty() ? std::string("not recorded") : found->second;
    };
    const bool mpm = run.settings.method == settings::Method::mpm;
    rows.add("machine", text("machine"));
    const std::string ranks = run.timing("ranks") > 1 ? fmt::format(" on each of {} ranks", run.timing("ranks")) : "";
    rows.add("threads", text::count_words(run.timing("threads")) + ranks);
    rows.add("time taken", text::time_words(run.timing("wall_s")));
    rows.add("cells", text::count_words(run.timing("cells")));
    if (mpm) rows.add("particles", text::count_words(run.timing("particles")));
    if (!mpm) rows.add("nodes", text::count_words(run.timing("nodes")));
    rows.add(mpm ? "steps" : "increments", text::count_words(run.timing("steps")));
    if (!mpm) rows.add("iterations", text::count_words(run.timing("iterations")));
    if (mpm) {
      const Real rate = run.timing("particle_steps_per_s");
      rows.add("particle-steps per second", std::isnan(rate) ? "not known" : fmt::format("{:.3g} million", rate / 1e6));
    }
    if (const Real memory = run.timing("memory_bytes"); !std::isnan(memory))
      rows.add("memory at most", fmt::format("{:.0f} MiB", memory / (1 << 20)));
    columns.run(run.name, std::move(rows).list());
  }
  return columns.table("computation", "Computation");
}

}  // namespace berm::report
