// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "problem/model.hpp"

namespace berm::simulation {

/// The coefficients c with which sum c_k f_k is the value at the origin of the linear field that fits values f_k at the places x_k best: least squares with
/// the weights size_k / (|x_k|^2 + 0.04)^2, so that near places decide. Exact for a linear field; in directions along which the places hardly differ
/// (variance below 0.1) the field is taken to be constant. Places count in units in which neighbours are 2 apart.
template <int dim>
std::vector<Real> linear_fit_at_origin(const std::vector<Vec<dim>>& places, const std::vector<Real>& sizes);

/// What a watched point shows.
template <int dim>
struct Watched {
  Vec<dim> displacement, velocity;
  SymTensor<dim> stress;   ///< Pa, tension positive
  Real pore_pressure = 0;  ///< Pa, excess; 0 where the soil has none
};

/// A point of the soil that is watched. Displacement and velocity are linear fits through the particles that were around it at the start, stress and pore
/// pressure through the means of the patches around the place where it is now: the volumetric strain, and so the pressure, is one for a patch (docs/theory/method.md, Volumetric locking).
template <int dim>
class WatchPoint {
public:
  /// `point` is that which was asked for; where no particle is within two of its widths, the nearest one's place is taken.
  WatchPoint(const problem::Model<dim>& model, const bodies::Particles<dim>& start, const problem::Watch& watch,
             const std::vector<Real>& point);

  /// Now. The same on any number of ranks. Throws RunError where the particles are gone.
  Watched<dim> read(const problem::Model<dim>& model, const bodies::Particles<dim>& particles) const;

private:
  struct Neighbour {
    std::int32_t id;
    Real part;       ///< coefficient of its motion
    Vec<dim> first;  ///< place at the start, m
  };

  Index body_;
  std::int32_t nearest_;
  Vec<dim> place_;                     ///< at the start, m
  std::vector<Neighbour> neighbours_;  ///< by id
};

}  // namespace berm::simulation
