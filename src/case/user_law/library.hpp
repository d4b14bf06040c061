// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm::user_law {

struct Library {
  void* handle;
  std::string sha256;  ///< of the bytes that were loaded
};

/// Loads a shared library and keeps it until the program ends; its start-up code cannot change how berm rounds. Its bytes are read once, compared with the SHA-256 that is wanted ("": any) and
/// loaded from memory, so that nobody changes the file in between. What it needs itself is found by whole paths only: $ORIGIN is not its folder. Throws InputError with what the loader
/// says where it is not there, is another or does not load.
Library open_library(const std::filesystem::path& file, const std::string& wanted_sha256 = "");

/// The first of these functions that the library has, and its name. Throws InputError, with names that the library does have, where it has none of them.
struct Symbol {
  void* address;
  std::string name;
};
Symbol find_function(void* library, const std::filesystem::path& file, const std::vector<std::string>& names);

/// Names of the functions that a shared library (64-bit ELF) offers, sorted; none where the file cannot be read as one.
std::vector<std::string> functions_in(const std::filesystem::path& file);

}  // namespace berm::user_law
