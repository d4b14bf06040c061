// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/tensor.hpp"

namespace berm {

/// s += rotation s - s rotation, the part of a stress increment that is due to the material's rotation (Jaumann rate). rotation[a][b] is antisymmetric, rad.
template <class V>
[[gnu::always_inline]] inline void rotate(SymTensor<2, V>& s, const Real (&rotation)[2][2])
{
  const Real w = rotation[0][1];
  const V turned = w * (s[1] - s[0]), change = 2 * w * s[3];
  s[0] += change;
  s[1] -= change;
  s[3] += turned;
}
template <class V>
[[gnu::always_inline]] inline void rotate(SymTensor<3, V>& s, const Real (&rotation)[3][3])
{
  const Real xy = rotation[0][1], yz = rotation[1][2], xz = rotation[0][2];
  const V of_xy = xy * s[3], of_yz = yz * s[4], of_xz = xz * s[5];
  const V change_xy = xy * (s[1] - s[0]) + xz * s[4] + yz * s[5], change_yz = yz * (s[2] - s[1]) - xy * s[5] - xz * s[3],
          change_xz = xz * (s[2] - s[0]) - yz * s[3] + xy * s[4];
  s[0] += 2 * (of_xy + of_xz);
  s[1] += 2 * (of_yz - of_xy);
  s[2] -= 2 * (of_xz + of_yz);
  s[3] += change_xy;
  s[4] += change_yz;
  s[5] += change_xz;
}

}  // namespace berm
