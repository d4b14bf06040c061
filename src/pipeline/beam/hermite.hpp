// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <array>

namespace berm::beam {

/// Displacement and slope times the element's length at both ends of an element, in one plane: v_a, L v'_a, v_b, L v'_b.
using AtEnds = std::array<Real, 4>;

/// Integrals over an element of cubic Hermite functions N and their derivatives by x/L, for AtEnds.
struct HermiteMatrix {
  Real entry[4][4];

  AtEnds times(const AtEnds& d) const
  {
    AtEnds product{};
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) product[i] += entry[i][j] * d[j];
    return product;
  }
  /// d^T A d.
  Real square(const AtEnds& d) const
  {
    const AtEnds product = times(d);
    return d[0] * product[0] + d[1] * product[1] + d[2] * product[2] + d[3] * product[3];
  }
};

constexpr HermiteMatrix bending = {{{12, 6, -12, 6}, {6, 4, -6, 2}, {-12, -6, 12, -6}, {6, 2, -6, 4}}};  ///< of N'' N''
constexpr HermiteMatrix stretching = {{{36. / 30, 3. / 30, -36. / 30, 3. / 30},
                                       {3. / 30, 4. / 30, -3. / 30, -1. / 30},
                                       {-36. / 30, -3. / 30, 36. / 30, -3. / 30},
                                       {3. / 30, -1. / 30, -3. / 30, 4. / 30}}};  ///< of N' N'
constexpr HermiteMatrix inertia = {{{156. / 420, 22. / 420, 54. / 420, -13. / 420},
                                    {22. / 420, 4. / 420, 13. / 420, -3. / 420},
                                    {54. / 420, 13. / 420, 156. / 420, -22. / 420},
                                    {-13. / 420, -3. / 420, -22. / 420, 4. / 420}}};  ///< of N N

/// Of the freedoms of a plane at both ends of an element, which begin there.
inline AtEnds at_ends(const Real* first, const Real* second, Real length)
{
  return {first[0], length * first[1], second[0], length * second[1]};
}

/// d^2/d(x/L)^2 of the displacement at s = x/L.
inline Real curving(const AtEnds& d, Real s)
{
  return (12 * s - 6) * (d[0] - d[2]) + (6 * s - 4) * d[1] + (6 * s - 2) * d[3];
}

}  // namespace berm::beam
