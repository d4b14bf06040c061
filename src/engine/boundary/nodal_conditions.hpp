// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "boundary/dashpots.hpp"
#include "boundary/support.hpp"
#include "core/chunks.hpp"

#include <concepts>
#include <variant>

namespace berm::boundary {

/// What a hold does to the flux of water: at a node of several holds the last in this list counts.
enum class Flux : char { unchanged, symmetric, open, closed };

/// Acts on the velocity, which is zero, and on the flux of water.
struct Hold {
  Flux flux = Flux::closed;
};

/// Acts on the velocity: of the nodes or, where the boundary absorbs, of the wave that comes in from outside.
struct Motion {
  MotionSettings settings;
  bool incoming = false;

  Real velocity(int axis, Real since) const { return velocity_at(settings, axis, since); }
};

/// Acts on the force, by the dashpots of each body (NodalConditions::dashpots).
struct Absorb {};

/// Acts on the pressure of the water, which is that of the water outside.
template <int dim>
struct Head {
  Real pressure;                       ///< Pa, excess pore pressure of all of it
  std::vector<Vec<dim>> normals = {};  ///< unit, into the soil; by node of the condition
};

/// A condition at nodes of the mesh: a row of the list of all.
template <int dim>
struct NodalCondition {
  std::string name;  ///< of the support; empty: of an axis or a plane of symmetry
  std::variant<Hold, Motion, Absorb, Head<dim>> kind;
  std::uint8_t directions;        ///< bit d: direction d
  std::vector<char> acts;         ///< by stage
  Index reaction = none;          ///< its number among NodalConditions::reported, or none
  Real ramp = 0;                  ///< s, over which it comes and goes
  std::vector<Index> nodes = {};  ///< ascending
  Chunks chunks = {};             ///< of `nodes`
};

/// A kind with a velocity along an axis at a time (s) since its stage began prescribes that of its nodes.
template <class Kind>
concept PrescribesVelocity = requires(const Kind& kind)
{
  {
    kind.velocity(0, Real(0))
    } -> std::convertible_to<Real>;
};

/// What the conditions of a stage make of each node, for loops over nodes.
template <int dim>
struct NodeTable {
  NodeField<std::uint8_t> held;       ///< bit d: direction d of the velocity is held
  NodeField<std::uint8_t> closed;     ///< the same of the flux of water; empty where none flows
  NodeField<Holders<dim>> moved;      ///< the row whose velocity the node has, by direction; empty where none moves
  NodeField<Holders<dim>> reactions;  ///< the reported support that holds it, by direction; empty where none is reported
};

/// All conditions at nodes, and what the step reads of them.
template <int dim>
struct NodalConditions {
  std::vector<NodalCondition<dim>> rows;
  std::vector<Dashpots<dim>> dashpots;  ///< by body; empty where no boundary absorbs
  std::vector<std::string> reported;    ///< supports whose reactions are in the history
  std::vector<NodeTable<dim>> tables;   ///< those that differ
  std::vector<Index> table_of_stage;

  const NodeTable<dim>& in_stage(Index stage) const { return tables[static_cast<std::size_t>(table_of_stage[stage])]; }
  bool absorbs(Index body) const { return !dashpots.empty() && dashpots[body].any(); }
};

/// Calls visit(number, row, kind) for the rows of one kind, numbered in their order.
template <class Kind, int dim, class Visit>
void for_each_of(const NodalConditions<dim>& conditions, const Visit& visit)
{
  std::size_t number = 0;
  for (const NodalCondition<dim>& row : conditions.rows)
    if (const Kind* kind = std::get_if<Kind>(&row.kind)) visit(number++, row, *kind);
}
template <class Kind, int dim>
std::size_t count_of(const NodalConditions<dim>& conditions)
{
  std::size_t count = 0;
  for_each_of<Kind>(conditions, [&](const auto&...) { ++count; });
  return count;
}

/// Makes the tables from the rows. A node that several rows move, or of which several take the reaction, has the first.
template <int dim>
void make_tables(Index nodes, std::size_t stages, bool water_flows, NodalConditions<dim>& conditions);

}  // namespace berm::boundary
