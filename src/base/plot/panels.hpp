// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plot/figure.hpp"

namespace berm::plot {

/// How a curve is drawn: on the page in its colours (CSS), and by gnuplot.
struct CurveStyle {
  std::string css, gnuplot = {};
};
CurveStyle thin_style(std::size_t color);
CurveStyle thick_style(std::size_t color);
CurveStyle published_style();

/// A curve of a panel, broken where it leaves the panel or where a number is NaN.
struct PanelCurve {
  std::string name;  ///< in the key; "" = not there
  CurveStyle style;
  std::vector<Real> x, y;
  bool is_symbol = false;  ///< what follows a _ in its name stands below the line
};

struct Panel {
  std::string title;                            ///< what follows a _ stands below the line
  Real left = 0, right = 0, low = 0, high = 0;  ///< ends of its axes
  std::vector<PanelCurve> curves = {};
};

/// Panels side by side.
struct Panels {
  std::string title, css_class;
  std::string x_label = {}, y_label = {};  ///< of x below each panel, of y beside the first; "" = none
  bool downwards = false;                  ///< y is a depth: one axis for all panels, and x stands above them
  Real width = 300, height = 230;          ///< pixels on the page, of a panel
  std::vector<Panel> panels = {};
  Real second = 0;  ///< y over this on an axis at the right; 0: there is none
  std::string second_label = {};
};

/// As an SVG for the page; "" without panels.
std::string svg_of(const Panels& all);

}  // namespace berm::plot
