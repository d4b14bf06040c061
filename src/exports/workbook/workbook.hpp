// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace berm::workbook {

/// A table: rows of texts and numbers, the first of which are notes and then names.
struct Sheet {
  using Cell = std::variant<std::string, double>;
  std::string name;
  std::vector<std::vector<Cell>> rows;
  std::size_t names_row = 0;  ///< that of the names, which stays in sight
};

/// How numbers leave berm.
enum class Units {
  si,
  imperial  ///< ft, in, lbf, psf ... where a unit is of such a dimension; others stay
};

/// The results of a folder of any command of berm: a sheet of the quantities of summary.json, and one of each .csv of the folder, by its name. Columns of a .csv have their units where their names end with
/// them (H_N_m). Throws InputError where the folder has neither, RunError where a file is damaged or has more rows than a sheet can hold.
std::vector<Sheet> sheets_of(const std::filesystem::path& folder, Units units);

/// The bytes of an .xlsx file. Throws RunError where it cannot be made.
std::string xlsx_of(const std::vector<Sheet>& sheets);

}  // namespace berm::workbook
