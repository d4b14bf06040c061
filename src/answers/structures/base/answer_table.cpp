// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/answers_test.cpp
#include "structures/base/answer_table.hpp"

#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

void append(std::vector<text::HtmlCell>& cells, const std::vector<text::HtmlCell>& more)
{
  cells.insert(cells.end(), more.begin(), more.end());
}

}  // namespace

std::string AnswerTable::Column::words() const
{
  return *heading.unit == '\0' ? heading.words : fmt::format("{}, {}{}", heading.words, heading.unit, per_metre ? "/m" : "");
}

std::string AnswerTable::Column::value(Real number, bool in_log) const
{
  if (std::isnan(number) && *heading.missing != '\0') return heading.missing;
  return in_log || heading.whole ? text::short_number(number / heading.size) : text::table_number(number / heading.size);
}

std::vector<text::HtmlCell> AnswerTable::Column::headings() const
{
  if (shown != nullptr && unit == AnswerUnit::force) return shown->force_columns(heading.words);
  if (shown != nullptr && unit == AnswerUnit::length) return shown->length_columns(heading.words);
  return {{words(), true}};
}

std::vector<text::HtmlCell> AnswerTable::Column::cells(Real number, const BodyScale& scale) const
{
  if (shown != nullptr && unit == AnswerUnit::force) return shown->force_cells(scale, number);
  if (shown != nullptr && unit == AnswerUnit::length) return shown->length_cells(scale, number);
  return {{value(number, false), true}};
}

void AnswerTable::add(const std::string& name, const record::RunRecord& run, const std::string& prefix, std::vector<text::HtmlCell> also)
{
  Row row{name, std::move(also), body_scale(run), {}};
  bool any = false;
  for (Column& column : columns_) {
    const run_folder::Quantity* q = run.quantity(prefix + column.name);
    row.numbers.push_back(q == nullptr ? nan : q->value);
    if (!std::isnan(row.numbers.back())) column.known = any = true;
  }
  if (any) rows_.push_back(std::move(row));
}

std::string AnswerTable::html(std::vector<text::HtmlCell> first)
{
  if (rows_.empty()) return "";
  const auto is_shown = [](const Column& column) { return column.known || *column.heading.missing != '\0'; };
  for (const Column& column : columns_)
    if (is_shown(column)) append(first, column.headings());
  table_.columns(std::move(first));
  for (const Row& row : rows_) {
    std::vector<text::HtmlCell> cells{{text::html_text(row.name)}};
    append(cells, row.also);
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (is_shown(columns_[k])) append(cells, columns_[k].cells(row.numbers[k], row.scale));
    table_.row(cells);
  }
  return table_.html();
}

std::string AnswerTable::text() const
{
  if (rows_.empty()) return "";
  std::string log = fmt::format("{:<16}", "");
  const auto width = [](const Column& column) { return std::max<std::size_t>(8, column.words().size()) + 2; };
  for (const Column& column : columns_)
    if (column.known) log += fmt::format("{:>{}}", column.words(), width(column));
  for (const Row& row : rows_) {
    log += fmt::format("\n{:<16}", row.name);
    for (std::size_t k = 0; k < columns_.size(); ++k)
      if (columns_[k].known) log += fmt::format("{:>{}}", columns_[k].value(row.numbers[k], true), width(columns_[k]));
  }
  return log + '\n';
}

}  // namespace berm::base
