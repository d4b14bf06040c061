// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace berm::run_folder {

/// Bytes as VTK's vtkZLibDataCompressor stores an array: UInt64 numbers of blocks, bytes of a block, bytes of the last one if it is shorter (else 0) and bytes of each
/// compressed block, then these. By libdeflate at its fastest level: higher ones take several times as long for a few per cent of the noise that fields are. Blocks are
/// compressed in parallel; the result does not depend on the number of threads.
std::string zlib_blocks(std::string_view bytes);

/// Most bytes that a compressed one can stand for.
constexpr std::uint64_t max_zlib_ratio = 1032;

/// The header of such an array.
struct ZlibHeader {
  static constexpr std::size_t first_bytes = 3 * sizeof(std::uint64_t);
  std::uint64_t blocks = 0, block_bytes = 0, last_bytes = 0;

  explicit ZlibHeader(const char* first) noexcept;
  /// Bytes of the whole header, and of the array; 0 where the numbers cannot be those of `room` compressed bytes.
  std::uint64_t size(std::uint64_t room) const;
  std::uint64_t unpacked(std::uint64_t room) const;
  std::uint64_t bytes_of(std::uint64_t block) const { return block + 1 == blocks && last_bytes > 0 ? last_bytes : block_bytes; }
};

/// Unpacks a block into `count` bytes; false where it does not hold them.
bool unpack_zlib(std::string_view packed, void* to, std::size_t count);

}  // namespace berm::run_folder
