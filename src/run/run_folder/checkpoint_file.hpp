// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"

#include <filesystem>
#include <functional>

namespace berm::run_folder {

/// Version of the checkpoint format: changes whenever the contents do.
constexpr int checkpoint_format = 20;

/// Archives the contents of a checkpoint.
using Contents = std::function<void(Archive&)>;

/// Writes a checkpoint: an HDF5 file after a header of 512 bytes of text: format, berm's version, length and CRC-32 of the
/// rest. The file is forced to the disk before it gets its name, so that it is complete or absent. Throws RunError with the
/// reason; nothing is left then.
void write_checkpoint(const std::filesystem::path& path, const Contents& contents);

/// The same in two parts: the contents go to a temporary file, which then gets its header, is forced to the disk and gets its name.
void begin_checkpoint(const std::filesystem::path& path, const Contents& contents);
void finish_checkpoint(const std::filesystem::path& path);

/// Reads a checkpoint. Before its contents are used, its header must be exactly what berm writes, and length and CRC-32 must
/// agree. Throws RunError with the reason: damaged, not a checkpoint, of a newer format or another version of berm, or
/// refused by `contents`; some of the contents may be read then.
void read_checkpoint(const std::filesystem::path& path, const Contents& contents);

/// CRC-32 of these bytes.
std::uint32_t crc_of(const void* first, std::size_t bytes);
/// CRC-32 of the first `bytes` bytes of a file; empty where it is shorter or cannot be read.
std::optional<std::uint32_t> crc_of(const std::filesystem::path& path, BigIndex bytes);

}  // namespace berm::run_folder
