// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/row.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace berm::run_folder {

/// The rows of a run: columns of numbers with what is said of them, and the name of the stage of each row.
struct History {
  std::vector<Column> columns;            ///< all but the stage, in the order of the file
  std::vector<std::vector<Real>> values;  ///< by column, then row
  std::vector<std::string> stage;         ///< by row

  Index rows() const { return static_cast<Index>(stage.size()); }
  bool has(const std::string& column) const;
  /// The numbers of a column. Throws RunError where there is no such column.
  const std::vector<Real>& operator[](const std::string& column) const;
  /// What is said of a column. Throws RunError where there is no such column.
  const Column& column(const std::string& name) const;

  /// The same by label, whatever the dimension: "H" is H_N_m in plane strain and H_N in space.
  bool has_label(const std::string& label) const;
  const std::vector<Real>& by_label(const std::string& label) const;
  const Column& column_by_label(const std::string& label) const;

  std::vector<std::string> names() const;
};

/// history.csv on its way to the disk: a header, then one line a row, each handed to the system whole, so that a reader at any time
/// sees whole rows but perhaps the last. Numbers are written in the shortest form that reads back to the same number, NaN as "nan". The first row
/// brings the columns: the header, and history.schema.json beside the file (write_schema).
class HistoryFile {
public:
  /// A resumed history keeps its first `kept_bytes` bytes and its schema, and what was written after them is
  /// cut off; with none the file begins anew, and is empty until its first row. Throws RunError.
  explicit HistoryFile(const std::filesystem::path& path, BigIndex kept_bytes = 0);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// Ends a row and writes it. Throws RunError where it cannot be written, and where its columns are not those of the rows before.
  void add(Row& row);

  /// All rows, as read_history() has them; those of a resumed history, too.
  const History& history() const { return history_; }

  /// The length of the file, with all rows. Throws RunError.
  BigIndex bytes() const;
  /// Forces all rows to the disk; while it does, another thread may add more. Throws RunError.
  void sync() const;

private:
  void write(const std::string& line);
  std::string header(const std::vector<Column>& columns) const;

  std::filesystem::path path_;
  int file_;
  History history_;
};

/// Reads a history.csv and its schema. A last line without its end is left out; an empty file is a history without columns: the run ended before its first
/// row. Throws RunError with file and line for anything that is not a history, and where there is no schema beside it that has its columns.
History read_history(const std::filesystem::path& path);

/// Where the columns of a history are described: history.schema.json beside history.csv.
std::filesystem::path schema_path(const std::filesystem::path& history);

/// Writes {"columns": [{"name", "label", "unit", "meaning", "of"}, ...]} in the order of the file: time_s, stage (whose unit is null) and the others.
/// Throws RunError.
void write_schema(const std::filesystem::path& history, const std::vector<Column>& columns);

/// The columns but the stage, in the order of the file. Throws RunError where there is no schema beside the history, or one that is damaged.
std::vector<Column> read_schema(const std::filesystem::path& history);

}  // namespace berm::run_folder
