// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/formats_test.cpp
#include "plot/figure.hpp"
#include "record/run_record.hpp"
#include "springs/formats.hpp"

#include <algorithm>

namespace berm::springs {
namespace {

plot::FigureCurve curve_of(const Points& points, const std::string& title, const std::string& style, Real diameter)
{
  plot::FigureCurve curve{title, style, {}, {}};
  for (const Point& p : points) curve.x.push_back(p.x / diameter), curve.y.push_back(p.F / 1000);
  return curve;
}

}  // namespace

std::vector<std::string> draw_springs(const Design& design, const std::filesystem::path& folder)
{
  std::vector<std::string> drawn;
  for (std::size_t k = 0; k < design.best.lateral.size(); ++k) {
    const std::string& stage = design.best.lateral[k].stage;
    plot::Figure figure;
    figure.title = design.name + ", " + stage;
    figure.x_label = "u / D";
    figure.y_label = "H (kN/m)";
    const Real D = design.best.diameter;
    for (std::size_t draw = 0; draw < design.draws.size(); ++draw)
      if (k < design.draws[draw].lateral.size())
        figure.curves.push_back(curve_of(design.draws[draw].lateral[k].curve, draw == 0 ? "computed, runs of the sample" : "",
                                         "lines lc rgb '#b0b0b0' lw 1", D));
    figure.curves.push_back(
        curve_of(design.best.lateral[k].curve, design.draws.empty() ? "computed" : "computed, best", "lines lc rgb '#606060' lw 2", D));
    std::size_t color = 0;
    for (const auto& [set, springs] : sets_of(design))
      if (k < springs->lateral.size())
        figure.curves.push_back(curve_of(springs->lateral[k].spring(), set, plot::curve_style(++color, 0, 3), D));
    Real least = 0, largest = 0;
    for (const plot::FigureCurve& curve : figure.curves)
      for (const Real H : curve.y) least = std::min(least, H), largest = std::max(largest, H);
    constexpr Real visible = 0.01;
    figure.more = least > -visible * largest ? "set key below\nset yrange [0:*]\n" : plot::from_zero;
    const std::string name = design.best.lateral.size() == 1 ? "springs" : "springs." + record::file_name_of(stage);
    if (plot::draw_figure(folder, name, figure)) drawn.push_back(name + ".png");
  }
  return drawn;
}

}  // namespace berm::springs
