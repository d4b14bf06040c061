// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace berm {

/// Writes the file as a whole or not at all: to a temporary file beside it, which is forced to the disk and renamed. Whoever reads `path`
/// sees the old content or the new one. Throws RunError with the reason (disk full, no permission, ...); the old file is untouched then.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// All bytes of a file; "" where it cannot be read.
std::string read_whole(const std::filesystem::path& path);

/// Throws RunError with the words of the present errno.
[[noreturn]] void throw_errno(const std::string& what);

/// Writes all of `text` to a file descriptor, in one write() where the system takes it at once. False, and errno says why, where it failed.
bool write_all(int file, std::string_view text);

}  // namespace berm
