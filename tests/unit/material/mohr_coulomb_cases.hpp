// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/mohr_coulomb.hpp"

#include <random>
#include <vector>

namespace berm::material {

inline MohrCoulomb soil(Real cohesion, Real friction, Real dilation, std::optional<Real> tension_cutoff = {}, Real poisson_ratio = 0.3)
{
  MohrCoulomb law;
  law.density = 2000;
  law.young_modulus = 1e7;
  law.poisson_ratio = poisson_ratio;
  law.cohesion = cohesion;
  law.friction_angle = friction * degree;
  law.dilation_angle = dilation * degree;
  law.tension_cutoff = tension_cutoff;
  law.max_opening = 0.2;
  return law;
}

/// Laws of every kind that have a unique return: with and without cohesion, friction, dilation and tension cut-off, up to the ends of the ranges.
inline std::vector<MohrCoulomb> soils()
{
  return {soil(0, 35, 0),
          soil(0, 35, 10),
          soil(0, 35, 35),
          soil(0, 60, 0),
          soil(1e4, 30, 0),
          soil(1e4, 30, 15),
          soil(1e4, 30, 30),
          soil(1e4, 60, 60),
          soil(1e4, 0, 0),
          soil(1e4, 0, 0, 2e3),
          soil(1e4, 0, 0, 0.),
          soil(1e4, 0, 0, 5e4),
          soil(1e4, 30, 0, 0.),
          soil(1e4, 30, 10, 5e3),
          soil(1e4, 30, 30, 1e4),
          soil(1e4, 45, 20, 9e3),
          soil(1e4, 30, 5, 4e3, 0.),
          soil(1e4, 20, 20, 1e3, 0.495),
          soil(5e3, 60, 60, 2e3, 0.45),
          soil(0, 50, 25, {}, 0.495),
          soil(1e4, 60, 0, 1e3, 0.495),
          soil(0, 30, 0, {}, 0.)};
}

/// A number of either sign whose size is spread evenly over four decades up to `largest`.
inline Real spread_number(std::mt19937_64& random, Real largest)
{
  std::uniform_real_distribution<Real> unit(-1, 1);
  const Real sign_and_fraction = unit(random), decades = 2 * (unit(random) - 1);
  return largest * sign_and_fraction * std::exp2(3.3219280948873623 * decades);
}

/// A trial stress with components of many sizes, shifted along the axis so that tension and compression both occur, Pa.
template <int dim>
SymTensor<dim> random_trial(std::mt19937_64& random)
{
  SymTensor<dim> trial;
  const Real largest = std::abs(spread_number(random, 1e6)), shift = spread_number(random, 1e6);
  std::uniform_real_distribution<Real> unit(-1, 1);
  for (int k = 0; k < tensor_size<dim>; ++k) trial[k] = largest * unit(random) + (k < 3 ? shift : 0);
  return trial;
}

/// The elastic strain of a stress: the inverse of Hooke's law.
template <int dim>
SymTensor<dim> elastic_strain(const Elasticity& elastic, const SymTensor<dim>& stress)
{
  SymTensor<dim> strain;
  const Real mean = trace(stress) / 3;
  for (int k = 0; k < tensor_size<dim>; ++k)
    strain[k] = (stress[k] - (k < 3 ? mean : 0)) / (2 * elastic.shear) + (k < 3 ? mean / (3 * elastic.bulk) : 0);
  return strain;
}

template <int dim>
Real size_of(const SymTensor<dim>& a)
{
  return std::sqrt(double_dot(a, a));
}

template <int dim>
SymTensor<dim> difference(const SymTensor<dim>& a, const SymTensor<dim>& b)
{
  SymTensor<dim> c;
  for (int k = 0; k < tensor_size<dim>; ++k) c[k] = a[k] - b[k];
  return c;
}

/// The returned stress of a trial stress, for a particle that has not opened.
template <int dim>
SymTensor<dim> returned(const PreparedMohrCoulomb& law, SymTensor<dim> trial)
{
  Real opening = 0;
  return_to_surface(law, trial, opening);
  return trial;
}

/// A state of plane strain as a state in space.
inline SymTensor<3> in_space(const SymTensor<2>& a)
{
  SymTensor<3> b;
  for (int k = 0; k < 4; ++k) b[k] = a[k];
  return b;
}

}  // namespace berm::material
