// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bodies/particles.hpp"

#include <tuple>
#include <type_traits>

namespace berm::bodies {

/// A field that every particle has: its metadata, and the members of Block and Particle that hold it.
template <int dim, class InBlock, class InParticle>
struct ParticleField {
  using Number = std::conditional_t<std::is_same_v<InBlock, std::int32_t[lanes]>, std::int32_t, Real>;
  static constexpr int components = std::is_same_v<Number, Real> && std::is_array_v<InBlock> ? int(std::extent_v<InBlock>) : 1;

  const char *name, *label, *unit;
  unsigned travel;
  InBlock Block<dim>::*in_block;
  InParticle Particle<dim>::*in_particle;

  FieldInfo info() const { return {name, label, unit, components, travel}; }
  /// One component of four particles, by lane.
  auto& of(Block<dim>& block, int component) const { return part(block.*in_block, component); }
  const auto& of(const Block<dim>& block, int component) const { return part(block.*in_block, component); }
  /// One component of one particle.
  Number& of(Particle<dim>& particle, int component) const { return part(particle.*in_particle, component); }
  Number of(const Particle<dim>& particle, int component) const { return part(particle.*in_particle, component); }

private:
  template <class Member>
  static auto& part(Member& member, int component)
  {
    if constexpr (components > 1)
      return member[component];
    else
      return member;
  }
};

template <int dim, class InBlock, class InParticle>
constexpr ParticleField<dim, InBlock, InParticle> particle_field(const char* name, const char* label, const char* unit, unsigned travel,
                                                                 InBlock Block<dim>::*in_block, InParticle Particle<dim>::*in_particle)
{
  return {name, label, unit, travel, in_block, in_particle};
}

/// The fields that every particle has. Writing, reading, moving between cells, checkpoints, the check for non-finite numbers
/// and frames loop over them. That check names the first: a field stands before those that it spoils within a step. Frames
/// store position, volume and number separately.
template <int dim>
constexpr auto particle_fields = std::tuple{
    particle_field("position", "position", "m", everywhere & ~to_frame, &Block<dim>::x, &Particle<dim>::x),
    particle_field("velocity", "velocity", "m/s", everywhere, &Block<dim>::v, &Particle<dim>::v),
    particle_field("volume", "volume", dim == 2 ? "m2" : "m3", everywhere & ~to_frame, &Block<dim>::volume, &Particle<dim>::volume),
    particle_field("mass", "mass", dim == 2 ? "kg/m" : "kg", everywhere & ~to_frame, &Block<dim>::mass, &Particle<dim>::mass),
    particle_field("stress", "stress (tension positive)", "Pa", everywhere, &Block<dim>::stress, &Particle<dim>::stress),
    particle_field("accumulated_deviatoric_strain", "accumulated deviatoric strain", "", everywhere, &Block<dim>::deviatoric_strain,
                   &Particle<dim>::deviatoric_strain),
    particle_field("id", "number", "", to_checkpoint | with_particle, &Block<dim>::id, &Particle<dim>::id)};

/// Calls visit(field) for each field that every particle has.
template <int dim, class Visit>
[[gnu::always_inline]] inline void for_each_field(const Visit& visit)
{
  std::apply([&](const auto&... field) { (visit(field), ...); }, particle_fields<dim>);
}

/// The same for the components of each: visit(field, component).
template <int dim, class Visit>
[[gnu::always_inline]] inline void for_each_component(const Visit& visit)
{
  for_each_field<dim>([&](const auto& field) {
    for (int component = 0; component < field.components; ++component) visit(field, component);
  });
}

}  // namespace berm::bodies
