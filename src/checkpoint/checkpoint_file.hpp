// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"

#include <filesystem>
#include <functional>

namespace berm::checkpoint {

/// The form of a checkpoint: it changes whenever what is kept does.
constexpr int checkpoint_format = 3;

/// Names all that a checkpoint holds.
using Contents = std::function<void(Archive&)>;

/// Writes a checkpoint: an HDF5 file behind 512 bytes of text, which tell the format, berm's version, and length and CRC-32 of all that follows. The file is
/// forced to the disk before it gets its name, so that it is there as a whole or not at all. Throws RunError with the reason; nothing is left then.
void write_checkpoint(const std::filesystem::path& path, const Contents& contents);

/// Reads one. Before anything of it is believed it must be whole: every byte is covered by the first 512 bytes, and these must be just what
/// berm writes. Throws RunError that says what is wrong with it: damaged, not a checkpoint, of a newer format or another version of berm, or what
/// `contents` refuses; some of the contents may be read then.
void read_checkpoint(const std::filesystem::path& path, const Contents& contents);

/// CRC-32 of these bytes.
std::uint32_t crc_of(const void* first, std::size_t bytes);
/// CRC-32 of the first `bytes` bytes of a file; empty where it has not as many or cannot be read.
std::optional<std::uint32_t> crc_of(const std::filesystem::path& path, BigIndex bytes);

}  // namespace berm::checkpoint
