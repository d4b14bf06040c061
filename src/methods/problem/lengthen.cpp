// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/slices/coupled_line_lengthen_test.cpp
#include "problem/lengthen.hpp"

#include "bodies/fill.hpp"
#include "os/error.hpp"

#include <fmt/format.h>

namespace berm::problem {
namespace {

constexpr Real most_of_usual = 1.4;  ///< over the size of those of its cell, up to which a particle stays whole

/// The particles of a body on its new mesh.
template <int dim>
class Carrier {
public:
  Carrier(const bodies::BodySettings& body, const mesh::Mesh<dim>& mesh, std::int32_t numbered) : body_(body), mesh_(mesh), next_(numbered)
  {
    parents_.resize(static_cast<std::size_t>(numbered));
  }

  /// The particles of the mesh before, each whole, or divided among the places that particles of a new run have around it.
  void carry(const mesh::Mesh<dim>& before, const bodies::Particles<dim>& was, const bodies::Particles<dim>& fresh)
  {
    std::vector<std::vector<Vec<dim>>> places(parents_.size());
    std::vector<char> large(parents_.size(), 0);
    was.visit([&](Index cell, Index b, int l) {
      if (before.region_names[before.region[cell]] == "near") return;
      const bodies::Particle<dim> p = was.read(b, l);
      near_ = cell_at(p.x);
      large[static_cast<std::size_t>(p.id)] = p.volume > most_of_usual * usual_volume(near_);
    });
    Index cell = 0;
    fresh.visit([&](Index, Index b, int l) {
      const Vec<dim> x = fresh.read(b, l).x;
      const mesh::Location found = locate(before, x, cell);
      if (!found.inside) return;
      cell = found.cell;
      const std::int32_t id = nearest(before, was, cell, x);
      if (id != none && large[static_cast<std::size_t>(id)]) places[static_cast<std::size_t>(id)].push_back(x);
    });
    was.visit([&](Index, Index b, int l) { carry(was.read(b, l), places[static_cast<std::size_t>(was.block(b).id[l])]); });
  }

  /// A particle of the added length.
  void lay(bodies::Particle<dim> particle)
  {
    near_ = cell_at(particle.x);
    particle.id = next_++;
    add(particle, {});
  }

  std::vector<Parent<dim>>& parents() { return parents_; }
  std::int32_t numbered() const { return next_; }

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

  Real usual_volume(Index cell) const
  {
    return mesh_.volume(cell) / bodies::particles_per_cell<dim>(body_, mesh_.region_names[mesh_.region[cell]]);
  }

  /// The particle whose surroundings hold a place in a cell: where the square of the distance, over pi, exceeds its area least. None where that is far off.
  static std::int32_t nearest(const mesh::Mesh<dim>& mesh, const bodies::Particles<dim>& particles, Index cell, const Vec<dim>& x)
  {
    Real least = infinity;
    std::int32_t id = none;
    for (const Index node : mesh.nodes[cell])
      for (Index e = mesh.first_entry[node]; e < mesh.first_entry[node + 1]; ++e) {
        const Index other = mesh.entries[e] / (dim + 1);
        for (Index k = 0; k < particles.count_in(other); ++k) {
          const bodies::Particle<dim> p = particles.read_at(other, k);
          const Real excess = pi * (p.x - x).squaredNorm() - p.volume;
          if (excess < least) least = excess, id = excess < p.volume ? p.id : none;
        }
      }
    return id;
  }

  /// One particle, in parts as large as those of a new run at these places.
  void carry(const bodies::Particle<dim>& particle, const std::vector<Vec<dim>>& places)
  {
    near_ = cell_at(particle.x);
    if (places.size() < 2) return add(particle, {particle.id, Vec<dim>::Zero()});
    Real sum = 0;
    for (const Vec<dim>& place : places) sum += usual_volume(cell_at(place));
    for (std::size_t k = 0; k < places.size(); ++k) {
      bodies::Particle<dim> part = particle;
      const Real fraction = usual_volume(cell_at(places[k])) / sum;
      part.x = places[k];
      part.volume *= fraction;
      part.mass *= fraction;
      part.id = next_++;
      add(part, {particle.id, places[k] - particle.x});
    }
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
std::string not_to_lengthen(const Model<dim>& model)
{
  if (model.water_flows()) return "material: soil whose water flows";
  if (!model.load_points.empty()) return "traction: its points";
  if (!model.earthworks.empty()) return "fill, excavation: soil that is placed or taken out";
  if (!model.watches.empty()) return "watch: its points";
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    if (model.conditions.absorbs(static_cast<Index>(b))) return "support: the forces of a boundary that absorbs";
  return "";
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
    Carrier<dim> carrier(c.body[b].second, model.mesh, state.numbered[b]);
    carrier.carry(before.mesh, was, start);
    start.visit([&](Index, Index block, int lane) {
      if (const bodies::Particle<dim> p = start.read(block, lane); p.x[0] < left || p.x[0] > right) carrier.lay(p);
    });
    bed.state.particles[b] = carrier.particles(start.extra_fields());
    bed.state.numbered[b] = carrier.numbered();
    bed.parents.push_back(std::move(carrier.parents()));
  }
  return bed;
}

template std::string not_to_lengthen(const Model<2>&);
template std::string not_to_lengthen(const Model<3>&);
template LengthenedBed<2> lengthen(const settings::Case&, const Model<2>&, const State<2>&, const Model<2>&, const State<2>&);
template LengthenedBed<3> lengthen(const settings::Case&, const Model<3>&, const State<3>&, const Model<3>&, const State<3>&);

}  // namespace berm::problem
