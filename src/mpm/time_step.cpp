// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/time_step.hpp"

#include "core/error.hpp"
#include "core/for_each.hpp"

#include <fmt/format.h>

namespace berm {

template <int dim>
Real stable_time_step(const Model<dim>& model, const State<dim>& state, const Work<dim>& work)
{
  Real fastest = 0;
  for (std::size_t r = 0; r < state.rigids.size(); ++r) {
    const RigidState<dim>& rigid = state.rigids[r];
    fastest = std::max(fastest, rigid.velocity.norm() + std::abs(rigid.spin) * reach_of<dim>(model.rigids[r].shape));
  }
  for (const Drive& drive : state.stage.drive)
    if (!drive.by_force) fastest = std::max(fastest, std::abs(drive.to));
  if (state.step == 0)  // the nodes do not move yet
    for (const Particles<dim>& particles : state.particles) {
      particles.visit([&](Index, Index b, int l) {
        Real square = 0;
        for (int d = 0; d < dim; ++d) square += particles.block(b).v[d][l] * particles.block(b).v[d][l];
        fastest = std::max(fastest, std::sqrt(square));
      });
    }
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const BodyGrid<dim>& grid = work.grids[b];
    // A comparison with NaN is false, so NaN is turned into infinity to be seen.
    fastest = largest_of("fastest node", static_cast<Index>(grid.nodes.size()), fastest, [&](Index n) {
      const Real speed = grid.moved_velocity[grid.nodes[n]].norm();
      return std::isfinite(speed) ? speed : infinity;
    });
  }
  if (!std::isfinite(fastest))
    throw RunError(fmt::format("velocities are not finite at t = {} s (step {}); try a smaller mpm.courant (now {})", state.time,
                               state.step, model.mpm.courant));

  Real least = infinity;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    const Material& material = model.bodies[b].material;
    const Real wave_speed = std::sqrt(p_wave_modulus(material) / density(material));
    const auto& occupied = state.particles[b].occupied();
    const Real height = -largest_of("smallest height", static_cast<Index>(occupied.size()), -infinity,
                                    [&](Index c) { return -model.mesh.height[occupied[c]]; });
    least = std::min(least, height / (wave_speed + fastest));
  }
  return model.mpm.courant * least;
}

template Real stable_time_step(const Model<2>&, const State<2>&, const Work<2>&);
template Real stable_time_step(const Model<3>&, const State<3>&, const Work<3>&);

}  // namespace berm
