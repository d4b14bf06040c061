// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/slices/lengthen_test.cpp
#include "problem/lengthen.hpp"

#include "bodies/fill.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::problem {
namespace {

constexpr int most_halvings = 12;

/// The particles of a body on its new mesh.
template <int dim>
class Carrier {
public:
  Carrier(const bodies::BodySettings& body, const mesh::Mesh<dim>& mesh, std::int32_t numbered) : body_(body), mesh_(mesh), next_(numbered)
  {
    parents_.resize(static_cast<std::size_t>(numbered));
  }

  /// A particle of the mesh before, whole or in parts.
  void carry(const bodies::Particle<dim>& particle)
  {
    near_ = cell_at(particle.x);
    const int halvings = halvings_of(particle);
    const int columns = 1 << (halvings + 1) / 2, rows = 1 << halvings / 2, parts = columns * rows;
    bodies::Particle<dim> part = particle;
    part.volume /= parts;
    part.mass /= parts;
    const Real side = std::sqrt(particle.volume);
    for (int k = 0; k < parts; ++k) {
      Vec<dim> offset = Vec<dim>::Zero();
      offset[0] = side * ((k % columns + Real(0.5)) / columns - Real(0.5));
      offset[1] = side * ((k / columns + Real(0.5)) / rows - Real(0.5));
      if (parts == 1 || !is_soil(particle.x + offset) || !is_soil(particle.x - offset)) offset.setZero();
      part.x = particle.x + offset;
      part.id = k == 0 ? particle.id : next_++;
      add(part, {particle.id, offset});
    }
  }

  /// A particle of the added length.
  void lay(bodies::Particle<dim> particle)
  {
    near_ = cell_at(particle.x);
    particle.id = next_++;
    add(particle, {});
  }

  std::vector<Parent<dim>>& parents() { return parents_; }

  bodies::Particles<dim> particles(const std::vector<bodies::ExtraField>& extra) const
  {
    std::vector<FieldInfo> fields;
    for (const bodies::ExtraField& field : extra) fields.push_back(field.info);
    bodies::Particles<dim> all(mesh_, next_, fields);
    for (const auto& [cell, particle] : placed_) all.insert(cell, particle);
    all.sort_occupied();
    return all;
  }

private:
  Index cell_at(const Vec<dim>& x)
  {
    const mesh::Location found = locate(mesh_, x, near_);
    if (!found.inside) throw RunError(fmt::format("the longer mesh has no cell at ({}, {}), where there is soil", x[0], x[1]));
    return found.cell;
  }

  /// Whether a place lies in a region that the body fills, or its whole is above the bed.
  bool is_soil(const Vec<dim>& x) const
  {
    const mesh::Location found = locate(mesh_, x, near_);
    return found.inside && fills(found.cell) == fills(near_);
  }
  bool fills(Index cell) const
  {
    const std::string& region = mesh_.region_names[mesh_.region[cell]];
    return std::find(body_.regions.begin(), body_.regions.end(), region) != body_.regions.end();
  }

  /// How often a particle is halved to come next to the size of those of its cell.
  int halvings_of(const bodies::Particle<dim>& particle) const
  {
    const Real usual = mesh_.volume(near_) / bodies::particles_per_cell<dim>(body_, mesh_.region_names[mesh_.region[near_]]);
    return std::clamp(static_cast<int>(std::lround(std::log2(particle.volume / usual))), 0, most_halvings);
  }

  void add(const bodies::Particle<dim>& particle, const Parent<dim>& parent)
  {
    placed_.emplace_back(cell_at(particle.x), particle);
    parents_.resize(static_cast<std::size_t>(next_));
    parents_[static_cast<std::size_t>(particle.id)] = parent;
  }

  const bodies::BodySettings& body_;
  const mesh::Mesh<dim>& mesh_;
  std::int32_t next_;  ///< number of the next new particle
  Index near_ = 0;     ///< the cell of the particle in hand
  std::vector<std::pair<Index, bodies::Particle<dim>>> placed_;
  std::vector<Parent<dim>> parents_;
};

}  // namespace

template <int dim>
void refuse_to_lengthen(const Model<dim>& model)
{
  const auto refuse = [](bool has, const char* key, const char* what) {
    if (has) throw KeyError(fmt::format("{}: {} cannot be carried to a longer mesh: begin a new run on it", key, what));
  };
  refuse(model.water_flows(), "material", "soil whose water flows");
  refuse(!model.load_points.empty(), "traction", "the points of a traction");
  refuse(!model.earthworks.empty(), "body", "fills and excavations");
  refuse(!model.watches.empty(), "watch", "watched points");
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    refuse(model.conditions.absorbs(static_cast<Index>(b)), "absorbing", "the forces of a boundary that absorbs");
}

template <int dim>
LengthenedBed<dim> lengthen(const settings::Case& c, const Model<dim>& before, const State<dim>& state, const Model<dim>& model,
                            const State<dim>& fresh)
{
  LengthenedBed<dim> bed{state, {}};
  bed.state.lengthened = true;
  bed.state.stable_dt_holds = false;
  bed.state.listed_poses = fresh.listed_poses;
  const Real left = before.mesh.lower[0], right = before.mesh.upper[0];
  for (std::size_t b = 0; b < state.particles.size(); ++b) {
    const bodies::Particles<dim>&was = state.particles[b], &start = fresh.particles[b];
    Carrier<dim> carrier(c.body[b].second, model.mesh, was.size());
    was.visit([&](Index, Index block, int lane) { carrier.carry(was.read(block, lane)); });
    start.visit([&](Index, Index block, int lane) {
      if (const bodies::Particle<dim> p = start.read(block, lane); p.x[0] < left || p.x[0] > right) carrier.lay(p);
    });
    bed.state.particles[b] = carrier.particles(start.extra_fields());
    bed.state.numbered[b] = bed.state.particles[b].size();
    bed.parents.push_back(std::move(carrier.parents()));
  }
  return bed;
}

template void refuse_to_lengthen(const Model<2>&);
template void refuse_to_lengthen(const Model<3>&);
template LengthenedBed<2> lengthen(const settings::Case&, const Model<2>&, const State<2>&, const Model<2>&, const State<2>&);
template LengthenedBed<3> lengthen(const settings::Case&, const Model<3>&, const State<3>&, const Model<3>&, const State<3>&);

}  // namespace berm::problem
