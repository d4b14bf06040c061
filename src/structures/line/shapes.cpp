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
};

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
  std::string frame;
  Fields fields;
  for (std::size_t at = 0; run_folder::next_csv_line(text, at, fields);) {
    ++lines.line;
    if (lines.line == 1) {
      if (fields != shape_head) lines.refuse(fmt::format("the head of a file of shapes is {}", fmt::join(shape_head, ",")));
      continue;
    }
    if (fields.size() != shape_head.size()) lines.refuse(fmt::format("{} fields, and the head has {}", fields.size(), shape_head.size()));
    if (shapes.empty() || fields[0] != frame)
      shapes.push_back(
          {.time = lines.number(fields[1]), .stage = fields[2], .x{}, .y{}, .z{}, .u{}, .P{}, .M{}, .strain_max{}, .strain_min{}});
    frame = fields[0];
    for (std::size_t c = 0; c < number_columns.size(); ++c) {
      const Real value = lines.number(fields[3 + c]);
      if (!std::isfinite(value)) lines.refuse(fmt::format("{} is not finite", shape_head[3 + c]));
      (shapes.back().*number_columns[c]).push_back(value);
    }
    if (const std::vector<Real>& x = shapes.back().x; x.size() > 1 && !(x[x.size() - 2] < x.back()))
      lines.refuse("x does not grow along the line");
  }
  for (const Shape& shape : shapes)
    if (shape.x.size() != shapes.front().x.size() || shape.x.size() < 2)
      lines.refuse("the shapes have different numbers of nodes, or fewer than two");
  return shapes;
}

const Shape* last_of(const std::vector<Shape>& shapes, const std::string& stage)
{
  const auto found = std::find_if(shapes.rbegin(), shapes.rend(), [&](const Shape& shape) { return shape.stage == stage; });
  return found == shapes.rend() ? nullptr : &*found;
}

}  // namespace berm::line
