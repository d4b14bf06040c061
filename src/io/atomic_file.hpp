// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace berm::io {

/// Writes the file as a whole or not at all: to a temporary file beside it, which is forced to the disk and renamed. Whoever reads `path`
/// sees the old content or the new one. Throws RunError with the reason (disk full, no permission, ...); the old file is untouched then.
void write_atomically(const std::filesystem::path& path, std::string_view text);

/// Writes the parts one behind the other in the same way.
void write_atomically(const std::filesystem::path& path, const std::vector<std::string_view>& parts);

/// Copies a file in the same way.
void copy_atomically(const std::filesystem::path& from, const std::filesystem::path& to);

/// The temporary file of `path`. What another program wrote there finish_whole() forces to the disk and renames, in the same way.
std::filesystem::path part_of(const std::filesystem::path& path);
void finish_whole(const std::filesystem::path& path);

/// Forces what was written to the file, or the names in the folder, to the disk. Throws RunError where the disk does not take it.
void sync_file(const std::filesystem::path& path);

/// Makes a folder and its parents, where they are missing. Throws RunError.
void make_folder(const std::filesystem::path& path);

/// All bytes of a file; "" where it cannot be read.
std::string read_text_file(const std::filesystem::path& path);

/// Throws RunError with the words of the present errno.
[[noreturn]] void throw_errno(const std::string& what);

/// Writes all of `text` to a file descriptor, in one write() where the system takes it at once. False, and errno says why, where it failed.
bool write_all(int file, std::string_view text);

}  // namespace berm::io
