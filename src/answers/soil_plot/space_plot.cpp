// SPDX-License-Identifier: BSD-3-Clause
#include "soil_plot/soil_plot.hpp"

#include "io/atomic_file.hpp"
#include "plot/gnuplot.hpp"
#include "soil_plot/isometric_raster.hpp"
#include "soil_plot/raster.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::soil_plot {
namespace {

constexpr int paper_width = 1200, paper_left = 95, paper_right = 240, paper_bottom = 110, paper_top = 70;  // pixels
constexpr Rgb body_color = {201, 204, 209};

Vec<3> shown_at(const Vec<3>& x, const SpaceView& view)
{
  return view.mirrored ? Vec<3>(x[0], x[1], 2 * view.upper[2] - x[2]) : x;
}

bool holds(const SpaceView& view, const Vec<3>& x)
{
  return (x.array() >= view.lower.array()).all() && (x.array() <= view.upper.array()).all();
}

void paint_bodies(IsometricRaster& raster, const run_folder::Frame<3>& frame)
{
  using Kind = bodies::SurfaceMesh<3>::Kind;
  constexpr int sides[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  for (const run_folder::FrameRigid<3>& rigid : frame.rigid_bodies) {
    const auto paint = [&](const std::vector<Index>& corners) {
      for (std::size_t k = 2; k < corners.size(); ++k)
        raster.paint_triangle({rigid.surface.points[corners[0]], rigid.surface.points[corners[k - 1]], rigid.surface.points[corners[k]]},
                              body_color);
    };
    for (const auto& cell : rigid.surface.cells) {
      if (cell.kind == Kind::line) continue;
      if (cell.kind != Kind::hexahedron)
        paint(cell.points);
      else
        for (const auto& side : sides) paint({cell.points[side[0]], cell.points[side[1]], cell.points[side[2]], cell.points[side[3]]});
    }
  }
}

/// Arrows along the axes in the lower left corner, and how long they are.
std::string axes(const IsometricRaster& raster, const plot::PlotUnit& unit)
{
  const Real length = plot::round_up(60 / raster.pixels_per_metre() * unit.per_si) / unit.per_si;
  const Real on_paper = length * raster.pixels_per_metre() * std::sqrt(2. / 3);
  const Vec<2> origin(0, on_paper / 2 - paper_bottom + 20);
  std::string script;
  constexpr const char *names[] = {"x", "y", "z"}, *colors[] = {"#d1495b", "#2a9d4a", "#3a78c9"};
  for (int d = 0; d < 3; ++d) {
    const Vec<2> way = isometric(Vec<3>::Unit(d)).normalized();
    const Vec<2> tip = origin + on_paper * way, name = tip + 12 * way;
    script += fmt::format("set arrow from {:.6g},{:.6g} to {:.6g},{:.6g} lc rgb '{}' lw 2 front\n", origin[0], origin[1], tip[0], tip[1],
                          colors[d]);
    script += fmt::format("set label '{}' at {:.6g},{:.6g} center front\n", names[d], name[0], name[1]);
  }
  script += fmt::format("set label 'arrows: {:g} {}' at {:.6g},{:.6g} front\n", length * unit.per_si, unit.name, on_paper + 30, origin[1]);
  return script;
}

}  // namespace

SpaceView view_around(const bodies::SurfaceMesh<3>& body, Real width_of_body, const Vec<3>& mesh_lower, const Vec<3>& mesh_upper,
                      bool mirrored)
{
  Vec<3> lower = Vec<3>::Constant(infinity), upper = -lower;
  for (const Vec<3>& x : body.points) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  const Real cut = mirrored ? mesh_lower[2] : (lower[2] + upper[2]) / 2;
  const Real beside = 2.5 * width_of_body, behind = mirrored ? 2 * cut - mesh_upper[2] : mesh_lower[2];
  SpaceView view{lower - Vec<3>(beside, 1.2 * width_of_body, beside), upper + Vec<3>(beside, 0.2 * width_of_body, 0), mirrored};
  view.lower = view.lower.cwiseMax(Vec<3>(mesh_lower[0], mesh_lower[1], behind));
  view.upper[0] = std::min(view.upper[0], mesh_upper[0]);
  view.upper[2] = cut;
  return view;
}

SpaceView view_of_all(const Vec<3>& mesh_lower, const Vec<3>& mesh_upper, bool mirrored)
{
  SpaceView view{mesh_lower, mesh_upper, mirrored};
  view.upper[2] = mirrored ? mesh_lower[2] : (mesh_lower[2] + mesh_upper[2]) / 2;
  if (mirrored) view.lower[2] = 2 * view.upper[2] - mesh_upper[2];
  return view;
}

bool draw_soil(const std::filesystem::path& folder, const run_folder::Frame<3>& frame, const SpacePicture& wanted)
{
  const run_folder::FieldValues<Real>& field = frame.field(wanted.field);
  std::vector<Index> shown;
  std::vector<Real> values;
  for (Index k = 0; k < static_cast<Index>(frame.points.size()); ++k) {
    if (!holds(wanted.view, shown_at(frame.points[k], wanted.view))) continue;
    shown.push_back(k);
    values.push_back(field.at(k));
  }
  if (shown.empty()) return false;
  const std::pair<Real, Real> range = color_range(values);

  IsometricRaster raster(wanted.view.lower, wanted.view.upper, paper_width - paper_left - paper_right);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const Real part = (values[k] - range.first) / (range.second - range.first);
    // Larger than its share, so that neighbours close what lies behind them.
    raster.paint_ball(shown_at(frame.points[shown[k]], wanted.view), 0.75 * std::cbrt(frame.volume[shown[k]]), viridis(part));
  }
  paint_bodies(raster, frame);

  const std::filesystem::path plots = io::make_inner_folder(folder, "plots");
  io::write_atomically(plots / (wanted.name + ".bin"), raster.bytes());
  const int height = raster.rows() + paper_bottom + paper_top;
  const auto part = [](int pixels, int of) { return static_cast<Real>(pixels) / of; };
  std::string script = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
      part(paper_left, paper_width), 1 - part(paper_right, paper_width), part(paper_bottom, height), 1 - part(paper_top, height));
  script += "set termoption font 'DejaVu Sans,26'\n";  // on half a page letters have a third of their size
  script += plot::title_over(wanted.title, paper_width, part(height - paper_top / 2, height));
  script += "unset tics\nunset border\nunset key\nset cbtics\n";
  script += fmt::format("set xrange [0:{}]\nset yrange [0:{}]\nset cbrange [{:g}:{:g}]\n", raster.columns(), raster.rows(), range.first,
                        range.second);
  const std::string words = field.info.label + (field.info.unit.empty() ? "" : " (" + field.info.unit + ")");
  script += fmt::format("set cblabel {}\n", plot::gnuplot_text(words)) + viridis_palette();
  script += axes(raster, plot::length_unit((wanted.view.upper - wanted.view.lower).maxCoeff()));
  script +=
      fmt::format("plot {} binary array=({},{}) format='%uchar%uchar%uchar' origin=(0.5,0.5) dx=1 dy=1 using 1:2:3 with rgbimage, \\\n"
                  "     '+' using (-1):(-1):({:g}) every ::0::0 with points pointsize 0 palette\n",  // for the bar of colours
                  plot::gnuplot_text("./" + wanted.name + ".bin"), raster.columns(), raster.rows(), range.first);
  return plot::draw(folder, wanted.name, paper_width, height, script);
}

}  // namespace berm::soil_plot
