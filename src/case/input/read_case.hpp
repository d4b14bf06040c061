// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "input/places.hpp"
#include "settings/case.hpp"
#include "settings/stage.hpp"

#include <filesystem>

namespace berm::input {

/// Reads a case file, after changing it by overrides `KEY=VALUE` (see apply_override). Throws InputError, one line with file
/// and line (or the override), key and what is allowed, where anything in it is invalid or unknown.
settings::Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// A case, and where its keys were written.
struct CaseInFile {
  settings::Case settings;
  Places places;
};
CaseInFile case_of(Document document, const std::vector<std::string>& overrides = {});
CaseInFile case_of(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// As read_case, of a text; `file` is for the messages.
settings::Case read_case_text(const std::string& file, const std::string& text, const std::vector<std::string>& overrides = {});

/// Makes the libraries of the user's own laws paths from the folder of the file that names them.
void find_libraries(std::vector<std::pair<std::string, material::Material>>& materials, const std::filesystem::path& folder);

}  // namespace berm::input
