// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace berm::input {

/// A column of a table of numbers.
struct TableColumn {
  std::string name, unit;  ///< SI; "": a bare number, whose heading needs none
};

/// What a table may be.
struct TableForm {
  std::string of;                    ///< "the load history of this stage"
  std::vector<TableColumn> columns;  ///< beside the first
  bool factors = false;              ///< it may instead have one column, of factors, with or without a first line
  std::string header;                ///< of an example
  TableColumn first = {"time", "s"};
  std::string over = "the time";  ///< what the first column is
};

/// Takes the next row: its first number, SI, the places in TableForm::columns of its columns (none: of factors), and their values, SI. Gives what is wrong with it, or "".
using TakeRow = std::function<std::string(Real first, const std::vector<std::size_t>& columns, const std::vector<Real>& values)>;

/// Reads the CSV file, of numbers over a time or something else, that a key names. Lines that begin with # do not count. Of a file of factors the others are two numbers with a
/// comma between them, time in s and factor, under a first line of words or none. Of columns the first line names them, each with its unit as in history.csv: time_s,H_N_m,V_kN_m
/// (N_m stands for N/m, Nm_m for N m/m), also in brackets, H [N/m]; a first column without a name
/// and empty ones at the end are not read. Where the first line that counts has semicolons or tabs, they stand for commas; a decimal
/// comma is one where no number has a point and not all commas may stand between thousands. There are two rows of numbers at least. Throws KeyError where
/// there is no such file, and InputError with file and line where it is wrong.
void read_table(const std::string& key, const std::filesystem::path& file, const TableForm& form, const TakeRow& take_row);

}  // namespace berm::input
