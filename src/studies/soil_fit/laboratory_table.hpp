// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "os/error.hpp"
#include "soil_fit/fit_settings.hpp"

#include <array>

namespace berm::soil_fit {

/// What a column of a table of tests may hold.
enum class Reading {
  axial_strain,
  shear_strain,
  volumetric_strain,
  void_ratio,
  q,
  stress_ratio,
  p,
  vertical_stress,
  lateral_stress,
  tau,
  excess_pore_pressure,
  depth,
  resistance,
  force
};
constexpr int reading_count = 14;

/// Their words, as the keys of measured.columns.
std::vector<std::string> reading_words();

/// The rows of a laboratory's CSV file, or of a group of a file of AGS 4, in SI units.
class LaboratoryTable {
public:
  /// Throws InputError with file and line where the file is not such a table.
  LaboratoryTable(std::filesystem::path file, const MeasuredFile& settings);

  bool has(Reading reading) const { return place_[static_cast<std::size_t>(reading)] != absent; }
  /// NaN where the field is empty.
  Real value(Reading reading, std::size_t row) const;
  /// The number in another column, by its heading, SI. Throws InputError.
  Real first_of(const std::string& heading, std::size_t row) const;
  /// The heading of what is there; "" of what is not.
  std::string heading_of(Reading reading) const;
  bool has_column(const std::string& name) const;
  /// The heading of a column whose text is another one than in the row above and no number; "" where there is none.
  std::string changed_name(std::size_t row) const;
  /// Names of the tests and their rows, in the order of the file.
  std::vector<std::pair<std::string, std::vector<std::size_t>>> tests() const;

  /// Throws InputError unless one of these is there.
  void need(const std::vector<Reading>& alternatives) const;
  void need_test(const std::string& name) const;
  /// "q, in the column dev (kPa),".
  std::string words_of(Reading reading) const;
  /// Throws InputError with the line of a row.
  [[noreturn]] void refuse(std::size_t row, const std::string& what) const;

private:
  static constexpr std::size_t absent = static_cast<std::size_t>(-1);
  struct Column {
    std::string heading, name, unit;  ///< as it stands there; without its unit; that unit, "" where it has none
  };

  void read_rows(const MeasuredKind& kind);
  void find_columns(const MeasuredFile& settings);
  std::size_t column_named(const std::string& heading, std::string* unit) const;
  Real number(std::size_t column, std::size_t row) const;

  std::filesystem::path file_;
  std::string test_column_, name_;
  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> fields_;
  std::vector<int> lines_;
  std::array<std::size_t, reading_count> place_;
  std::array<std::string, reading_count> unit_;  ///< of the columns that are read
};

}  // namespace berm::soil_fit
