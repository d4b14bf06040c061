// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/earthworks_test.cpp
#include "problem/earthworks.hpp"

#include "bodies/fill.hpp"
#include "core/names.hpp"
#include "os/error.hpp"
#include "problem/fill_room.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::problem {
namespace {

/// Of the lifts from `first` to before `end`.
template <int dim>
Slab slab_of(const Earthwork<dim>& work, Index first, Index end)
{
  const auto level = [&](Index lift) { return work.bottom + (work.top - work.bottom) * static_cast<Real>(lift) / work.lifts; };
  return work.fills ? Slab{level(first), level(end)} : Slab{level(work.lifts - end), level(work.lifts - first)};
}

template <int dim>
Index lifts_due(const Earthwork<dim>& work, const State<dim>& state)
{
  if (state.stage.index < work.stage) return 0;
  if (state.stage.index > work.stage || work.duration == 0) return work.lifts;
  const Real passed = (state.time - state.stage.begin_time) / work.duration * work.lifts;
  return passed < work.lifts ? 1 + static_cast<Index>(passed) : work.lifts;
}

/// The highest level of the area at x, m.
template <int dim>
Real top_at(const Earthwork<dim>& work, Real x)
{
  Real top = work.bottom;
  for (std::size_t k = 0; k < work.corners.size(); ++k) {
    const Vec<2>&a = work.corners[k], &b = work.corners[(k + 1) % work.corners.size()];
    if (std::min(a[0], b[0]) > x || std::max(a[0], b[0]) < x) continue;
    top = std::max(top, a[0] == b[0] ? std::max(a[1], b[1]) : a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]));
  }
  return top;
}

/// Points of a cell where particles of a fill would be, but for what is there already.
template <int dim>
std::vector<Vec<dim>> points_in(const WorkRegion<dim>& region, Index cell, const bodies::CellPoints<dim>& points)
{
  std::vector<Vec<dim>> inside;
  for (int k = 0; k < points.count(); ++k)
    if (const Vec<dim> x = points.at(region.model.mesh, cell, k); region.holds(x)) inside.push_back(x);
  return inside;
}

template <int dim>
std::vector<bodies::CellPoints<dim>> points_of_regions(const Earthwork<dim>& work)
{
  return {work.per_cell.begin(), work.per_cell.end()};
}

/// What an earthwork does in a cell.
template <int dim>
struct InCell {
  Index cell;
  Index particles = 0;
  Real volume = 0, mass = 0, kinetic = 0;
  Vec<dim> momentum = Vec<dim>::Zero();

  void add(const bodies::Particle<dim>& p)
  {
    ++particles;
    volume += p.volume;
    mass += p.mass;
    momentum += p.mass * p.v;
    kinetic += p.mass * p.v.squaredNorm() / 2;
  }
};

/// Of all ranks, in the order of their cells.
template <int dim>
std::vector<InCell<dim>> gathered(const std::vector<InCell<dim>>& own)
{
  std::vector<InCell<dim>> of_all;
  Ranks::of_run().gather(own, of_all);
  return of_all;
}

template <int dim>
std::vector<InCell<dim>> take_out(const Model<dim>& model, const Earthwork<dim>& work, const Slab& slab, bodies::Particles<dim>& particles)
{
  std::vector<InCell<dim>> done;
  const WorkRegion<dim> region{model, work, slab};
  const std::vector<Index> cells = particles.occupied();
  for (const Index cell : cells) {
    if (!comes_near(model, work, slab, cell)) continue;
    InCell<dim> here{cell};
    for (Index index = particles.count_in(cell); index-- > 0;)
      if (region.holds(particles.read_at(cell, index).x)) here.add(particles.take(cell, index));
    if (here.particles > 0) done.push_back(here);
  }
  return gathered(done);
}

/// A particle of a fill, without a number.
template <int dim>
bodies::Particle<dim> particle_at(const Model<dim>& model, const Earthwork<dim>& work, const Slab& slab, const Vec<dim>& x, Real section)
{
  const settings::BodySoil& soil = model.bodies[work.body].soil;
  const Real top = top_at(work, x[0]);
  const material::Material material = soil.in_fill(work.material, std::max(Real(0), top - x[1]));
  bodies::Particle<dim> p;
  p.x = x;
  p.volume = section * weight_at(model.mesh.metric, x);
  p.mass = inertia_density(material) * p.volume;
  SymTensor<3> stress{};
  if (work.k0) {
    p.stress[1] = density(material) * model.gravity[1] * std::max(Real(0), std::min(top, slab.top) - x[1]);
    p.stress[0] = p.stress[2] = *work.k0 * p.stress[1];
    std::copy_n(p.stress.c, tensor_size<dim>, stress.c);
  }
  initial_state(material, stress, p.extra);
  const std::vector<Real> own = local_values(soil, work.material, material);
  std::copy(own.begin(), own.end(), p.extra + state_size(material));
  return p;
}

/// By which the particles that were found are to be larger so that a lift has its volume; 0: there is next to no room. Within a hundredth they stay as they are; at most twice as large.
Real growth_of(Real wanted, Real found)
{
  constexpr Real a_hundredth = 0.01, least = 0.1, most = 2;
  if (wanted < least * found) return 0;
  return std::abs(wanted - found) <= a_hundredth * found ? 1 : std::min(wanted / found, most);
}

template <int dim>
std::vector<InCell<dim>> place(const Model<dim>& model, const Earthwork<dim>& work, const Slab& slab, State<dim>& state,
                               EarthworkState<dim>& so_far)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  bodies::Particles<dim>& particles = state.particles[work.body];
  if (so_far.lifts == 0) so_far.first = state.numbered[work.body];
  WorkRegion<dim> lift{model, work, slab};
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r) lift.holes.push_back(placed(model.rigid_bodies[r], state.rigid_bodies[r]));
  WorkRegion<dim> up_to_it = lift;
  up_to_it.slab.bottom = work.bottom;
  const auto points = points_of_regions(work);
  const SoilAround<dim> around(state, up_to_it, so_far.first);
  std::vector<InCell<dim>> done;
  std::vector<std::pair<Index, bodies::Particle<dim>>> made;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    if (!Ranks::of_run().owns_cell(cell) || !comes_near(model, work, slab, cell)) continue;
    const auto& of_cell = points[mesh.region[cell]];
    const Real section = mesh.section(cell) / of_cell.count();
    InCell<dim> here{cell};
    for (const Vec<dim>& x : points_in(lift, cell, of_cell)) {
      if (!around.has_room(cell, x, section)) continue;
      made.emplace_back(cell, particle_at(model, work, slab, x, section));
      here.add(made.back().second);
    }
    if (here.particles > 0) done.push_back(here);
  }
  std::vector<InCell<dim>> of_all = gathered(done);
  Real found = 0;
  for (const InCell<dim>& cell : of_all) found += cell.volume;
  const Real wanted = std::max(Real(0), up_to_it.volume() - around.volume_in_region()), growth = growth_of(wanted, found);
  so_far.room = so_far.volume + wanted;
  if (growth == 0) return {};
  for (auto& [cell, particle] : made) particle.volume *= growth, particle.mass *= growth;
  for (InCell<dim>& cell : of_all) cell.volume *= growth, cell.mass *= growth;
  // Numbers go on in the order of the cells, whichever rank has them.
  std::int32_t next = state.numbered[work.body];
  for (const InCell<dim>& cell : of_all) {
    if (!done.empty() && cell.cell == done.front().cell) break;
    next += cell.particles;
  }
  for (auto& [cell, particle] : made) {
    particle.id = next++;
    particles.insert(cell, particle);
  }
  for (const InCell<dim>& cell : of_all) state.numbered[work.body] += cell.particles;
  return of_all;
}

template <int dim>
void count(const std::vector<InCell<dim>>& done, Real weight_over_mass, EarthworkState<dim>& sum)
{
  for (const InCell<dim>& cell : done) {
    sum.particles += cell.particles;
    sum.volume += cell.volume;
    sum.mass += weight_over_mass * cell.mass;
    sum.momentum += cell.momentum;
    sum.kinetic += cell.kinetic;
  }
}

/// How many particles a fill can need.
template <int dim>
Index room_for(const Model<dim>& model, const Earthwork<dim>& fill)
{
  Index room = 0;
  const auto points = points_of_regions(fill);
  const WorkRegion<dim> region{model, fill, slab_of(fill, 0, fill.lifts)};
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell)
    if (comes_near(model, fill, region.slab, cell))
      room += static_cast<Index>(points_in(region, cell, points[model.mesh.region[cell]]).size());
  return room;
}

}  // namespace

template <int dim>
void add_earthworks(const bodies::BodySettings& settings, Index body, Model<dim>& model)
{
  const auto add = [&](const bodies::EarthworkSettings& work, bool fills) {
    const auto stage = std::find_if(model.stages.begin(), model.stages.end(),
                                    [&](const settings::StageSettings& candidate) { return candidate.name == work.stage; });
    Earthwork<dim> made{work.name,
                        fills,
                        body,
                        static_cast<Index>(stage - model.stages.begin()),
                        bodies::make_shape<dim>(work.area),
                        {},
                        {-infinity, infinity},
                        infinity,
                        -infinity,
                        work.lifts,
                        work.duration};
    for (std::size_t k = 0; k < work.area.x.size(); ++k) made.corners.emplace_back(work.area.x[k], work.area.y[k]);
    for (const Vec<2>& corner : made.corners) made.bottom = std::min(made.bottom, corner[1]), made.top = std::max(made.top, corner[1]);
    if (!work.z_range.empty()) made.z_range = {work.z_range[0], work.z_range[1]};
    model.earthworks.push_back(made);
  };
  for (const bodies::ExcavationSettings& excavation : settings.excavation) add(excavation, false);
  for (std::size_t k = 0; k < settings.fill.size(); ++k) {
    add(settings.fill[k], true);
    Earthwork<dim>& work = model.earthworks.back();
    work.material = model.bodies[body].soil.of_fill[k];
    work.k0 = settings.fill[k].k0;
    for (const std::string& region : model.mesh.region_names) work.per_cell.push_back(bodies::particles_per_cell<dim>(settings, region));
    if (work.top > model.mesh.upper[1])
      throw KeyError(
          fmt::format("body.{}.fill[{}].y: reaches y = {:.4g} m, and the mesh ends at {:.4g} m: draw it lower, or make the mesh higher",
                      model.bodies[body].name, k, work.top, model.mesh.upper[1]));
    if (room_for(model, work) == 0)
      throw KeyError(fmt::format("body.{}.fill[{}].x: no cell of the mesh is there", model.bodies[body].name, k));
  }
}

template <int dim>
Index room_for_fills(const Model<dim>& model, Index body)
{
  Index room = 0;
  for (const Earthwork<dim>& work : model.earthworks)
    if (work.fills && work.body == body) room += room_for(model, work);
  return room;
}

template <int dim>
Real mass_of_room(const Model<dim>& model, const Earthwork<dim>& fill, const EarthworkState<dim>& so_far)
{
  const Body<dim>& body = model.bodies[fill.body];
  return body.weight_over_mass * inertia_density(body.soil.in_fill(fill.material, 0)) * so_far.room;
}

template <int dim>
bool carry_out_earthworks(const Model<dim>& model, State<dim>& state)
{
  bool changed = false;
  for (std::size_t k = 0; k < model.earthworks.size(); ++k) {
    const Earthwork<dim>& work = model.earthworks[k];
    EarthworkState<dim>& so_far = state.earthworks[k];
    const Index due = lifts_due(work, state);
    if (so_far.lifts >= due) continue;
    const Slab slab = slab_of(work, so_far.lifts, due);
    bodies::Particles<dim>& particles = state.particles[work.body];
    const std::vector<InCell<dim>> done = work.fills ? place(model, work, slab, state, so_far) : take_out(model, work, slab, particles);
    count(done, model.bodies[work.body].weight_over_mass, so_far);
    so_far.lifts = due;
    particles.sort_occupied();
    changed = true;
  }
  return changed;
}

template <int dim>
EarthworkState<dim> taken_out(const State<dim>& state)
{
  EarthworkState<dim> sum;
  for (const EarthworkState<dim>& work : state.earthworks) sum.momentum += work.momentum, sum.kinetic += work.kinetic;
  return sum;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void add_earthworks(const bodies::BodySettings&, Index, Model<dim>&);                                                           \
  template Index room_for_fills(const Model<dim>&, Index);                                                                                 \
  template Real mass_of_room(const Model<dim>&, const Earthwork<dim>&, const EarthworkState<dim>&);                                        \
  template bool carry_out_earthworks(const Model<dim>&, State<dim>&);                                                                      \
  template EarthworkState<dim> taken_out(const State<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::problem
