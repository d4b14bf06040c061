// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm::io {

/// SHA-256 of a file's bytes, 64 hexadecimal digits, as `sha256sum` prints it. Throws RunError where the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// The files of the running program whose names begin so, as they are on the disk: the executable and shared libraries that are loaded.
std::vector<std::filesystem::path> program_files(const std::string& name);

}  // namespace berm::io
