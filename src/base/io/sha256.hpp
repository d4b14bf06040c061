// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace berm::io {

/// SHA-256 of a file's bytes, 64 hexadecimal digits, as `sha256sum` prints it. Throws RunError where the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

/// The same of a text.
std::string sha256_of(std::string_view text);

/// A file that the running program was loaded from.
struct ProgramFile {
  std::string name;
  std::filesystem::path path;  ///< to read it by; empty where another file has its name since
};

/// The executable, and the shared libraries that are loaded whose names begin so. The executable is read by /proc/self/exe, also where it was replaced.
std::vector<ProgramFile> program_files(const std::string& name);

/// The GNU build id of what was linked, in hexadecimal digits: the same for the same bytes, wherever they lie; "" where there is none.
/// Of the executable or the library that is loaded at this address of the process, also where its file was replaced since.
std::string build_id_at(const void* address);
/// Of an ELF file of 64 bits; "" also where it cannot be read.
std::string build_id_in(const std::filesystem::path& file);

}  // namespace berm::io
