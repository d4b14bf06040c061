// SPDX-License-Identifier: BSD-3-Clause
#include "output/gnuplot.hpp"
#include "output/plots.hpp"
#include "output/whole_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm {
namespace {

constexpr int width = 1200, left = 95, right = 175, bottom = 80, top = 70;  // pixels; the plot's height follows from the view
// Ten equally spaced colours of viridis, which is even to the eye and in grey.
constexpr const char* palette =
    "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', "
    "7 '#6ece58', 8 '#b5de2b', 9 '#fde725')\n";

/// The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten; 1 where there is nothing to show.
Real round_up(Real value)
{
  if (!(value > 0)) return 1;
  const Real power = std::pow(10, std::floor(std::log10(value)));
  for (const Real step : {1., 1.5, 2., 3., 4., 5., 6., 8.})
    if (value <= step * power * (1 + 1e-9)) return step * power;
  return 10 * power;
}

/// Radius of the disk that stands for a particle: larger than its share, so that neighbours close the ground between them.
Real shown_radius(const Particle<2>& p)
{
  return std::sqrt(p.volume);
}

}  // namespace

bool draw_soil(const RunFolder& folder, const Frame<2>& frame, SoilColor color, const SoilView& view, const std::string& title)
{
  const bool accumulated = color == SoilColor::deviatoric_strain;
  const std::string name = accumulated ? "soil" : "soil_increment";
  const Vec<2> size = view.upper - view.lower;
  const PlotUnit unit = length_unit(size.maxCoeff());

  folder.subfolder("plots");
  std::string data = fmt::format("# x, y, radius ({}), {} deviatoric strain\n", unit.name, accumulated ? "accumulated" : "incremental");
  std::vector<Real> values;
  for (const FrameParticle<2>& f : frame.particles) {
    const Vec<2>& x = f.particle.x;
    const Real radius = shown_radius(f.particle), value = accumulated ? f.particle.deviatoric_strain : f.strain_increment;
    if ((x.array() < view.lower.array() - radius).any() || (x.array() > view.upper.array() + radius).any()) continue;
    data += fmt::format("{:.6g} {:.6g} {:.4g} {:.5g}\n", x[0] * unit.per_si, x[1] * unit.per_si, radius * unit.per_si, value);
    values.push_back(value);
  }
  if (values.empty()) return false;
  write_whole(folder.file("plots/" + name + ".dat"), data);
  std::string outlines = fmt::format("# x, y ({}) of each rigid body\n", unit.name);
  for (const RigidSurface<2>& rigid : frame.rigids) {
    for (const auto& cell : rigid.cells) {
      for (const Index k : cell.points)
        outlines += fmt::format("{:.6g} {:.6g}\n", rigid.points[k][0] * unit.per_si, rigid.points[k][1] * unit.per_si);
      outlines +=
          fmt::format("{:.6g} {:.6g}\n\n", rigid.points[cell.points[0]][0] * unit.per_si, rigid.points[cell.points[0]][1] * unit.per_si);
    }
  }
  write_whole(folder.file("plots/" + name + "_rigid.dat"), outlines);
  const auto hundredth = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / 100);
  std::nth_element(values.begin(), hundredth, values.end());

  const int plot_width = width - left - right;
  const int plot_height = std::clamp(static_cast<int>(std::lround(plot_width * size[1] / size[0])), 200, 1400);
  const int height = plot_height + bottom + top;
  const auto part = [](int pixels, int of) { return static_cast<Real>(pixels) / of; };
  std::string script = fmt::format(
      "set lmargin at screen {:.4f}\nset rmargin at screen {:.4f}\nset bmargin at screen {:.4f}\nset tmargin at screen {:.4f}\n",
      part(left, width), 1 - part(right, width), part(bottom, height), 1 - part(top, height));
  script += fmt::format("set title {} font 'DejaVu Sans,17'\nset size ratio -1\n", gnuplot_text(title));
  script += fmt::format("set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\n", view.lower[0] * unit.per_si,
                        view.upper[0] * unit.per_si, view.lower[1] * unit.per_si, view.upper[1] * unit.per_si);
  script += fmt::format("set xlabel 'x ({0})'\nset ylabel 'y ({0})'\nset tics out nomirror\nset border lc rgb '#444444'\n", unit.name);
  script += fmt::format("set cblabel '{} deviatoric strain'\nset cbrange [0:{:g}]\n", accumulated ? "accumulated" : "incremental",
                        round_up(*hundredth));
  script += std::string(palette) + "unset key\nset style fill solid noborder\n";
  if (view.surface) {
    const Real level = *view.surface * unit.per_si;
    script += fmt::format("set arrow 1 from {:.6g},{:.6g} to {:.6g},{:.6g} nohead dt 2 lc rgb '#666666' lw 1 front\n",
                          view.lower[0] * unit.per_si, level, view.upper[0] * unit.per_si, level);
  }
  script += fmt::format("plot '{}.dat' using 1:2:3:4 with circles lc palette", name);
  if (!frame.rigids.empty())
    script +=
        fmt::format(", \\\n     '{0}_rigid.dat' with filledcurves closed lc rgb '#c9ccd1', '' with lines lc rgb '#33373d' lw 2", name);
  return draw(folder.path(), name, width, height, script + '\n');
}

}  // namespace berm
