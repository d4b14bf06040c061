// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/hilbert_curve.hpp"

namespace berm::mesh {

template <int dim>
std::uint64_t hilbert_index(std::array<std::uint32_t, dim> point)
{
  // Undo, from the largest cube to the smallest, the mirror (bit set) or the swap of axes (bit clear) of the curve inside each.
  for (int level = curve_bits - 1; level > 0; --level) {
    const std::uint32_t bit = 1u << level, below = bit - 1;
    for (int d = 0; d < dim; ++d) {
      if (point[d] & bit) {
        point[0] ^= below;
      } else {
        const std::uint32_t differ = (point[0] ^ point[d]) & below;
        point[0] ^= differ;
        point[d] ^= differ;
      }
    }
  }
  // The bits of all axes at one level are now a Gray code: turn it into a number.
  for (int d = 1; d < dim; ++d) point[d] ^= point[d - 1];
  std::uint32_t carry = 0;
  for (int level = curve_bits - 1; level > 0; --level)
    if (point[dim - 1] & (1u << level)) carry ^= (1u << level) - 1;

  std::uint64_t index = 0;
  for (int level = curve_bits - 1; level >= 0; --level)
    for (int d = 0; d < dim; ++d) index = index << 1 | (((point[d] ^ carry) >> level) & 1u);
  return index;
}

template std::uint64_t hilbert_index<2>(std::array<std::uint32_t, 2>);
template std::uint64_t hilbert_index<3>(std::array<std::uint32_t, 3>);

}  // namespace berm::mesh
