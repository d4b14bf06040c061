// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_plot/soil_plot_test.cpp
#include "soil_plot/soil_plot.hpp"

#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "soil_plot/particle_shapes.hpp"
#include "soil_plot/raster.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_plot {
namespace {

constexpr int left = 160, right = 240, bottom = 120, top = 110;  // pixels around the plot
constexpr int widest = 930, highest = 1000, narrowest = 100;     // pixels of the plot

/// A picture in the making: what it shows and in which unit.
struct Picture {
  const run_folder::Frame<2>& frame;
  const std::string& name;
  const run_folder::FieldValues<Real>& field;
  const SoilView& view;
  plot::PlotUnit unit;
  Vec<2> base;  ///< m, what places are told from (plot::axis_base)
  Vec<2> size() const { return view.upper - view.lower; }
  /// Of the plot, with equal axes.
  Real pixels_per_metre() const { return std::min(widest / size()[0], highest / size()[1]); }
  int plot_width() const { return std::max(static_cast<int>(std::lround(size()[0] * pixels_per_metre())), narrowest); }
  int plot_height() const { return std::max(static_cast<int>(std::lround(size()[1] * pixels_per_metre())), narrowest); }
  int width() const { return left + plot_width() + right; }
  int height() const { return bottom + plot_height() + top; }
  std::string words() const { return field.info.label + (field.info.unit.empty() ? "" : " (" + field.info.unit + ")"); }
  Real value(Index point) const { return field.at(point); }
  Vec<2> x(Index point) const { return frame.points[point]; }
  /// A place in the plot's unit, from the base.
  Vec<2> shown(const Vec<2>& x) const { return (x - base) * unit.per_si; }
  /// Of the circle that stands for a particle before it is deformed: larger than its share, so that neighbours close the ground between them.
  Real radius(Index point) const { return std::sqrt(frame.volume[point]); }
};

std::vector<Index> points_in_view(const Picture& picture)
{
  std::vector<Index> shown;
  for (Index k = 0; k < static_cast<Index>(picture.frame.points.size()); ++k) {
    const auto x = picture.frame.points[k].array();
    const Real radius = picture.radius(k);
    if ((x >= picture.view.lower.array() - radius).all() && (x <= picture.view.upper.array() + radius).all()) shown.push_back(k);
  }
  return shown;
}

/// Each triangle is painted as four, between its corners and the middles of its sides.
void paint_triangles(const Picture& picture, Real side, Raster& raster)
{
  constexpr int parts[4][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  for (const std::array<Index, 6>& nodes : picture.frame.triangles)
    for (const auto& part : parts) {
      std::array<Vec<2>, 3> corners;
      std::array<Real, 3> values;
      for (int k = 0; k < 3; ++k) {
        const Vec<2> x = picture.x(nodes[part[k]]);
        corners[k] = {side * x[0], x[1]};
        values[k] = picture.value(nodes[part[k]]);
      }
      raster.paint(corners, values);
    }
}

/// Each particle is painted as the ellipse that its circle has become.
void paint_particles(const Picture& picture, const std::vector<Index>& points, Real side, Raster& raster)
{
  const Eigen::DiagonalMatrix<Real, 2> to_side(side, 1);
  const std::vector<Matrix<2>> shapes = particle_shapes(picture.frame, points);
  for (std::size_t k = 0; k < points.size(); ++k)
    raster.paint_ellipse(to_side * picture.x(points[k]), to_side * shapes[k] * picture.radius(points[k]), picture.value(points[k]));
}

/// The data of the soil.
std::string pixels(const Picture& picture, const std::vector<Index>& points)
{
  Raster raster(picture.view.lower, picture.view.upper, picture.plot_width(), picture.plot_height());
  for (const Real side : {1., -1.}) {
    if (side < 0 && !picture.view.mirrored) break;
    if (picture.frame.triangles.empty())
      paint_particles(picture, points, side, raster);
    else
      paint_triangles(picture, side, raster);
  }
  return raster.floats();
}

std::string outlines(const Picture& picture)
{
  std::string data = fmt::format("# x, y ({}) of each rigid body\n", picture.unit.name);
  for (const run_folder::FrameRigid<2>& rigid : picture.frame.rigid_bodies)
    for (const auto& cell : rigid.surface.cells) {
      const auto line = [&](Index k) {
        const Vec<2> x = picture.shown(rigid.surface.points[k]);
        return fmt::format("{:.6g} {:.6g}\n", x[0], x[1]);
      };
      for (const Index k : cell.points) data += line(k);
      data += line(cell.points[0]) + '\n';
    }
  return data;
}

std::pair<Real, Real> range_of(const Picture& picture, const std::vector<Index>& points)
{
  std::vector<Real> values;
  for (const Index k : points) values.push_back(picture.value(k));
  return color_range(std::move(values));
}

/// Axes, colours and the line of the surface.
std::string axes(const Picture& picture, const std::pair<Real, Real>& range, const std::string& title)
{
  const int width = picture.width(), height = picture.height();
  const SoilView& view = picture.view;
  const plot::PlotUnit& unit = picture.unit;
  const auto part = [](int pixels, int of) { return static_cast<Real>(pixels) / of; };
  std::string script = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
      part(left, width), 1 - part(right, width), part(bottom, height), 1 - part(top, height));
  script += "set termoption font 'DejaVu Sans,22'\n";  // on half a page letters have half their size
  script += plot::title_over(title, width, part(height - top / 2, height));
  const Vec<2> lower = picture.shown(view.lower), upper = picture.shown(view.upper);
  script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", lower[0], upper[0], lower[1], upper[1]);
  script += fmt::format("set xlabel '{}'\nset ylabel '{}'\nset tics out nomirror\nset border lc rgb '#444444'\n",
                        plot::axis_title("x", picture.base[0], unit.name), plot::axis_title("y", picture.base[1], unit.name));
  constexpr Real room = 700;  // pixels for a whole set of tics
  script += fmt::format("set xtics {:g}\n", plot::tic_step((upper[0] - lower[0]) * std::max<Real>(1, room / picture.plot_width())));
  script += fmt::format("set colorbox user origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f}\n",
                        part(left + picture.plot_width() + 24, width), part(bottom, height), part(26, width),
                        part(picture.plot_height(), height));
  script += fmt::format("set cblabel {} offset 0,0 font {}\nset cbrange [{:g}:{:g}]\n", plot::gnuplot_text(picture.words()),
                        plot::font_that_fits(picture.words(), 18, picture.plot_height()), range.first, range.second);
  script += viridis_palette();
  script += "unset key\nset style fill solid noborder\n";
  mesh::GroundLine line = view.ground;
  if (line.level() && view.surface) line.corners = {Vec<2>(view.lower[0], *view.surface), Vec<2>(view.upper[0], *view.surface)};
  for (std::size_t k = 1; k < line.corners.size(); ++k) {
    const Vec<2> from = picture.shown(line.corners[k - 1]), to = picture.shown(line.corners[k]);
    script += fmt::format("set arrow {} from {:.6g},{:.6g} to {:.6g},{:.6g} nohead dt 2 lc rgb '#666666' lw 1 front\n", k, from[0], from[1],
                          to[0], to[1]);
  }
  return script;
}

/// A file of plots/ between quotes. With ./ before it, since gnuplot runs a name that begins with < as a command.
std::string data_file(const std::string& name)
{
  return plot::gnuplot_text("./" + name);
}

/// The command that draws the data.
std::string plot(const Picture& picture)
{
  const int columns = picture.plot_width(), rows = picture.plot_height();
  const Vec<2> pixel = (picture.size() * picture.unit.per_si).cwiseQuotient(Vec<2>(columns, rows));
  const Vec<2> first = picture.shown(picture.view.lower) + 0.5 * pixel;
  std::string command =
      fmt::format("plot {} binary array=({},{}) format='%float32' origin=({:.9g},{:.9g}) dx={:.9g} dy={:.9g} using 1 with image",
                  data_file(picture.name + ".bin"), columns, rows, first[0], first[1], pixel[0], pixel[1]);
  if (!picture.frame.rigid_bodies.empty())
    command += fmt::format(", \\\n     {} with filledcurves closed lc rgb '#c9ccd1', '' with lines lc rgb '#33373d' lw 2",
                           data_file(picture.name + "_rigid.dat"));
  return command + '\n';
}

}  // namespace

void SoilView::show(const mesh::GroundLine& line)
{
  if (line.level()) return;
  ground = within(line, lower, upper);
  surface.reset();
}

void SoilView::mirror()
{
  mirrored = true;
  lower[0] = -upper[0];
}

SoilView view_around(Real x, Real lowest, Real width_of_body, Real surface, const std::vector<Vec<2>>& soil)
{
  SoilView view{Vec<2>(x - 2.5 * width_of_body, lowest - 1.2 * width_of_body),
                Vec<2>(x + 2.5 * width_of_body, lowest + 1.3 * width_of_body), surface};
  std::vector<Real> levels;
  for (const Vec<2>& point : soil)
    if (point[0] >= view.lower[0] && point[0] <= view.upper[0]) levels.push_back(point[1]);
  if (levels.empty()) return view;
  const auto highest = levels.end() - 1 - static_cast<std::ptrdiff_t>(levels.size() / 1000);
  std::nth_element(levels.begin(), highest, levels.end());
  view.upper[1] = std::max(view.upper[1], *highest + 0.2 * width_of_body);
  return view;
}

bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<2>& frame, const SoilPicture& wanted, plot::PlotFormat format)
{
  if (frame.points.empty()) return false;
  const SoilView& view = wanted.view;
  const Picture picture{frame,
                        wanted.name,
                        frame.field(wanted.field),
                        view,
                        plot::length_unit((view.upper - view.lower).maxCoeff()),
                        {plot::axis_base(view.lower[0], view.upper[0]), plot::axis_base(view.lower[1], view.upper[1])}};
  const std::vector<Index> points = points_in_view(picture);
  const std::filesystem::path plots = io::make_inner_folder(folder, "plots");
  if (points.empty()) return false;
  io::write_atomically(plots / (picture.name + ".bin"), pixels(picture, points));
  io::write_atomically(plots / (picture.name + "_rigid.dat"), outlines(picture));
  return draw(folder, picture.name, picture.width(), picture.height(),
              axes(picture, range_of(picture, points), wanted.title) + plot(picture), format);
}

}  // namespace berm::soil_plot
