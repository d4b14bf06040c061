// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame_maker.hpp"

#include <algorithm>

namespace berm::run_folder {
namespace {

/// Visits visit(cell, block index, lane) for all particles of a body, whether or not its list of occupied cells is up to date.
template <int dim, class Visit>
void visit_all(const bodies::Particles<dim>& particles, Index cells, const Visit& visit)
{
  for (Index cell = 0; cell < cells; ++cell)
    for (Index left = particles.count_in(cell), b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes)
      for (int l = 0; l < std::min<Index>(lanes, left); ++l) visit(cell, b, l);
}

template <int dim>
Vec<dim> position(const bodies::Block<dim>& block, int lane)
{
  Vec<dim> x;
  for (int d = 0; d < dim; ++d) x[d] = block.x[d][lane];
  return x;
}

}  // namespace

template <int dim>
FrameMaker<dim>::FrameMaker(const problem::Model<dim>& model, const problem::State<dim>& start)
    : model_(model),
      known_(start.particles.size())
{
  for (std::size_t body = 0; body < start.particles.size(); ++body) {
    std::vector<Known>& known = known_[body];
    known.reserve(static_cast<std::size_t>(start.particles[body].size()));
    visit_all<dim>(start.particles[body], model.mesh.cell_count(), [&](Index cell, Index b, int l) {
      const bodies::Block<dim>& block = start.particles[body].block(b);
      const auto id = static_cast<std::size_t>(block.id[l]);
      if (known.size() <= id) known.resize(id + 1);
      const Vec<dim> x = position<dim>(block, l);
      known[id] = {x, x, cell};
    });
  }
}

template <int dim>
Frame<dim> FrameMaker<dim>::make(const problem::State<dim>& state)
{
  Frame<dim> frame;
  frame.time = state.time;
  std::size_t count = 0;
  for (const auto& of_body : known_) count += of_body.size();
  frame.particles.reserve(count);
  for (std::size_t body = 0; body < state.particles.size(); ++body) {
    const std::size_t offset = frame.particles.size();
    frame.particles.resize(offset + known_[body].size());
    visit_all<dim>(state.particles[body], model_.mesh.cell_count(), [&](Index, Index b, int l) {
      const bodies::Particle<dim> p = state.particles[body].read(b, l);
      const Known& known = known_[body].at(static_cast<std::size_t>(p.id));
      frame.particles[offset + static_cast<std::size_t>(p.id)] = {p, static_cast<Index>(body), p.x - known.first, {}, 0};
    });
    add_strains(state.particles[body], known_[body], frame.particles.data() + offset);
  }
  std::erase_if(frame.particles, [](const FrameParticle<dim>& f) { return f.particle.id == none; });
  frame.rigid_bodies = frame_rigids(model_, state.rigid_bodies);
  return frame;
}

// The strain since the start is told from those that were neighbours at the start, whose lattice fits a gradient wherever they have gone; that since the
// frame before from those that are neighbours now. The latter's gradient is that of the way back, which has the same deviatoric strain.
template <int dim>
void FrameMaker<dim>::add_strains(const bodies::Particles<dim>& particles, std::vector<Known>& known, FrameParticle<dim>* shown) const
{
  NodalGradient<dim> since_start(model_.mesh), since_last(model_.mesh);
  for (std::size_t id = 0; id < known.size(); ++id)
    if (shown[id].particle.id != none) since_start.add(known[id].first_cell, known[id].first, shown[id].displacement);
  since_start.fit();
  for (std::size_t id = 0; id < known.size(); ++id)
    if (shown[id].particle.id != none)
      shown[id].strain = gradient_strain<dim>(Matrix<dim>::Identity() + since_start.at(known[id].first_cell, known[id].first));

  const auto visit_with_id = [&](const auto& visit) {
    visit_all<dim>(particles, model_.mesh.cell_count(), [&](Index cell, Index b, int l) {
      visit(cell, position<dim>(particles.block(b), l), static_cast<std::size_t>(particles.block(b).id[l]));
    });
  };
  visit_with_id([&](Index cell, const Vec<dim>& x, std::size_t id) { since_last.add(cell, x, known[id].last - x); });
  since_last.fit();
  visit_with_id([&](Index cell, const Vec<dim>& x, std::size_t id) {
    shown[id].strain_increment = gradient_strain<dim>(Matrix<dim>::Identity() + since_last.at(cell, x)).deviatoric;
    known[id].last = x;
  });
}

template <int dim>
void FrameMaker<dim>::archive(Archive& k)
{
  for (std::size_t body = 0; body < known_.size(); ++body)
    for (int d = 0; d < dim; ++d) {
      std::vector<Real> places;
      for (const Known& known : known_[body]) places.push_back(known.last[d]);
      k.fixed("position_" + std::to_string(d) + "_of_body_" + std::to_string(body), places);
      for (std::size_t id = 0; id < places.size(); ++id) known_[body][id].last[d] = places[id];
    }
}

template class FrameMaker<2>;
template class FrameMaker<3>;

}  // namespace berm::run_folder
