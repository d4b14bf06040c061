// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/answer.hpp"
#include "structures/base/display_units.hpp"

namespace berm::base {

/// Answers as a table: its columns are those rows of answers that have a heading, its rows runs, stages or whatever has the answers.
class AnswerTable {
public:
  /// `force_dimension` 2: units of forces are per metre run.
  template <class... Rows>
  AnswerTable(text::HtmlTable table, int force_dimension, const Rows&... rows) : table_(std::move(table))
  {
    (add_columns(rows, force_dimension == 2, nullptr), ...);
  }
  /// Forces and lengths as all of a page.
  template <class... Rows>
  AnswerTable(text::HtmlTable table, const DisplayUnits& shown, const Rows&... rows) : table_(std::move(table))
  {
    (add_columns(rows, false, &shown), ...);
  }

  /// A row: the numbers of a run whose names begin with this; none where it has none of them. `also`: cells of the columns that stand before them.
  void add(const std::string& name, const record::RunRecord& run, const std::string& prefix, std::vector<text::HtmlCell> also = {});

  /// Without the columns in which no row has a number; "" without rows. `first`: heads the names of rows, and the other cells before the numbers.
  std::string html(std::vector<text::HtmlCell> first);
  /// The same for the log.
  std::string text() const;

private:
  struct Column {
    const char* name;
    AnswerUnit unit;
    Heading heading;
    bool per_metre;
    const DisplayUnits* shown;
    bool known = false;  ///< by a row

    std::string words() const;
    std::string value(Real number, bool in_log) const;
    std::vector<text::HtmlCell> headings() const;
    std::vector<text::HtmlCell> cells(Real number, const BodyScale& scale) const;
  };
  struct Row {
    std::string name;
    std::vector<text::HtmlCell> also;
    BodyScale scale;
    std::vector<Real> numbers;
  };

  template <class Rows>
  void add_columns(const Rows& rows, bool plane, const DisplayUnits* shown)
  {
    for (const auto& row : rows)
      if (row.heading.words != nullptr)
        columns_.push_back(
            {row.name, row.unit, row.heading, plane && (row.unit == AnswerUnit::force || row.unit == AnswerUnit::work), shown});
  }

  text::HtmlTable table_;
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

}  // namespace berm::base
