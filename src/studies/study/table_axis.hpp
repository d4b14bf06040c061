// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/study_settings.hpp"

namespace berm::study {

/// The rows of a CSV file as the values of an axis. The first line holds keys as --set takes them, each KEY or KEY (UNIT), the lines below it values: numbers, in the
/// SI unit where their column has none, or texts such as "2 kPa". A column `name` names the rows, which are then chosen values; rows without
/// names are counted from 1 and are a sample. Fields are separated by commas, or by semicolons where the first line has no comma; blank lines and those that
/// begin with # do not count. Throws InputError with file and line.
StudyAxis read_table(const std::filesystem::path& file, const std::string& name);

}  // namespace berm::study
