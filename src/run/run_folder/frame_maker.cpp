// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame_maker.hpp"

#include "bodies/particle_fields.hpp"
#include "bodies/particle_position.hpp"
#include "run_folder/gradient_strain.hpp"

#include <algorithm>

namespace berm::run_folder {
namespace {

/// Visits visit(cell, block index, lane) for all particles of a body, whether or not its list of occupied cells is up to date.
template <int dim, class Visit>
void visit_all(const bodies::Particles<dim>& particles, Index cells, const Visit& visit)
{
  for (Index cell = 0; cell < cells; ++cell)
    for (const auto& [block, b, count] : particles.blocks_in(cell))
      for (int l = 0; l < count; ++l) visit(cell, b, l);
}

/// The fields that a frame of these bodies has: the common ones, then those that only some of the bodies have, each once.
template <int dim>
std::vector<FieldInfo> fields_of(const problem::Model<dim>& model, const std::vector<bodies::Particles<dim>>& bodies)
{
  std::vector<FieldInfo> fields = common_fields<dim>(displacements_since(model.stages));
  for (const bodies::Particles<dim>& particles : bodies)
    for (const bodies::ExtraField& extra : particles.extra_fields()) {
      const bool known = std::any_of(fields.begin(), fields.end(), [&](const FieldInfo& info) { return info.name == extra.info.name; });
      if (extra.info.goes(to_frame) && !known) fields.push_back(extra.info);
    }
  if (std::any_of(model.bodies.begin(), model.bodies.end(),
                  [](const auto& body) { return has_pore_pressure(body.soil.materials.front()); })) {
    for (const FieldInfo& info : effective_stress_fields<dim>()) fields.push_back(info);
    if (model.gravity.norm() > 0) fields.push_back(pore_pressure_ratio_field());
  }
  if (std::any_of(model.bodies.begin(), model.bodies.end(), [](const auto& body) { return body.flows(); }))
    fields.push_back(water_flux_field<dim>());
  return fields;
}

/// A nodal field at a point of a cell.
template <int dim>
Vec<dim> interpolated(const mesh::Mesh<dim>& mesh, Index cell, const NodeField<Vec<dim>>& at_nodes, const Vec<dim>& x)
{
  const mesh::Shape<dim> shape = mesh.shape(cell);
  Vec<dim> value = Vec<dim>::Zero();
  for (int k = 0; k <= dim; ++k) value += shape.value(k, x) * at_nodes[mesh.nodes[cell][k]];
  return value;
}

/// Puts what particles carry into a frame.
template <int dim>
class CarriedFields {
public:
  CarriedFields(Frame<dim>& frame, const bodies::Particles<dim>& particles)
  {
    bodies::for_each_field<dim>([&](const auto& field) {
      if ((field.travel & to_frame) != 0) common_.push_back(&frame.field(field.name));
    });
    for (const bodies::ExtraField& extra : particles.extra_fields())
      if (extra.info.goes(to_frame)) extra_.emplace_back(&frame.field(extra.info.name), extra.offset);
  }

  void put(const bodies::Particle<dim>& p, std::size_t point) const
  {
    auto next = common_.begin();
    bodies::for_each_field<dim>([&](const auto& field) {
      if ((field.travel & to_frame) == 0) return;
      for (int c = 0; c < field.components; ++c) (*next)->at(point, c) = static_cast<Real>(field.of(p, c));
      ++next;
    });
    for (const auto& [shown, offset] : extra_)
      for (int c = 0; c < shown->info.components; ++c) shown->at(point, c) = p.extra[offset + c];
  }

private:
  std::vector<FieldValues<Real>*> common_;
  std::vector<std::pair<FieldValues<Real>*, int>> extra_;
};

}  // namespace

template <int dim>
FrameMaker<dim>::FrameMaker(const problem::Model<dim>& model, const problem::State<dim>& start)
    : model_(model),
      known_(start.particles.size()),
      zeros_(start.particles.size())
{
  for (std::size_t body = 0; body < start.particles.size(); ++body) {
    std::vector<Known>& known = known_[body];
    known.reserve(static_cast<std::size_t>(start.particles[body].size()));
    visit_all<dim>(start.particles[body], model.mesh.cell_count(), [&](Index cell, Index b, int l) {
      const bodies::Block<dim>& block = start.particles[body].block(b);
      const auto id = static_cast<std::size_t>(block.id[l]);
      if (known.size() <= id) known.resize(id + 1);
      const Vec<dim> x = position_of<dim>(block, l);
      known[id] = {x, x, cell};
    });
    at_start_.push_back(known.size());
  }
}

/// Remembers particles that came since the frame before.
template <int dim>
void FrameMaker<dim>::meet_new(const bodies::Particles<dim>& particles, std::size_t body)
{
  std::vector<Known>& known = known_[body];
  visit_all<dim>(particles, model_.mesh.cell_count(), [&](Index cell, Index b, int l) {
    const auto id = static_cast<std::size_t>(particles.block(b).id[l]);
    if (known.size() <= id) known.resize(id + 1);
    const Vec<dim> x = position_of<dim>(particles.block(b), l);
    if (known[id].first_cell == none) known[id] = {x, x, cell};
  });
  for (std::size_t id = zeros_[body].empty() ? known.size() : zeros_[body].size(); id < known.size(); ++id)
    zeros_[body].push_back({known[id].first, known[id].first_cell});
}

template <int dim>
typename FrameMaker<dim>::Zero FrameMaker<dim>::zero_of(std::size_t body, std::size_t id) const
{
  return zeros_[body].empty() ? Zero{known_[body][id].first, known_[body][id].first_cell} : zeros_[body][id];
}

template <int dim>
void FrameMaker<dim>::zero_displacements(const problem::State<dim>& state)
{
  for (std::size_t body = 0; body < known_.size(); ++body) {
    meet_new(state.particles[body], body);
    std::vector<Zero> zeros;
    for (std::size_t id = 0; id < known_[body].size(); ++id) zeros.push_back(zero_of(body, id));
    visit_all<dim>(state.particles[body], model_.mesh.cell_count(), [&](Index cell, Index b, int l) {
      const bodies::Block<dim>& block = state.particles[body].block(b);
      zeros[static_cast<std::size_t>(block.id[l])] = {position_of<dim>(block, l), cell};
    });
    zeros_[body] = std::move(zeros);
  }
}

template <int dim>
Frame<dim> FrameMaker<dim>::make(const problem::State<dim>& state, Frame<dim> old)
{
  Frame<dim> frame = std::move(old);
  frame.time = state.time;
  std::size_t count = 0;
  for (const bodies::Particles<dim>& particles : state.particles) count += static_cast<std::size_t>(particles.size());
  frame.allocate(count, fields_of(model_, state.particles));
  FieldValues<Real>&displacement = frame.field("displacement"), &mean_stress = frame.field("mean_stress");
  const bool undrained = find_field(frame.fields, "effective_stress") != nullptr;
  FieldValues<Real>* const effective = undrained ? &frame.field("effective_stress") : nullptr;
  FieldValues<Real>* const mean_effective = undrained ? &frame.field("mean_effective_stress") : nullptr;
  FieldValues<Real>* const ratio = undrained && model_.gravity.norm() > 0 ? &frame.field(pore_pressure_ratio_field().name) : nullptr;
  Index next = 0;
  for (std::size_t body = 0; body < state.particles.size(); ++body) {
    const bodies::Particles<dim>& particles = state.particles[body];
    meet_new(particles, body);
    std::vector<Index> point(known_[body].size(), none);  // by id
    visit_all<dim>(particles, model_.mesh.cell_count(),
                   [&](Index, Index b, int l) { point.at(static_cast<std::size_t>(particles.block(b).id[l])) = 0; });
    for (Index& k : point)
      if (k != none) k = next++;
    const CarriedFields<dim> carried(frame, particles);
    FieldValues<Real>* const flux = model_.bodies[body].flows() ? &frame.field("water_flux") : nullptr;
    visit_all<dim>(particles, model_.mesh.cell_count(), [&](Index cell, Index b, int l) {
      const bodies::Particle<dim> p = particles.read(b, l);
      const Index k = point[p.id];
      const Vec<dim> moved_by = p.x - zero_of(body, static_cast<std::size_t>(p.id)).place;
      frame.points[k] = p.x;
      frame.volume[k] = section_of(model_.mesh.metric, p.volume, p.x);
      frame.body[k] = static_cast<Index>(body);
      frame.id[k] = p.id;
      carried.put(p, k);
      for (int d = 0; d < dim; ++d) displacement.at(k, d) = moved_by[d];
      mean_stress.at(k) = trace(p.stress) / 3;
      if (flux != nullptr) {
        const Vec<dim> w = interpolated(model_.mesh, cell, state.flux[body], p.x);
        for (int d = 0; d < dim; ++d) flux->at(k, d) = w[d];
      }
      if (effective == nullptr) return;
      const material::Material& material = model_.bodies[body].soil.materials.front();
      const SymTensor<dim> stress = effective_stress(material, p.stress, p.extra);
      for (int s = 0; s < tensor_size<dim>; ++s) effective->at(k, s) = stress[s];
      mean_effective->at(k) = trace(stress) / 3;
      const int pressure = pore_pressure_index(material);
      if (ratio == nullptr || pressure == none) return;
      const Known& known = known_[body][p.id];
      const std::string& region = model_.mesh.region_names[model_.mesh.region[known.first_cell]];
      const Real at_rest = overburden(model_, static_cast<Index>(body), region, model_.soil_place(known.first));
      if (at_rest > 0) ratio->at(k) = p.extra[pressure] / at_rest;
    });
    add_strains(particles, body, point, frame);
  }
  frame.rigid_bodies = frame_rigids(model_, state.rigid_bodies);
  return frame;
}

// The strain since the start (or since displacements count) is computed from those that were neighbours then, whose lattice fits a gradient wherever they have gone; that since the
// frame before from those that are neighbours now. The latter's gradient is that of the way back, which has the same deviatoric strain.
template <int dim>
void FrameMaker<dim>::add_strains(const bodies::Particles<dim>& particles, std::size_t body, const std::vector<Index>& point,
                                  Frame<dim>& frame)
{
  std::vector<Known>& known = known_[body];
  const FieldValues<Real>& displacement = frame.field("displacement");
  FieldValues<Real>&deviatoric = frame.field("deviatoric_strain"), &volumetric = frame.field("volumetric_strain"),
  &increment = frame.field("incremental_deviatoric_strain");
  NodalGradient<dim> since_start(model_.mesh), since_last(model_.mesh);
  const bool around_axis = model_.mesh.metric == mesh::Metric::axisymmetric;
  const auto stretch_around = [&](const Vec<dim>& from, Real to) { return around_axis ? to / from[0] : 1; };
  for (std::size_t id = 0; id < known.size(); ++id) {
    if (point[id] == none) continue;
    Vec<dim> moved_by;
    for (int d = 0; d < dim; ++d) moved_by[d] = displacement.at(point[id], d);
    const Zero zero = zero_of(body, id);
    since_start.add(zero.cell, zero.place, moved_by);
  }
  since_start.fit();
  for (std::size_t id = 0; id < known.size(); ++id) {
    if (point[id] == none) continue;
    const Zero zero = zero_of(body, id);
    const GradientStrain strain = gradient_strain<dim>(Matrix<dim>::Identity() + since_start.at(zero.cell, zero.place),
                                                       stretch_around(zero.place, zero.place[0] + displacement.at(point[id], 0)));
    deviatoric.at(point[id]) = strain.deviatoric;
    volumetric.at(point[id]) = strain.volumetric;
  }

  const auto visit_with_id = [&](const auto& visit) {
    visit_all<dim>(particles, model_.mesh.cell_count(), [&](Index cell, Index b, int l) {
      visit(cell, position_of<dim>(particles.block(b), l), static_cast<std::size_t>(particles.block(b).id[l]));
    });
  };
  visit_with_id([&](Index cell, const Vec<dim>& x, std::size_t id) { since_last.add(cell, x, known[id].last - x); });
  since_last.fit();
  visit_with_id([&](Index cell, const Vec<dim>& x, std::size_t id) {
    increment.at(point[id]) =
        gradient_strain<dim>(Matrix<dim>::Identity() + since_last.at(cell, x), stretch_around(x, known[id].last[0])).deviatoric;
    known[id].last = x;
  });
}

/// Where particles were first that came after the start, the first `at_start` of the list.
template <int dim>
void FrameMaker<dim>::archive_new(Archive& k, const std::string& ending, std::size_t at_start, std::vector<Known>& known) const
{
  std::vector<Index> cells;
  for (std::size_t id = at_start; id < known.size(); ++id) cells.push_back(known[id].first_cell);
  k("first_cell" + ending, cells);
  known.resize(at_start + cells.size());
  for (int d = 0; d < dim; ++d) {
    std::vector<Real> places;
    for (std::size_t n = 0; n < cells.size(); ++n) places.push_back(known[at_start + n].first[d]);
    k.fixed("first_" + std::to_string(d) + ending, places);
    for (std::size_t n = 0; n < cells.size(); ++n) known[at_start + n].first[d] = places[n];
  }
  for (std::size_t n = 0; n < cells.size(); ++n) {
    if (cells[n] < none || cells[n] >= model_.mesh.cell_count()) k.refuse("the mesh has no cell " + std::to_string(cells[n]));
    known[at_start + n].first_cell = cells[n];
  }
}

/// Where displacements count from: empty before a stage that says so.
template <int dim>
void FrameMaker<dim>::archive_zeros(Archive& k, const std::string& ending, std::size_t body)
{
  std::vector<Index> cells;
  for (const Zero& zero : zeros_[body]) cells.push_back(zero.cell);
  k("zero_cell" + ending, cells);
  if (!cells.empty() && cells.size() != known_[body].size()) k.refuse("there are not as many displacements as particles");
  zeros_[body].resize(cells.size());
  for (int d = 0; d < dim; ++d) {
    std::vector<Real> places;
    for (const Zero& zero : zeros_[body]) places.push_back(zero.place[d]);
    k.fixed("zero_" + std::to_string(d) + ending, places);
    for (std::size_t id = 0; id < places.size(); ++id) zeros_[body][id].place[d] = places[id];
  }
  for (std::size_t id = 0; id < cells.size(); ++id) {
    if (cells[id] < none || cells[id] >= model_.mesh.cell_count()) k.refuse("the mesh has no cell " + std::to_string(cells[id]));
    zeros_[body][id].cell = cells[id];
  }
}

template <int dim>
Index FrameMaker<dim>::cell_at(const Vec<dim>& x, Index near) const
{
  return locate(model_.mesh, x, near == none ? 0 : near).cell;
}

template <int dim>
void FrameMaker<dim>::lengthen(const FrameMaker& before, const problem::LengthenedBed<dim>& bed)
{
  for (std::size_t body = 0; body < known_.size(); ++body) {
    const std::vector<problem::Parent<dim>>& parents = bed.parents[body];
    known_[body].assign(parents.size(), Known());
    Index near = 0;
    for (std::size_t id = 0; id < parents.size(); ++id) {
      if (parents[id].id == none) continue;
      const Known& was = before.known_[body][static_cast<std::size_t>(parents[id].id)];
      const Vec<dim> first = was.first + parents[id].offset;
      known_[body][id] = {first, was.last + parents[id].offset, near = cell_at(first, near)};
    }
    zeros_[body].clear();
    meet_new(bed.state.particles[body], body);  // those of the added length
    if (before.zeros_[body].empty()) continue;
    std::vector<Zero> zeros;
    for (std::size_t id = 0; id < parents.size(); ++id) {
      zeros.push_back(zero_of(body, id));
      if (parents[id].id == none) continue;
      const Vec<dim> place = before.zeros_[body][static_cast<std::size_t>(parents[id].id)].place + parents[id].offset;
      zeros.back() = {place, cell_at(place, zeros.back().cell)};
    }
    zeros_[body] = std::move(zeros);
  }
}

template <int dim>
void FrameMaker<dim>::archive(Archive& k, bool lengthened)
{
  for (std::size_t body = 0; body < known_.size(); ++body) {
    std::vector<Known>& known = known_[body];
    const std::string ending = "_of_body_" + std::to_string(body);
    if (lengthened)
      archive_new(k, ending, 0, known);
    else if (!model_.earthworks.empty())
      archive_new(k, ending, at_start_[body], known);
    for (int d = 0; d < dim; ++d) {
      std::vector<Real> places;
      for (const Known& particle : known) places.push_back(particle.last[d]);
      k.fixed("position_" + std::to_string(d) + ending, places);
      for (std::size_t id = 0; id < places.size(); ++id) known[id].last[d] = places[id];
    }
    if (!displacements_since(model_.stages).empty()) archive_zeros(k, ending, body);
  }
}

template class FrameMaker<2>;
template class FrameMaker<3>;

}  // namespace berm::run_folder
