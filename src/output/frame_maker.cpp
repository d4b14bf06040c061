// SPDX-License-Identifier: BSD-3-Clause
#include "output/frame_maker.hpp"

#include <algorithm>

namespace berm {
namespace {

/// Visits visit(block index, lane) for all particles of a body, whether or not its list of occupied cells is up to date.
template <int dim, class Visit>
void visit_all(const Particles<dim>& particles, Index cells, const Visit& visit)
{
  for (Index cell = 0; cell < cells; ++cell)
    for (Index left = particles.count_in(cell), b = particles.first_block(cell); left > 0; b = particles.block(b).next, left -= lanes)
      for (int l = 0; l < std::min<Index>(lanes, left); ++l) visit(b, l);
}

}  // namespace

template <int dim>
FrameMaker<dim>::FrameMaker(const Model<dim>& model, const State<dim>& start) : model_(model),
                                                                                first_(start.particles.size())
{
  for (std::size_t body = 0; body < start.particles.size(); ++body) {
    first_[body].reserve(static_cast<std::size_t>(start.particles[body].size()));
    visit_all<dim>(start.particles[body], model.mesh.cell_count(), [&](Index b, int l) {
      const Block<dim>& block = start.particles[body].block(b);
      const auto id = static_cast<std::size_t>(block.id[l]);
      if (first_[body].size() <= id) first_[body].resize(id + 1);
      for (int d = 0; d < dim; ++d) first_[body][id].x[d] = block.x[d][l];
      first_[body][id].strain = block.deviatoric_strain[l];
    });
  }
}

template <int dim>
Frame<dim> FrameMaker<dim>::make(const State<dim>& state)
{
  Frame<dim> frame;
  frame.time = state.time;
  std::size_t count = 0;
  for (const auto& of_body : first_) count += of_body.size();
  frame.particles.reserve(count);
  for (std::size_t body = 0; body < state.particles.size(); ++body) {
    const std::size_t offset = frame.particles.size();
    frame.particles.resize(offset + first_[body].size());
    visit_all<dim>(state.particles[body], model_.mesh.cell_count(), [&](Index b, int l) {
      const Particle<dim> p = state.particles[body].read(b, l);
      First& first = first_[body].at(static_cast<std::size_t>(p.id));
      frame.particles[offset + static_cast<std::size_t>(p.id)] = {p, static_cast<Index>(body), p.x - first.x,
                                                                  p.deviatoric_strain - first.strain};
      first.strain = p.deviatoric_strain;
    });
  }
  std::erase_if(frame.particles, [](const FrameParticle<dim>& f) { return f.particle.id == none; });
  frame.rigids = frame_rigids(model_, state.rigids);
  return frame;
}

template <int dim>
void FrameMaker<dim>::keep(Keep& k)
{
  for (std::size_t body = 0; body < first_.size(); ++body) {
    std::vector<Real> strains;
    for (const First& first : first_[body]) strains.push_back(first.strain);
    k.fixed("deviatoric_strain_" + std::to_string(body), strains);
    for (std::size_t id = 0; id < strains.size(); ++id) first_[body][id].strain = strains[id];
  }
}

template class FrameMaker<2>;
template class FrameMaker<3>;

}  // namespace berm
