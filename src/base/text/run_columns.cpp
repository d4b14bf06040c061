// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/setup/setup_section_test.cpp
#include "text/run_columns.hpp"

#include <algorithm>

namespace berm::text {
namespace {

template <class Entries>
auto find_key(Entries& entries, const std::string& key)
{
  return std::find_if(entries.begin(), entries.end(), [&](const auto& entry) { return entry.key == key; });
}

}  // namespace

void RunColumns::run(const std::string& name, std::vector<RunEntry> entries)
{
  names_.push_back(name);
  runs_.push_back(std::move(entries));
}

HtmlTable RunColumns::table(const std::string& id, const std::string& caption) const
{
  // A key that earlier runs lack is inserted after the one before it.
  std::vector<RunEntry> rows;
  for (const std::vector<RunEntry>& run : runs_) {
    auto after = rows.begin();
    for (const RunEntry& entry : run) {
      const auto found = find_key(rows, entry.key);
      after = (found == rows.end() ? rows.insert(after, entry) : found) + 1;
    }
  }

  HtmlTable table(id, caption);
  std::vector<HtmlCell> head = {{first_}};
  const bool numbers = std::any_of(rows.begin(), rows.end(), [](const RunEntry& entry) { return entry.number; });
  for (const std::string& name : names_) head.push_back({html_text(name), numbers});
  if (!unit_.empty()) head.push_back({unit_});
  if (!note_.empty()) head.push_back({note_});
  table.columns(head);
  for (const RunEntry& row : rows) {
    std::vector<HtmlCell> cells = {{row.heading}};
    bool differs = false;
    for (const std::vector<RunEntry>& run : runs_) {
      const auto found = find_key(run, row.key);
      cells.push_back(found == run.end() ? HtmlCell{"–", row.number} : HtmlCell{found->content, found->number});
      differs = differs || cells.back().content != cells[1].content;
    }
    if (!unit_.empty()) cells.push_back({row.unit});
    if (!note_.empty()) cells.push_back({row.note});
    table.row(cells, differs ? "differs" : "");
  }
  return table;
}

}  // namespace berm::text
