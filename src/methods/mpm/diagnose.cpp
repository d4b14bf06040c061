// SPDX-License-Identifier: BSD-3-Clause
#include "mpm/diagnose.hpp"

#include "bodies/particle_fields.hpp"
#include "core/ranks.hpp"
#include "mpm/time_step.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::mpm {
namespace {

template <int dim>
std::string position_text(const Vec<dim>& x)
{
  return fmt::format("({}) m", text_of_list(x, ", ", "{:.6g}"));
}

const char* words_of(Real value)
{
  return std::isnan(value) ? "is not a number" : "is infinite";
}

/// The field of a particle that is not finite, and its index in the list of fields.
struct Trouble {
  int rank = std::numeric_limits<int>::max();
  std::string name = {};
  Real value = 0;
};

template <int dim>
Trouble trouble_of(const bodies::Particle<dim>& p, const std::vector<bodies::ExtraField>& extra)
{
  Trouble first;
  int rank = 0;
  const auto look_at = [&](unsigned travel, const std::string_view name, Real value) {
    if ((travel & must_be_finite) != 0 && !std::isfinite(value) && first.name.empty()) first = {rank, std::string(name), value};
  };
  bodies::for_each_field<dim>([&](const auto& field) {
    for (int c = 0; c < field.components; ++c) look_at(field.travel, field.name, static_cast<Real>(field.of(p, c)));
    ++rank;
  });
  for (const bodies::ExtraField& field : extra) {
    for (int c = 0; c < field.info.components; ++c) look_at(field.info.travel, field.info.name, p.extra[field.offset + c]);
    ++rank;
  }
  std::replace(first.name.begin(), first.name.end(), '_', ' ');
  return first;
}

}  // namespace

template <int dim>
void throw_not_finite(const problem::Model<dim>& model, const problem::State<dim>& state, Index body)
{
  const std::string when = fmt::format("at t = {:.6g} s (step {})", state.time, state.step),
                    advice = fmt::format("try {}, and check stiffness, strength and loads", smaller_step(model.mpm));
  const bodies::Particles<dim>& particles = state.particles[body];
  Trouble worst;
  bodies::Particle<dim> p;
  Index cell = none;
  particles.visit([&](Index c, Index b, int l) {
    const bodies::Particle<dim> read = particles.read(b, l);
    const Trouble trouble = trouble_of<dim>(read, particles.extra_fields());
    if (trouble.rank < worst.rank) worst = trouble, p = read, cell = c;
  });
  std::string words = fmt::format("velocities or forces of body \"{}\" are not finite {}; {}", model.bodies[body].name, when, advice);
  if (cell != none) {
    const std::string position =
        p.x.allFinite() ? "at " + position_text<dim>(p.x) : "around " + position_text<dim>(model.mesh.centroid(cell));
    words = fmt::format("particle {} of body \"{}\", {} in cell {}: its {} {} {}; {}", p.id, model.bodies[body].name, position, cell,
                        worst.name, words_of(worst.value), when, advice);
  }
  throw RunError(Ranks::of_run().text_of_largest(-worst.rank, words));
}

template <int dim>
std::string advice_for_leaving(const problem::Model<dim>& model, const problem::State<dim>& state, Index body, const Vec<dim>& x,
                               Index cell)
{
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    if (surface_at<dim>(placed<dim>(model.rigid_bodies[r], state.rigid_bodies[r]), x).distance < 2 * model.mesh.height(cell))
      return fmt::format(
          "rigid body \"{}\" is there and has displaced it: make the mesh larger there, end the stage \"{}\" earlier, or hold that "
          "boundary with a [support.NAME]",
          model.rigid_bodies[r].name, model.stages[state.stage.index].name);
  const auto has_dashpot = [&](Index node) { return model.conditions.dashpots[body].of_node[node] != none; };
  if (model.conditions.absorbs(body) && std::any_of(model.mesh.nodes[cell].begin(), model.mesh.nodes[cell].end(), has_dashpot))
    return fmt::format("the boundary there absorbs waves, and does not stop sliding soil: hold it by a support without `absorbs`, make the "
                       "mesh larger there, or end the stage \"{}\" earlier",
                       model.stages[state.stage.index].name);
  return "make the mesh larger there, hold that boundary with a [support.NAME], or use a smaller mpm.courant";
}

template <int dim>
void refuse_rigid_outside_mesh(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  const mesh::Mesh<dim>& mesh = model.mesh;
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r) {
    const bodies::RigidShape<dim>& first = model.rigid_bodies[r].shape;
    if (!bodies::is_bounded<dim>(first)) continue;
    const bodies::RigidShape<dim> now = placed<dim>(model.rigid_bodies[r], state.rigid_bodies[r]);
    const Real radius = bodies::has_corners<dim>(first) ? 0 : reach_of<dim>(first);
    const auto refuse = [&](const char* side, char axis, Real reached, Real limit, const char* advice) {
      throw RunError(fmt::format(
          "rigid body \"{}\" has left the mesh through its {}: it reaches {} = {:.6g} m, where the mesh ends at {:.6g} m, at "
          "t = {:.6g} s (step {}); {}, or end the stage \"{}\" earlier",
          model.rigid_bodies[r].name, side, axis, reached, limit, state.time, state.step, advice, model.stages[state.stage.index].name));
    };
    const Vec<dim> up = Vec<dim>::UnitY();  // the mesh's own bottom
    const Real low = lowest_level<dim>(now, up), x = center_of<dim>(now)[0], first_x = center_of<dim>(first)[0];
    if (lowest_level<dim>(first, up) >= mesh.lower[1] && low < mesh.lower[1])
      refuse("bottom", 'y', low, mesh.lower[1], "make the mesh deeper");
    if (lowest_level<dim>(first, up) <= mesh.upper[1] && low > mesh.upper[1])
      refuse("top", 'y', low, mesh.upper[1], "make the mesh higher, or drive it downwards");
    if (first_x - radius >= mesh.lower[0] && x - radius < mesh.lower[0])
      refuse("left side", 'x', x - radius, mesh.lower[0], "make the mesh longer there");
    if (first_x + radius <= mesh.upper[0] && x + radius > mesh.upper[0])
      refuse("right side", 'x', x + radius, mesh.upper[0], "make the mesh longer there");
    if (!std::isfinite(low) || !std::isfinite(x))
      throw RunError(fmt::format("the position of rigid body \"{}\" is not finite at t = {:.6g} s (step {})", model.rigid_bodies[r].name,
                                 state.time, state.step));
  }
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template void throw_not_finite(const problem::Model<dim>&, const problem::State<dim>&, Index);                                           \
  template std::string advice_for_leaving(const problem::Model<dim>&, const problem::State<dim>&, Index, const Vec<dim>&, Index);          \
  template void refuse_rigid_outside_mesh(const problem::Model<dim>&, const problem::State<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::mpm
