// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace berm::io {

/// Writes the file atomically: to a temporary file beside it, which is forced to the disk and renamed. Readers of `path` see
/// the old content or the new one. A file that is there keeps its mode. Throws RunError with the reason (disk full, no permission, ...); the old file is
/// unchanged then.
void write_atomically(const std::filesystem::path& path, std::string_view text);

/// Writes the concatenated parts in the same way.
void write_atomically(const std::filesystem::path& path, const std::vector<std::string_view>& parts);

/// Copies a file in the same way.
void copy_atomically(const std::filesystem::path& from, const std::filesystem::path& to);

/// The temporary file of `path`. finish_whole() forces what another program wrote there to the disk and renames it.
std::filesystem::path part_of(const std::filesystem::path& path);
void finish_whole(const std::filesystem::path& path);

/// Forces the contents of the file, or the entries of the folder, to the disk. Throws RunError where that fails.
void sync_file(const std::filesystem::path& path);

/// Makes a folder and its parents where they are missing. Throws RunError.
void make_folder(const std::filesystem::path& path);

/// Makes a folder inside of another where it is missing, and gives its path. Throws RunError where a link has its name: nothing is written through one.
std::filesystem::path make_inner_folder(const std::filesystem::path& folder, const std::filesystem::path& name);

/// Whether a folder for results holds the page of `command`. Throws InputError where it holds other files.
bool holds_page(const std::filesystem::path& folder, const std::string& page, const std::string& command);

/// Opens a file for writing, which is made where it is missing; `how`: O_WRONLY or O_RDWR, with O_APPEND, O_TRUNC. Throws RunError where that fails and
/// where a link has its name.
int open_to_write(const std::filesystem::path& path, int how);

/// The same of a file that one process has at a time, as long as it or a process that it started has it open; -1 where another has it.
int open_for_one(const std::filesystem::path& path, int how);

/// All bytes of a file; "" where there is none. Throws RunError where it cannot be read or has more than `most` bytes.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t most = 100'000'000);

/// Throws RunError with the message of the present errno.
[[noreturn]] void throw_errno(const std::string& what);

/// Writes all of `text` to a file descriptor, in one write() where the system takes it at once. False, and errno says why, where it failed.
bool write_all(int file, std::string_view text);

}  // namespace berm::io
