// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/shapes_test.cpp
#include "structures/line/shapes.hpp"

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "run_folder/csv_line.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::line {
namespace {

using Fields = std::vector<std::string>;

/// After frame, time and stage, in the order of the file.
constexpr std::array number_columns{&Shape::x, &Shape::y, &Shape::z,          &Shape::u,
                                    &Shape::P, &Shape::M, &Shape::strain_max, &Shape::strain_min};
const Fields shape_head{"frame", "time_s", "stage", "x_m", "y_m", "z_m", "u_m", "P_N", "M_Nm", "strain_max", "strain_min"};

/// One file, line by line.
struct ShapeLines {
  const std::filesystem::path& file;
  int line = 0;

  [[noreturn]] void refuse(const std::string& why) const { throw RunError(fmt::format("{}:{}: {}", file.string(), line, why)); }

  Real number(const std::string& word) const
  {
    Real value = nan;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (fault != std::errc{} || end != word.data() + word.size()) refuse(fmt::format("\"{}\" is no number", word));
    return value;
  }

  /// The last shape has as many nodes as the first.
  void refuse_unless_whole(const std::vector<Shape>& shapes) const
  {
    if (shapes.back().x.size() != shapes.front().x.size() || shapes.back().x.size() < 2)
      refuse("the shapes have different numbers of nodes, or fewer than two");
  }
};

/// Adds a line of the file to the shape that it belongs to, or begins the next with it.
void add_node(const ShapeLines& lines, const Fields& fields, std::vector<Shape>& shapes)
{
  const auto count = static_cast<Real>(shapes.size());
  const Real frame = lines.number(fields[0]);
  if (frame == count) {
    if (!shapes.empty()) lines.refuse_unless_whole(shapes);
    shapes.push_back(
        {.time = lines.number(fields[1]), .stage = fields[2], .x{}, .y{}, .z{}, .u{}, .P{}, .M{}, .strain_max{}, .strain_min{}});
  } else if (frame != count - 1) {
    lines.refuse("the frame is neither that of the line before nor the next");
  }
  Shape& now = shapes.back();
  for (std::size_t c = 0; c < number_columns.size(); ++c) {
    const Real value = lines.number(fields[3 + c]);
    if (!std::isfinite(value)) lines.refuse(fmt::format("{} is not finite", shape_head[3 + c]));
    (now.*number_columns[c]).push_back(value);
  }
  const std::vector<Real>&x = now.x, &nodes = shapes.front().x;
  if (x.size() > 1 && !(x[x.size() - 2] < x.back())) lines.refuse("x does not grow along the line");
  if (x.size() > nodes.size() || nodes[x.size() - 1] != x.back()) lines.refuse("the nodes are not those of the first frame");
}

}  // namespace

std::vector<Shape> read_shapes(const std::filesystem::path& folder)
{
  const std::filesystem::path file = folder / "line.csv";
  if (!std::filesystem::exists(file)) return {};
  constexpr std::uintmax_t max_bytes = 5'000'000'000;
  const auto [text, fault] = read_file(file, max_bytes);
  if (!fault.empty()) throw RunError(fmt::format("{}: {}", file.string(), fault));
  ShapeLines lines{file};
  std::vector<Shape> shapes;
  Fields fields;
  std::size_t at = 0;
  while (run_folder::next_csv_line(text, at, fields)) {
    ++lines.line;
    if (lines.line == 1) {
      if (fields != shape_head) lines.refuse(fmt::format("the head of a file of shapes is {}", fmt::join(shape_head, ",")));
      continue;
    }
    if (fields.size() != shape_head.size()) lines.refuse(fmt::format("{} fields, and the head has {}", fields.size(), shape_head.size()));
    add_node(lines, fields, shapes);
  }
  if (at != text.size()) lines.refuse("the line after it has no end");
  if (!shapes.empty()) lines.refuse_unless_whole(shapes);
  return shapes;
}

const Shape* last_of(const std::vector<Shape>& shapes, const std::string& stage)
{
  const auto found = std::find_if(shapes.rbegin(), shapes.rend(), [&](const Shape& shape) { return shape.stage == stage; });
  return found == shapes.rend() ? nullptr : &*found;
}

}  // namespace berm::line
