// SPDX-License-Identifier: BSD-3-Clause
#include "structures/line/line_shapes.hpp"

#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "run_folder/csv_line.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace berm::line {
namespace {

const std::vector<std::string> columns_of_shapes = {"frame", "time_s", "stage", "x_m",        "y_m",       "z_m",
                                                    "u_m",   "P_N",    "M_Nm",  "strain_max", "strain_min"};
enum ColumnOfShapes : std::size_t { frame, time, stage, x, first_of_node };
constexpr std::array of_node = {&LineShape::y, &LineShape::z,          &LineShape::u,         &LineShape::P,
                                &LineShape::M, &LineShape::strain_max, &LineShape::strain_min};

/// The lines of the file as the shapes that they make.
class ShapesReader {
public:
  explicit ShapesReader(const std::filesystem::path& file) : file_(file) {}

  LineShapes read(const std::string& text)
  {
    std::size_t at = 0;
    if (!run_folder::next_csv_line(text, at, fields_) || fields_ != columns_of_shapes)
      refuse(fmt::format("the columns are not {}", fmt::join(columns_of_shapes, ",")));
    while (run_folder::next_csv_line(text, at, fields_)) {
      ++line_;
      add_node();
    }
    if (at != text.size()) refuse("the line after it has no end");
    end_frame();
    return std::move(shapes_);
  }

private:
  [[noreturn]] void refuse(const std::string& why) const { throw RunError(fmt::format("{}: line {}: {}", file_.string(), line_, why)); }

  Real number(std::size_t column) const
  {
    const std::string& field = fields_[column];
    Real value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
      refuse(fmt::format("{} is no number", columns_of_shapes[column]));
    return value;
  }

  void add_node()
  {
    if (fields_.size() != columns_of_shapes.size())
      refuse(fmt::format("{} fields for {} columns", fields_.size(), columns_of_shapes.size()));
    const auto count = static_cast<Real>(shapes_.frames.size());
    const Real number_of_frame = number(frame);
    if (number_of_frame == count) {
      end_frame();
      LineShape& begun = shapes_.frames.emplace_back();
      begun.time = number(time);
      begun.stage = fields_[stage];
    } else if (number_of_frame != count - 1) {
      refuse("the frame is neither that of the line before nor the next");
    }
    LineShape& now = shapes_.frames.back();
    if (count == 0 || shapes_.frames.size() == 1) shapes_.x.push_back(number(x));
    if (now.y.size() == shapes_.x.size() || shapes_.x[now.y.size()] != number(x)) refuse("the nodes are not those of the first frame");
    for (std::size_t c = 0; c < of_node.size(); ++c) (now.*of_node[c]).push_back(number(first_of_node + c));
  }

  void end_frame() const
  {
    if (!shapes_.frames.empty() && shapes_.frames.back().y.size() != shapes_.x.size()) refuse("a frame has fewer nodes than the first");
  }

  const std::filesystem::path& file_;
  LineShapes shapes_;
  std::vector<std::string> fields_;
  Index line_ = 1;
};

}  // namespace

LineShapes read_line_shapes(const std::filesystem::path& file)
{
  constexpr std::uintmax_t max_bytes = 5'000'000'000;
  const std::string text = io::read_text_file(file, max_bytes);
  return text.empty() ? LineShapes() : ShapesReader(file).read(text);
}

}  // namespace berm::line
