// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_plot/soil_plot_test.cpp
#include "plot/gnuplot.hpp"

#include "io/atomic_file.hpp"
#include "io/log.hpp"
#include "io/run_and_wait.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cerrno>
#include <fmt/format.h>
#include <system_error>

namespace berm::plot {
namespace {

/// Whether a picture ends as pictures of its kind do: gnuplot does not tell when the disk does not take all of it.
bool is_whole(const std::filesystem::path& picture, PlotFormat format)
{
  constexpr std::string_view end_of_svg = "</svg>", end_of_png("IEND\xAE\x42\x60\x82", 8);
  std::string bytes = io::read_text_file(picture);
  if (format == PlotFormat::svg) bytes.erase(bytes.find_last_not_of(" \n") + 1);
  return bytes.ends_with(format == PlotFormat::svg ? end_of_svg : end_of_png);
}

}  // namespace

std::string gnuplot_text(const std::string& text)
{
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
  return quoted + "'";
}

std::string font_that_fits(const std::string& text, Real size, Real pixels)
{
  constexpr Real pixels_per_letter = 0.75;  // and point, of DejaVu Sans
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
  return fmt::format("'DejaVu Sans,{:.3g}'", std::min(size, pixels / (pixels_per_letter * std::max<Real>(1, static_cast<Real>(letters)))));
}

std::string title_over(const std::string& title, int width, Real level)
{
  return fmt::format("set label 1 {} at screen 0.5,{:.4f} center font {}\n", gnuplot_text(title), level,
                     font_that_fits(title, 17, 0.97 * width));
}

PlotUnit length_unit(Real size)
{
  return size < 1 ? PlotUnit{1000, "mm"} : PlotUnit{1, "m"};
}

PlotUnit force_unit(Real size, int dimension)
{
  if (size < 100) return {1, dimension == 2 ? "N/m" : "N"};
  return {1e-3, dimension == 2 ? "kN/m" : "kN"};
}

bool draw(const std::filesystem::path& folder, const std::string& name, int width, int height, const std::string& script, PlotFormat format)
{
  const bool vector = format == PlotFormat::svg;
  const std::string stem = vector ? name + "_svg" : name, picture = name + (vector ? ".svg" : ".png");
  const std::filesystem::path plots = io::make_inner_folder(folder, "plots"), messages = plots / (stem + ".messages");
  std::error_code ignored;
  const std::string head = fmt::format("# Draws ../{0}: run 'gnuplot {1}.gp' in this folder.\n"
                                       "set terminal {2} size {3},{4} noenhanced font 'DejaVu Sans,13' linewidth 1.2 background '#ffffff'\n"
                                       "if (!exists('picture')) picture = {5}\nset output picture\nset encoding utf8\n",
                                       picture, stem, vector ? "svg" : "pngcairo", width, height, gnuplot_text("../" + picture));
  io::write_atomically(plots / (stem + ".gp"), head + script);
  std::filesystem::remove(io::part_of(folder / picture), ignored);  // gnuplot would write through a link
  // -d: without the settings of its user. A name that begins with - is no option.
  const int status = io::run_and_wait(
      {"gnuplot", "-d", "-e", "picture = " + gnuplot_text("../" + io::part_of(picture).string()), "./" + stem + ".gp"}, messages, plots);
  const int reason = errno;
  if (status == 0) {
    std::filesystem::remove(messages, ignored);
    if (!is_whole(io::part_of(folder / picture), format)) {
      std::filesystem::remove(io::part_of(folder / picture), ignored);
      throw RunError(fmt::format("cannot write {}: gnuplot could not write all of it (is the disk full?)", (folder / picture).string()));
    }
    io::finish_whole(folder / picture);
    return true;
  }
  std::filesystem::remove(io::part_of(folder / picture), ignored);
  errno = reason;
  if (status < 0 && reason != ENOENT) io::throw_errno(fmt::format("cannot write {}: gnuplot did not start", (folder / picture).string()));
  if (status < 0)
    io::warn("{} is not drawn: the program gnuplot did not start ({}); its script is {}", picture, std::generic_category().message(errno),
             (plots / (stem + ".gp")).string());
  else
    io::warn("{} is not drawn: gnuplot says: {}", picture, io::last_message(messages));
  std::filesystem::remove(messages, ignored);
  std::filesystem::remove(folder / picture, ignored);
  return false;
}

Real round_up(Real value)
{
  if (!(value > 0)) return 1;
  const Real exponent = std::floor(std::log10(value)), power = std::pow(10, std::abs(exponent));
  const auto scaled = [&](Real step) { return exponent < 0 ? step / power : step * power; };  // 0.3 as it is written, not 3 * 0.1
  for (const Real step : {1., 1.5, 2., 3., 4., 5., 6., 8.})
    if (value <= scaled(step) * (1 + 1e-9)) return scaled(step);
  return scaled(10);
}

Real tic_step(Real range)
{
  const Real rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  return power * (rough < 1.5 * power ? 1 : rough < 3.5 * power ? 2 : rough < 7.5 * power ? 5 : 10);
}

Real axis_base(Real from, Real to)
{
  constexpr Real far = 1000;  // m, and lengths of the axis
  const Real length = to - from;
  if (!(std::max(std::abs(from), std::abs(to)) > far * std::max(length, Real(1)))) return 0;
  const Real power = std::pow(10, std::ceil(std::log10(10 * length)));
  return std::round((from + to) / 2 / power) * power;
}

std::string axis_title(const std::string& name, Real base, const std::string& unit)
{
  return base == 0 ? fmt::format("{} ({})", name, unit)
                   : fmt::format("{} {} {:.12g} m ({})", name, base < 0 ? "+" : "-", std::abs(base), unit);
}

}  // namespace berm::plot
