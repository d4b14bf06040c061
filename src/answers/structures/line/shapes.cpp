// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/shapes_test.cpp
#include "structures/line/shapes.hpp"

#include "os/text_of_list.hpp"
#include "run_folder/csv_line.hpp"
#include "structures/line/number_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace berm::line {
namespace {

using Fields = std::vector<std::string>;

/// After frame, time and stage, in the order of the file.
constexpr std::array number_columns{&Shape::x, &Shape::y, &Shape::z,          &Shape::u,
                                    &Shape::P, &Shape::M, &Shape::strain_max, &Shape::strain_min};
const Fields shape_head{"frame", "time_s", "stage", "x_m", "y_m", "z_m", "u_m", "P_N", "M_Nm", "strain_max", "strain_min"};

/// The last shape has as many nodes as the first.
void refuse_unless_whole(const NumberLines& lines, const std::vector<Shape>& shapes)
{
  if (shapes.back().x.size() != shapes.front().x.size() || shapes.back().x.size() < 2)
    lines.refuse("the shapes have different numbers of nodes, or fewer than two");
}

/// Adds a line of the file to the shape that it belongs to, or begins the next with it.
void add_node(const NumberLines& lines, const Fields& fields, std::vector<Shape>& shapes)
{
  const auto count = static_cast<Real>(shapes.size());
  const Real frame = lines.number(fields[0]);
  if (frame == count) {
    if (!shapes.empty()) refuse_unless_whole(lines, shapes);
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
  const std::string text = text_of(file);
  NumberLines lines{file};
  std::vector<Shape> shapes;
  Fields fields;
  std::size_t at = 0;
  while (run_folder::next_csv_line(text, at, fields)) {
    ++lines.line;
    if (lines.line == 1) {
      if (fields != shape_head) lines.refuse(fmt::format("the head of a file of shapes is {}", text_of_list(shape_head, ",")));
      continue;
    }
    if (fields.size() != shape_head.size()) lines.refuse(fmt::format("{} fields, and the head has {}", fields.size(), shape_head.size()));
    add_node(lines, fields, shapes);
  }
  if (at != text.size()) lines.refuse("the line after it has no end");
  if (!shapes.empty()) refuse_unless_whole(lines, shapes);
  return shapes;
}

const Shape* last_of(const std::vector<Shape>& shapes, const std::string& stage)
{
  const auto found = std::find_if(shapes.rbegin(), shapes.rend(), [&](const Shape& shape) { return shape.stage == stage; });
  return found == shapes.rend() ? nullptr : &*found;
}

}  // namespace berm::line
