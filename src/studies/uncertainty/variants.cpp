// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/variants.hpp"

#include "material/shear_band.hpp"
#include "mesh/uneven_seabed.hpp"
#include "os/error.hpp"
#include "structures/base/driven_body.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::uncertainty {
namespace {

constexpr int count = 5;                        // coarser runs
constexpr Real least_ratio = 1.4, ratio = 2.2;  // of the cells of the least coarse, and of the coarsest
constexpr Real cells_across = 5;                // the driven body at least: fewer tell nothing (examples/mesh_study)
constexpr Real least_coarsest = 1.6;            // ratio, below which the runs differ by less than meshes do
constexpr Real grains[] = {0.1e-3, 0.5e-3};     // m, d50 of fine sand, and of medium to coarse sand

void make_coarser(mesh::SeabedMesh& bed, Real times)
{
  bed.near_size *= times;
  bed.growth *= times;
  if (bed.far_size) *bed.far_size *= times;
  const mesh::SeabedLayout at = layout_of(bed);
  const Real clear = bed.layer + bed.near_size;
  if (bed.near_left > at.left) bed.near_left = std::max(bed.near_left, at.left + clear);
  bed.near_right = std::min(bed.near_right, at.right - clear);
  if (bed.in_space()) {
    const Real back = 0 - bed.back.value_or(*bed.width / 2), front = back + *bed.width;
    if (bed.near_back > back) bed.near_back = std::max(*bed.near_back, back + clear);
    if (bed.near_front < front) bed.near_front = std::min(*bed.near_front, front - clear);
  }
  bed.near_height = std::max(bed.near_height, bed.near_size);
  const mesh::FineZone fine = mesh::fine_zone_of(bed);
  const Real lowest_surface = fine.lower + bed.near_depth;  // in the fine zone
  bed.near_depth = std::max(bed.near_size, std::min(bed.near_depth, bed.depth + lowest_surface - clear));
  bed.headroom = std::max(bed.headroom, std::max(fine.upper, mesh::highest_surface_of(bed)) + bed.near_size);
}

/// Gives the ratio that whole cells came to.
Real make_coarser(mesh::BoxMesh& box, Real times)
{
  Real product = 1;
  for (Real& cells : box.cells) {
    const Real before = cells;
    cells = std::max(Real(1), std::round(cells / times));
    product *= before / cells;
  }
  return std::pow(product, 1 / static_cast<Real>(box.cells.size()));
}

void make_faster(settings::StageSettings& stage)
{
  const auto twice = [](std::optional<Real>& velocity) {
    if (velocity) *velocity *= 2;
  };
  for (std::optional<Real>* velocity : {&stage.velocity, &stage.vertical_velocity, &stage.drive.x.velocity, &stage.drive.y.velocity,
                                        &stage.drive.z.velocity, &stage.drive.rotation.velocity, &stage.drive.rotation_x.velocity,
                                        &stage.drive.rotation_y.velocity, &stage.drive.rotation_z.velocity})
    twice(*velocity);
  stage.ramp /= 2;
  if (stage.until.time) *stage.until.time /= 2;
  for (Real& time : stage.load_times) time /= 2;
  for (std::size_t k = 0; k < settings::load_columns.size(); ++k)
    if (settings::load_columns[k].quantity == settings::LoadQuantity::velocity)
      for (Real& velocity : stage.loads.columns[k]) velocity *= 2;
}

bool knows_speed(const settings::Case& c)
{
  return std::any_of(c.material.begin(), c.material.end(), [](const auto& entry) { return is_rate_dependent(entry.second); });
}

/// The case with grains in all soil whose shear bands cells would make narrower; empty where they would in none.
std::optional<settings::Case> with_grain_size(settings::Case c, Real d50)
{
  bool changed = false;
  for (auto& [name, soil] : c.material) {
    if (!non_associated(soil) || band_width(soil)) continue;
    material::Material with = material::with_grain_size(soil, d50);
    const std::optional<Real> width = band_width(with);
    if (!width || *width >= material::cells_of_band * base::near_cell_size(c)) continue;
    soil = std::move(with);
    changed = true;
  }
  return changed ? std::optional(std::move(c)) : std::nullopt;
}

/// How much coarser cells may be until they are as large as the layer along walls and base.
Real largest_in_layer(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  return bed != nullptr && bed->layer > 0 ? bed->layer / bed->near_size : infinity;
}

/// How much coarser the coarsest cells may be. Throws KeyError.
Real coarsest_of(const settings::Case& c)
{
  if (!base::drives_a_body(c))
    throw KeyError("stage: --uncertainty needs a push or a drag of a body with a width: there are no key results without");
  if (std::holds_alternative<mesh::GmshFile>(c.mesh))
    throw KeyError(
        "mesh.file: --uncertainty makes all cells coarser, which it cannot do with a mesh from a file; let berm make the mesh (mesh.kind = "
        "\"seabed\" or \"box\"), or compare meshes of your own with berm study");
  const Real width = base::body_scale(c).width, size = base::near_cell_size(c);
  const Real coarsest = std::min({ratio, width / (cells_across * size), largest_in_layer(c)});
  if (largest_in_layer(c) < least_coarsest)
    throw KeyError(fmt::format(
        "mesh.layer: --uncertainty makes cells {:g} times as large at least, and the layer along walls and base must not be thinner than a "
        "cell of the fine zone: make it {:.3g} m or thicker, near_size smaller, or leave it out",
        least_coarsest, least_coarsest * std::get<mesh::SeabedMesh>(c.mesh).near_size));
  constexpr Real rounding = 1e-9;
  if (!(coarsest >= least_coarsest * (1 - rounding)))
    throw KeyError(fmt::format(
        "{}: --uncertainty makes cells {:g} times as large at least, and the driven body is only {:.2g} cells wide: make them {:.3g} m or "
        "smaller, so that {:g} coarse ones remain",
        c.method == settings::Method::fem && c.fem.contact_size ? "fem.contact_size"
        : std::holds_alternative<mesh::BoxMesh>(c.mesh)         ? "mesh.cells"
                                                                : "mesh.near_size",
        least_coarsest, width / size, width / (cells_across * least_coarsest), cells_across));
  return std::max(coarsest, least_coarsest);
}

}  // namespace

std::pair<settings::Case, Real> with_coarser_cells(settings::Case c, Real times)
{
  Real size = times;
  if (auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) make_coarser(*bed, times);
  if (auto* box = std::get_if<mesh::BoxMesh>(&c.mesh)) size = make_coarser(*box, times);
  if (c.fem.contact_size) *c.fem.contact_size *= size;
  for (auto& [name, body] : c.body) {
    if (body.block) body.block->spacing *= size;
    if (body.disk) body.disk->spacing *= size;
  }
  c.output.frame_time.reset();
  c.output.frame_travel.reset();
  return {std::move(c), size};
}

settings::Case at_twice_the_speed(settings::Case c)
{
  for (settings::StageSettings& stage : c.stage)
    if (drives(stage.kind)) make_faster(stage);
  if (c.output.history_time) *c.output.history_time /= 2;
  return c;
}

VariantPlan choose_variants(const settings::Case& c)
{
  const Real coarsest = coarsest_of(c), finest = 1 + (coarsest - 1) * (least_ratio - 1) / (ratio - 1);
  VariantPlan plan;
  for (int k = 0; k < count; ++k) {
    auto [settings, size] = with_coarser_cells(c, finest + (coarsest - finest) * k / (count - 1));
    const bool same = !plan.variants.empty() && std::abs(plan.variants.back().size - size) < 1e-9;
    if (same || !(size > 1))
      throw KeyError(fmt::format(
          "mesh.cells: --uncertainty cuts the box into fewer cells, {} times, and here are too few to be different: make more", count));
    plan.variants.push_back({fmt::format("cells_{:.3g}", size), size, 1, std::move(settings)});
  }
  const Variant last = plan.variants.back();
  if (c.method == settings::Method::fem) {
    settings::Case longer = last.settings;
    longer.fem.largest_step *= 2;
    if (c.fem.large_deformation) longer.fem.remeshing_travel = std::min(Real(1), 2 * longer.fem.remeshing_travel);  // limits them, too
    longer.fem.relaxation *= 4;  // its error grows with the root (examples/wip_pipe): this doubles it
    plan.variants.push_back({last.name + "_long_steps", last.size, 2, std::move(longer)});
  } else if (knows_speed(c)) {
    plan.left_out.emplace_back("speed: the strength of the soil depends on it");
  } else {
    plan.variants.push_back({last.name + "_fast", last.size, 2, at_twice_the_speed(last.settings)});
  }
  for (const Real d50 : grains)
    if (std::optional<settings::Case> settings = with_grain_size(last.settings, d50))
      plan.variants.push_back({fmt::format("{}_d50_{:g}_mm", last.name, 1000 * d50), last.size, 1, *std::move(settings), d50});
  return plan;
}

Real work_of(const VariantPlan& plan, const settings::Case& c)
{
  const int order = c.method == settings::Method::fem ? c.dimension() : c.dimension() + 1;
  Real work = 0;
  for (const Variant& variant : plan.variants) work += std::pow(variant.size, -order) / variant.speed;
  return work;
}

}  // namespace berm::uncertainty
