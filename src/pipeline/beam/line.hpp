// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/pipe_section.hpp"
#include "beam/spring_laws.hpp"
#include "macro_element/macro_element.h"

#include <array>
#include <functional>
#include <vector>

namespace berm::beam {

/// A direction across the line: sideways on the sea bed, or upwards.
enum class Plane { lateral, vertical };

/// A direction in which springs act.
enum class Direction { axial, lateral, vertical };

/// A spring at a node.
struct Spring {
  Index node = 0, freedom = 0;
  Index law = 0;    ///< into Line::laws
  Real length = 1;  ///< m of the line that it stands for; 1 of a spring whose law has the force of the whole
  Real origin = 0;  ///< m, the displacement at which it begins without force
};

/// A soil whose force couples all directions.
struct MacroSoil {
  berm_macro_element_parameters parameters;
  berm_macro_element_state laid;  ///< of a pipe that lies where the line has its shape
};

/// A macro-element at a node.
struct MacroElement {
  Index node = 0;
  Index soil = 0;   ///< into Line::macro_soils
  Real length = 0;  ///< m of the line that it stands for
};

/// Where the nodes of one end may go.
enum class EndCondition {
  free,
  pinned,         ///< nowhere, but its slopes are free
  clamped,        ///< nowhere
  symmetric,      ///< the other half of the line is its mirror image: no displacement along it, no slopes
  antisymmetric,  ///< turned half around the vertical axis it is the other half: no displacement along or sideways, no vertical slope
};

/// A pipeline along x that cannot change during a run: nodes and the elements between them, straight where nothing acts but for `shape`. A node has the freedoms u along the line, then displacement and
/// slope of each of the planes in which the line may move.
struct Line {
  std::vector<Plane> planes;
  std::vector<Real> x;             ///< m, of the nodes, ascending
  std::vector<Section> section;    ///< by element
  std::vector<Real> shape;         ///< by freedom: displacement and slope without stress; an imperfection, or a route
  std::vector<std::uint8_t> held;  ///< by freedom: it stays where it is
  std::vector<SpringLaw> laws;
  std::vector<Spring> springs;
  std::vector<MacroSoil> macro_soils;
  std::vector<MacroElement> macro_elements;
  std::array<Real, 2> damping = {};  ///< 1/s, force over momentum across the line, by plane
  bool axial_where_sideways = true;  ///< plastic springs along the line also act where it slides sideways (State::sideways)

  Index nodes() const { return static_cast<Index>(x.size()); }
  Index elements() const { return nodes() - 1; }
  Real length(Index element) const { return x[element + 1] - x[element]; }
  Index freedoms_of_node() const { return 1 + 2 * static_cast<Index>(planes.size()); }
  Index freedoms() const { return nodes() * freedoms_of_node(); }
  /// The freedom of a node along the line; across it that of its displacement, which that of its slope follows.
  Index axial(Index node) const { return node * freedoms_of_node(); }
  Index across(Plane plane, Index node) const;
  Index freedom(Direction direction, Index node) const;
  bool moves(Plane plane) const;
};

/// A straight line of one section between free ends. Throws InputError unless there are two nodes at least and their x ascend.
Line straight_line(std::vector<Real> x, const Section& section, std::vector<Plane> planes);

/// Nodes from 0: elements of `size` up to `fine`, each following one longer by the factor `growth` up to `longest`, to `end` at least (m).
std::vector<Real> graded_nodes(Real size, Real fine, Real growth, Real longest, Real end);

/// Gives the line a shape in a plane: displacement (m) and slope over x.
void set_shape(Line& line, Plane plane, const std::function<Real(Real)>& displacement, const std::function<Real(Real)>& slope);

/// Holds a node as an end is held.
void hold(Line& line, Index node, EndCondition condition);

/// The part of the line between two places that is nearest to each node, m.
std::vector<Real> lengths_of_nodes(const Line& line, Real from = -infinity, Real to = infinity);

/// Springs of a law at all nodes that have a length (m). Their origin is the line's shape, or that level (m) where it is given. Throws InputError as check() does.
void add_springs(Line& line, Direction direction, SpringLaw law, const std::vector<Real>& lengths, Real level = nan);

/// Macro-elements of one soil at all nodes that have a length (m), of a pipe that was laid in its shape with that state (macro_element::laid); its V holds the weight. Throws InputError where the
/// line does not move in both planes, or where parameters or state make no sense.
void add_macro_elements(Line& line, const berm_macro_element_parameters& parameters, const std::vector<Real>& lengths,
                        const berm_macro_element_state& laid);

/// The largest slope of the line that von Karman's strain is meant for: at it the compression of a buckled column is 0.5 % too low and its amplitude 0.3 % too large (docs/theory/fem_safety_pipelines.md, Pipeline as a beam).
constexpr Real largest_valid_slope = 0.2;

}  // namespace berm::beam
