// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace berm {

/// Opens a regular file for reading. Nothing else is read: opening a FIFO would wait for who writes into it, and a device has no end. Returns -1 where that
/// is not possible, and `fault` says why: "there is no such file", "is a FIFO, not a file".
int open_to_read(const std::filesystem::path& path, std::string& fault);

/// What is in a file, or why it cannot be read.
struct FileBytes {
  std::string bytes, fault;
};

/// All bytes of a regular file that has `most` of them at most.
FileBytes read_file(const std::filesystem::path& path, std::uintmax_t most);

}  // namespace berm
