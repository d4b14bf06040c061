// SPDX-License-Identifier: BSD-3-Clause
#include "picture/canvas.hpp"

#include "io/atomic_file.hpp"
#include "io/run_and_wait.hpp"
#include "io/scratch_folder.hpp"
#include "os/error.hpp"
#include "text/html.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>

namespace berm::picture {
namespace {

constexpr Real head_length = 11, head_half = 4.2;  // of an arrow, pixels

}  // namespace

std::string Canvas::shown(const std::string& color) const
{
  if (place_ == Place::page || !color.starts_with("var(")) return color;
  const std::size_t begin = color.find(',') + 1;
  return color.substr(begin, color.size() - 1 - begin);
}

/// Shapes of one look that are drawn one after the other become one path: no seam shows between cells.
void Canvas::add(const std::string& look, const Points& points, const char* end)
{
  if (points.size() < 2) return;
  if (look != look_) {
    end_path();
    look_ = look;
    shapes_ += fmt::format("<path {} d=\"", look);
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    fmt::format_to(std::back_inserter(shapes_), "{}{:.2f} {:.2f}", k == 0 ? 'M' : ' ', points[k][0], points[k][1]);
  shapes_ += end;
}

void Canvas::end_path()
{
  if (!look_.empty()) shapes_ += "\"/>\n";
  look_.clear();
}

void Canvas::open(const Window& window)
{
  end_path();
  window_ = window;
  const Vec<2>&at = window.upper_left, size = window.size();
  shapes_ +=
      fmt::format("<svg x=\"{0:.2f}\" y=\"{1:.2f}\" width=\"{2:.2f}\" height=\"{3:.2f}\" viewBox=\"{0:.2f} {1:.2f} {2:.2f} {3:.2f}\">\n",
                  at[0], at[1], size[0], size[1]);
}

void Canvas::close()
{
  end_path();
  window_.reset();
  shapes_ += "</svg>\n";
}

void Canvas::polygon(const Points& points, const std::string& color)
{
  add(fmt::format("fill=\"{}\"", shown(color)), points, "z");
}

void Canvas::line(const Points& points, const LineStyle& style)
{
  add(look_of(style), points, "");
}

void Canvas::outline(const Points& points, const LineStyle& style)
{
  add(look_of(style), points, "z");
}

std::string Canvas::look_of(const LineStyle& style) const
{
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\"{}", shown(style.color), style.width,
                     style.dash.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dash));
}

void Canvas::arrow(const Vec<2>& from, const Vec<2>& to, const LineStyle& style)
{
  const Real length = (to - from).norm();
  if (!(length > 0)) return;
  const Vec<2> along = (to - from) / length, across(-along[1], along[0]);
  const Real head = std::min(head_length, 0.7 * length), half = head_half * head / head_length;
  line({from, Vec<2>(to - 0.8 * head * along)}, style);
  polygon({to, Vec<2>(to - head * along + half * across), Vec<2>(to - head * along - half * across)}, style.color);
}

void Canvas::dimension(const Vec<2>& from, const Vec<2>& to, const std::string& words)
{
  const LineStyle style{quiet_color, 1};
  const Vec<2> middle = 0.5 * (from + to);
  arrow(middle, from, style);
  arrow(middle, to, style);
  const bool upright = std::abs(to[1] - from[1]) > std::abs(to[0] - from[0]);
  if (upright && (to - from).norm() < width_of(words, TextStyle{}.size) + 6)  // words that are longer than the line lie
    text(middle + Vec<2>(-10, 0), words, {.anchor = Anchor::right});
  else
    text(middle + (upright ? Vec<2>(-11, 0) : Vec<2>(0, -9)), words, {.anchor = Anchor::center, .upright = upright});
}

void Canvas::text(const Vec<2>& at, const std::string& words, const TextStyle& style)
{
  if (words.empty() || (window_ && !window_->holds(at))) return;
  constexpr const char* anchors[] = {"start", "middle", "end"};
  const Real below = 0.47 * style.size;  // of its middle is the base line of a letter, pixels
  words_ +=
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"", at[0], at[1] + below, anchors[static_cast<int>(style.anchor)]);
  if (style.upright) words_ += fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at[0], at[1]);
  words_ += fmt::format(" font-size=\"{:g}pt\" fill=\"{}\"", style.size, shown(style.color));
  if (style.bold) words_ += " font-weight=\"bold\"";
  if (style.halo) words_ += fmt::format(" stroke=\"{}\" stroke-width=\"3\" paint-order=\"stroke\"", shown(ground_color));
  words_ += '>' + text::html_text(words) + "</text>\n";
}

Points Canvas::circle(const Vec<2>& center, Real radius)
{
  constexpr int sides = 72;
  Points points;
  for (int k = 0; k < sides; ++k) {
    const Real angle = 2 * pi * k / sides;
    points.emplace_back(center + radius * Vec<2>(std::cos(angle), std::sin(angle)));
  }
  return points;
}

Real Canvas::width_of(const std::string& words, Real size)
{
  std::size_t letters = 0;
  for (const char c : words) letters += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
  return 0.8 * size * static_cast<Real>(letters);
}

std::vector<std::string> Canvas::wrapped(const std::string& words, Real size, Real width)
{
  std::vector<std::string> lines(1);
  std::size_t begin = 0;
  while (begin < words.size()) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    const std::string word = words.substr(begin, end - begin);
    if (!lines.back().empty() && width_of(lines.back() + " " + word, size) > width) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    begin = end + 1;
  }
  return lines;
}

std::string Canvas::svg(const Vec<2>& size, const std::string& title, const std::string& description, Real scale) const
{
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{:.0f}\" height=\"{:.0f}\" viewBox=\"0 0 {:.0f} {:.0f}\" "
      "font-family=\"DejaVu Sans, sans-serif\" stroke-linejoin=\"round\">\n<title>{}</title>\n<desc>{}</desc>\n{}{}{}{}</svg>\n",
      scale * size[0], scale * size[1], size[0], size[1], text::html_text(title), text::html_text(description),
      place_ == Place::file ? "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" : "", shapes_, look_.empty() ? "" : "\"/>\n",
      words_);
}

void Canvas::write(const std::filesystem::path& file, const Vec<2>& size, const std::string& title, const std::string& description) const
{
  if (file.has_parent_path()) io::make_folder(file.parent_path());
  if (file.extension() == ".svg") return io::write_atomically(file, svg(size, title, description));
  const io::ScratchFolder scratch;
  const std::filesystem::path drawn = scratch.path() / "picture.svg", made = scratch.path() / "picture.png",
                              messages = scratch.path() / "messages";
  io::write_atomically(drawn, svg(size, title, description));
  const int status = io::run_and_wait({"rsvg-convert", "--output", made.string(), drawn.string()}, messages);
  if (status != 0)
    throw RunError(fmt::format(
        "{} is not drawn: {}", file.string(),
        status > 0
            ? "rsvg-convert says: " + io::last_message(messages)
            : fmt::format("the program rsvg-convert, which a .png needs and a .svg does not, did not start ({})", std::strerror(errno))));
  io::copy_atomically(made, file);
}

}  // namespace berm::picture
