// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "beam/loads.hpp"

namespace berm::beam {

/// Places along the line, anywhere, at which something else computes a force per metre from the line's velocity there, such as slices of soil. The force per metre is h(x) = sum over stations of
/// H phi(x), phi the hat that is 1 at its station and 0 at its neighbours. A node gets int h psi dx with its own hat psi, and a station gets the mean velocity int phi v dx / int phi dx of the line
/// between the nodes, so that sum F v of the nodes is sum H v int phi dx of the stations: none makes or loses energy on the way.
class Stations {
public:
  /// Places ascend and lie on the line. The first and the last station have half a hat. Throws InputError.
  Stations(const Line& line, std::vector<Real> places);

  Index count() const { return static_cast<Index>(lengths_.size()); }
  /// int phi dx of each, m.
  const std::vector<Real>& lengths() const { return lengths_; }
  /// Adds int f psi dx of f = sum over stations of f_k phi_k to each node: with f_k = 1 the length of the line that it has from them, m.
  void add_to_nodes(const std::vector<Real>& of_stations, std::vector<Real>& of_nodes) const;

  /// Adds the forces (N/m, by station) to the loads.
  void add_forces(const Line& line, Direction direction, const std::vector<Real>& per_metre, Loads& loads) const;
  /// Adds impedances (N s/m2, by station) to those of the nodes; against what velocity they act, Loads::velocity_then says.
  void add_impedances(const Line& line, Direction direction, const std::vector<Real>& per_metre, Loads& loads) const;
  /// Means of velocities or displacements, by station, of those of the freedoms.
  void means(const Line& line, Direction direction, const std::vector<Real>& of_freedoms, std::vector<Real>& of_stations) const;

private:
  struct Share {
    Index station, node;
    Real length;  ///< int phi psi dx, m
  };
  std::vector<Real> lengths_;
  std::vector<Share> shares_;
};

}  // namespace berm::beam
