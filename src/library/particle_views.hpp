// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/library/library_test.cpp
#pragma once

#include "bodies/particle_fields.hpp"

#include <berm/berm.hpp>

namespace berm {

/// All fields of particles, those that every particle has first, where they lie.
template <int dim>
std::vector<ParticleField> views_of(const bodies::Particles<dim>& particles)
{
  std::vector<ParticleField> views;
  const auto blocks = static_cast<std::size_t>(particles.block_count());
  if (blocks == 0) return views;
  const bodies::Block<dim>& first = particles.block(0);
  bodies::for_each_field<dim>([&](const auto& field) {
    using Number = typename std::decay_t<decltype(field)>::Number;
    const FieldInfo info = field.info();
    views.push_back({info.name, info.unit, std::is_same_v<Number, std::int32_t>, &field.of(first, 0), blocks,
                     static_cast<std::size_t>(field.components), lanes, sizeof first, sizeof(Number) * lanes});
  });
  for (const bodies::ExtraField& extra : particles.extra_fields())
    views.push_back({extra.info.name, extra.info.unit, false, particles.extra(0) + extra.offset, blocks,
                     static_cast<std::size_t>(extra.info.components), lanes,
                     sizeof(Lanes) * static_cast<std::size_t>(particles.extra_size()), sizeof(Lanes)});
  return views;
}

}  // namespace berm
