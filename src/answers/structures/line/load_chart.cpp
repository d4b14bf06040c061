// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/line/load_curves_test.cpp
#include "plot/panels.hpp"
#include "structures/line/load_curves.hpp"

#include <algorithm>

namespace berm::line {
namespace {

const char* svg_style_of(LoadCurve::By by)
{
  switch (by) {
  case LoadCurve::By::line:
    return "stroke:var(--link);stroke-width:2";
  case LoadCurve::By::constrained:
    return "stroke:var(--quiet);stroke-width:1;stroke-dasharray:2 3";
  case LoadCurve::By::springs:
    return "stroke:#2f8f4e;stroke-width:1.6;stroke-dasharray:7 4";
  case LoadCurve::By::hobbs:
    return "stroke:var(--published);stroke-width:1.6;stroke-dasharray:9 3 2 3";
  }
  return "";
}

}  // namespace

std::string load_chart(const record::RunRecord& run)
{
  const LoadCurves curves = load_curves(run);
  plot::Panels all{.title = run.name + ": compression, lateral displacement and moment over the load",
                   .css_class = "load_chart",
                   .x_label = curves.x_title};
  for (const LoadPanel& panel : curves.panels) {
    plot::Panel drawn{.title = panel.title};
    for (const LoadCurve& curve : panel.curves) {
      for (const Real x : curve.x)
        if (std::isfinite(x)) drawn.left = std::min(drawn.left, x), drawn.right = std::max(drawn.right, x);
      for (const Real y : curve.y)
        if (std::isfinite(y)) drawn.low = std::min(drawn.low, y), drawn.high = std::max(drawn.high, y);
      const bool in_key = &panel == &curves.panels.front();  // P has all
      drawn.curves.push_back({in_key ? curve.name : "", {svg_style_of(curve.by)}, curve.x, curve.y});
    }
    if (drawn.right > drawn.left && drawn.high > drawn.low) all.panels.push_back(std::move(drawn));
  }
  return plot::svg_of(all);
}

}  // namespace berm::line
