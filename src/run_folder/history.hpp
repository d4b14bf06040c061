// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::run_folder {

/// The columns behind time_s and stage that the history of both methods begins with.
const std::vector<std::string>& common_columns();

/// history.csv on its way to the disk: a header, then one line a row, each handed to the system whole, so that a reader at any time
/// sees whole rows but perhaps the last. Numbers are written in the shortest form that reads back to the same number, NaN as "nan".
class HistoryFile {
public:
  /// The columns are time_s, stage and then `columns`. A history that goes on keeps its first `kept_bytes` bytes, and what was written behind them is
  /// cut off; with none the file begins anew. Throws RunError.
  HistoryFile(const std::filesystem::path& path, const std::vector<std::string>& columns, BigIndex kept_bytes = 0);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// One row: values in the order of the columns. Throws RunError where it cannot be written.
  void add(Real time, const std::string& stage, const std::vector<Real>& values);

  /// Forces all rows to the disk and gives the length of the file. Throws RunError.
  BigIndex sync();

private:
  void write(const std::string& line);

  std::filesystem::path path_;
  std::size_t columns_;
  int file_;
};

/// A history read back: columns of numbers by name, and the name of the stage of each row.
struct History {
  std::vector<std::string> columns;       ///< all but the stage, in the order of the file
  std::vector<std::vector<Real>> values;  ///< by column, then row
  std::vector<std::string> stage;         ///< by row

  Index rows() const { return static_cast<Index>(stage.size()); }
  bool has(const std::string& column) const;
  /// The numbers of a column. Throws RunError where there is no such column.
  const std::vector<Real>& operator[](const std::string& column) const;
};

/// A text as a field of a .csv file (RFC 4180): quoted only where it holds a comma, a quote or the end of a line.
std::string csv_field(const std::string& text);

/// Reads a history.csv. A last line without its end is left out. Throws RunError with file and line for anything that is not a history.
History read_history(const std::filesystem::path& path);

}  // namespace berm::run_folder
