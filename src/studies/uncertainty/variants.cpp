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

constexpr Real cells_across = 5;      // the driven body at least: fewer tell nothing (examples/mesh_study)
constexpr Real coarse_across = 6.4;   // in the plane, where coarser ones are off the line of the others (examples/mesh_patterns)
constexpr Real resolved_across = 16;  // with which the case is fine enough to be the finest of its runs
constexpr Real finer = 0.5;           // the finest run of a case that is not
constexpr Real coarsest_of_finest = 3, coarsest_of_halved = 1.5;  // over the cells of the case
constexpr Real least_coarsest = 1.6;         // of a case that is the finest, below which the runs differ by less than meshes do
constexpr Real least_growth = 1.25;          // from the case to the coarsest run, below which a run between them and the finest tells more
constexpr Real rounding = 1e-9;              // of D/8, which is D/7.9999... in some units
constexpr Real grains[] = {0.1e-3, 0.5e-3};  // m, d50 of fine sand, and of medium to coarse sand

void scale_cells(mesh::SeabedMesh& bed, Real times)
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
Real scale_cells(mesh::BoxMesh& box, Real times)
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
    if (band_width(soil)) continue;
    material::Material with = material::with_grain_size(soil, d50);
    const std::optional<Real> width = band_width(with);
    if (!width || *width >= material::cells_of_band * base::near_cell_size(c)) continue;
    soil = std::move(with);
    changed = true;
  }
  return changed ? std::optional(std::move(c)) : std::nullopt;
}

std::string name_of_size(Real size)
{
  return fmt::format("cells_{:.3g}", size);
}

/// How much coarser cells may be until they are as large as the layer along walls and base.
Real largest_in_layer(const settings::Case& c)
{
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  return bed != nullptr && bed->layer > 0 ? bed->layer / bed->near_size : infinity;
}

/// Refuses a case of which no bands can be made, whatever its cells are. Throws KeyError.
void check_kind(const settings::Case& c)
{
  if (!base::drives_a_body(c))
    throw KeyError("stage: --uncertainty needs a push or a drag of a body with a width: there are no key results without");
  if (std::holds_alternative<mesh::GmshFile>(c.mesh))
    throw KeyError(
        "mesh.file: --uncertainty changes the size of all cells, which it cannot do with a mesh from a file; let berm make the mesh "
        "(mesh.kind = \"seabed\" or \"box\"), or compare meshes of your own with berm study");
}

/// How many cells the driven body is wide.
Real cells_across_body(const settings::Case& c)
{
  return base::body_scale(c).width / base::near_cell_size(c);
}

/// Refuses a case whose coarsest run would have fewer than five cells across the body, `ratio` times as large as its own. Throws KeyError.
void check_cells(const settings::Case& c, Real ratio)
{
  const Real width = base::body_scale(c).width, across = cells_across_body(c);
  if (across >= cells_across * ratio * (1 - rounding)) return;
  throw KeyError(
      fmt::format("{}: {}, and the driven body is only {:.2g} cells wide: make them {:.3g} m or smaller, so that {:g} coarse ones remain",
                  c.method == settings::Method::fem && c.fem.contact_size ? "fem.contact_size"
                  : std::holds_alternative<mesh::BoxMesh>(c.mesh)         ? "mesh.cells"
                                                                          : "mesh.near_size",
                  ratio > 1 ? fmt::format("--uncertainty makes cells {:g} times as large at least", ratio)
                            : "--uncertainty needs cells that resolve the body",
                  across, width / (cells_across * ratio), cells_across));
}

/// Sizes of the runs beside that of the case, over its cells: the finest first.
struct Sizes {
  std::vector<Real> all;
  Real repeated;  ///< of the run at another speed
};

/// A case in the plane or around an axis that does not see its body well is joined by one of half the cells; others are the finest of their runs. Throws KeyError.
Sizes sizes_of(const settings::Case& c)
{
  check_kind(c);
  const Real across = cells_across_body(c), in_layer = largest_in_layer(c);
  const auto at_most = [&](Real ratio) {
    return std::min({ratio, across / (c.dimension() == 2 ? coarse_across : cells_across), in_layer});
  };
  if (c.dimension() == 2 && across < resolved_across * (1 - rounding)) {
    check_cells(c, 1);
    const Real coarsest = at_most(coarsest_of_halved);
    if (coarsest < least_growth * (1 - rounding)) return {{finer, std::sqrt(finer)}, 1};
    return {{finer, coarsest}, coarsest};
  }
  if (in_layer < least_coarsest)
    throw KeyError(fmt::format(
        "mesh.layer: --uncertainty makes cells {:g} times as large at least, and the layer along walls and base must not be thinner than a "
        "cell of the fine zone: make it {:.3g} m or thicker, near_size smaller, or leave it out",
        least_coarsest, least_coarsest * std::get<mesh::SeabedMesh>(c.mesh).near_size));
  check_cells(c, least_coarsest);
  const Real coarsest = std::max(at_most(coarsest_of_finest), least_coarsest);
  return {{std::max(std::sqrt(coarsest), coarsest / std::sqrt(Real(2))), coarsest}, coarsest};
}

/// The case with its drives at another pace on cells of that size; of finite elements with longer increments. Empty where its soil knows speed.
std::optional<Variant> at_another_pace(const settings::Case& c, Real size)
{
  const std::string name = name_of_size(size);
  if (c.method == settings::Method::fem) {
    settings::Case longer = c;
    longer.fem.largest_step *= 2;
    if (c.fem.large_deformation) longer.fem.remeshing_travel = std::min(Real(1), 2 * longer.fem.remeshing_travel);  // limits them, too
    longer.fem.relaxation *= 4;  // its error grows with the root (examples/wip_pipe): this doubles it
    return Variant{name + "_long_steps", size, 2, std::move(longer)};
  }
  if (knows_speed(c)) return std::nullopt;
  return Variant{name + "_fast", size, 2, at_twice_the_speed(c)};
}

}  // namespace

std::pair<settings::Case, Real> with_other_cells(settings::Case c, Real times)
{
  Real size = times;
  if (auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) scale_cells(*bed, times);
  if (auto* box = std::get_if<mesh::BoxMesh>(&c.mesh)) size = scale_cells(*box, times);
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
  const Sizes sizes = sizes_of(c);
  VariantPlan plan;
  for (const Real wanted : sizes.all) {
    auto [settings, size] = with_other_cells(c, wanted);
    const auto same = [size = size](const Variant& other) { return std::abs(other.size - size) < 1e-9; };
    if (std::ranges::any_of(plan.variants, same) || size == 1)
      throw KeyError("mesh.cells: --uncertainty cuts the box into other numbers of cells, and here are too few to be different: make more");
    plan.variants.push_back({name_of_size(size), size, 1, std::move(settings)});
  }
  const auto& [settings, size] = sizes.repeated == 1 ? std::pair(with_other_cells(c, 1).first, Real(1))
                                                     : std::pair(plan.variants.back().settings, plan.variants.back().size);
  if (std::optional<Variant> other = at_another_pace(settings, size))
    plan.variants.push_back(*std::move(other));
  else
    plan.left_out.emplace_back("speed: the strength of the soil depends on it");
  for (const Real d50 : grains)
    if (std::optional<settings::Case> with = with_grain_size(settings, d50))
      plan.variants.push_back({fmt::format("{}_d50_{:g}_mm", name_of_size(size), 1000 * d50), size, 1, *std::move(with), d50});
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
