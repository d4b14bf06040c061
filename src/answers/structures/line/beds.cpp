// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/beds_test.cpp
#include "structures/line/beds.hpp"

#include "run_folder/csv_line.hpp"
#include "structures/line/number_lines.hpp"

#include <cmath>

namespace berm::line {
namespace {

using Fields = std::vector<std::string>;

constexpr std::size_t before_columns = 3;  // frame, slice, x

/// The middles of the columns, which stand in the names of the head: "rise_m_at_-1.580_m".
std::vector<Real> middles_of(const NumberLines& lines, const Fields& head)
{
  const std::string_view begin = "rise_m_at_", end = "_m";
  if (head.size() <= before_columns || head[0] != "frame" || head[1] != "slice" || head[2] != "x_m")
    lines.refuse("the head of a file of beds is frame,slice,x_m,rise_m_at_..._m");
  std::vector<Real> middles;
  for (std::size_t c = before_columns; c < head.size(); ++c) {
    const std::string_view name = head[c];
    if (!name.starts_with(begin) || !name.ends_with(end) || name.size() <= begin.size() + end.size())
      lines.refuse(fmt::format("\"{}\" names no column of soil", name));
    middles.push_back(lines.number(name.substr(begin.size(), name.size() - begin.size() - end.size())));
    if (middles.size() > 1 && !(middles[middles.size() - 2] < middles.back())) lines.refuse("the columns do not ascend");
  }
  return middles;
}

/// Adds a line of the file: the slices of a frame follow each other, and the frames.
void add_slice(const NumberLines& lines, const Fields& fields, Beds& beds)
{
  const auto frame = lines.number(fields[0]), slice = lines.number(fields[1]), x = lines.number(fields[2]);
  if (beds.rise.empty()) beds.first_frame = static_cast<Index>(frame);
  if (slice == 0) beds.rise.emplace_back();
  const auto expected = static_cast<Real>(beds.first_frame) + static_cast<Real>(beds.rise.size()) - 1;
  if (beds.rise.empty() || frame != expected) lines.refuse("the frame is neither that of the line before nor the next");
  std::vector<Real>& now = beds.rise.back();
  const std::size_t at = now.size() / beds.y.size();
  if (slice != static_cast<Real>(at)) lines.refuse("the slice does not follow the one before");
  if (beds.rise.size() == 1) beds.x.push_back(x);
  if (at >= beds.x.size() || x != beds.x[at]) lines.refuse("the slices are not those of the first frame");
  for (std::size_t c = before_columns; c < fields.size(); ++c) {
    now.push_back(lines.number(fields[c]));
    if (!std::isfinite(now.back())) lines.refuse("a rise is not finite");
  }
}

}  // namespace

Beds read_beds(const std::filesystem::path& folder)
{
  const std::filesystem::path file = folder / "berms.csv";
  Beds beds;
  if (!std::filesystem::exists(file)) return beds;
  const std::string text = text_of(file);
  NumberLines lines{file};
  Fields fields;
  std::size_t at = 0, columns = 0;
  while (run_folder::next_csv_line(text, at, fields)) {
    ++lines.line;
    if (lines.line == 1) {
      beds.y = middles_of(lines, fields);
      columns = fields.size();
      continue;
    }
    if (fields.size() != columns) lines.refuse(fmt::format("{} fields, and the head has {}", fields.size(), columns));
    add_slice(lines, fields, beds);
  }
  if (at != text.size()) lines.refuse("the line after it has no end");
  if (!beds.rise.empty() && beds.rise.back().size() != beds.rise.front().size()) lines.refuse("the last frame lacks slices");
  return beds;
}

}  // namespace berm::line
