// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "text/html.hpp"

#include <string>
#include <vector>

namespace berm::text {

/// An entry in the column of a run.
struct RunEntry {
  std::string key;      ///< identifies the row
  std::string heading;  ///< HTML of the row's header
  std::string content;  ///< HTML
  bool number = true;   ///< aligned to the right
  std::string unit;     ///< HTML, of a table that has units
  std::string note;     ///< HTML of the last cell, of a table that has notes
};

/// A table of runs side by side: a column for each run, a row for each key that any of them has, in their order. Rows in
/// which runs differ have the class "differs".
class RunColumns {
public:
  /// `first` heads the first column (HTML). `unit` and `note` head the columns of units and notes; "" leaves these out.
  RunColumns(std::string first, std::string unit = "", std::string note = "")
      : first_(std::move(first)),
        unit_(std::move(unit)),
        note_(std::move(note))
  {
  }

  /// A run by its name (plain text) with its entries; keys are unique among them.
  void run(const std::string& name, std::vector<RunEntry> entries);
  HtmlTable table(const std::string& id, const std::string& caption) const;

private:
  std::string first_, unit_, note_;
  std::vector<std::string> names_;
  std::vector<std::vector<RunEntry>> runs_;
};

}  // namespace berm::text
