// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/places.hpp"
#include "problem/case.hpp"
#include "problem/stage.hpp"

#include <filesystem>

namespace berm::input {

/// Reads a case file, after changing it by overrides `KEY=VALUE` (see apply_override). Throws InputError, one line with file
/// and line (or the override), key and what is allowed, where anything in it is invalid or unknown.
problem::Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// A case, and where its keys were written.
struct CaseInFile {
  problem::Case settings;
  Places places;
};
CaseInFile read_case_in_file(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// As read_case, of a text; `file` is for the messages.
problem::Case read_case_text(const std::string& file, const std::string& text, const std::vector<std::string>& overrides = {});

/// Makes the libraries of the user's own laws paths from the folder of the file that names them.
void find_libraries(std::vector<std::pair<std::string, material::Material>>& materials, const std::filesystem::path& folder);

/// Reads the file of the load history of the stage of this number, a path from `folder`, into its times and factors: two numbers a line with a comma between them, a first line of
/// words and lines that begin with # do not count. The stage ends with the last time at the latest. Throws KeyError where there is no such file, and InputError
/// with file and line where it is wrong.
void read_load_history(problem::StageSettings& stage, std::size_t number, const std::filesystem::path& folder);

}  // namespace berm::input
