// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/record/columns_plot_test.cpp
#include "record/panels.hpp"

#include "plot/gnuplot.hpp"

#include <fmt/format.h>

namespace berm::record {

std::string margins(const PanelPlace& place)
{
  return fmt::format("set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n", place.left,
                     place.right, place.bottom, place.top);
}

std::string begin_panels(const std::string& title)
{
  return fmt::format("set multiplot\n"
                     "set label 1 {} at screen 0.5,0.965 center font 'DejaVu Sans,17'\n"
                     "set grid lc rgb '#dddddd' lt 1\nset border lc rgb '#444444'\nset tics nomirror textcolor rgb '#222222'\nset key "
                     "samplen 2 spacing 1.2\n"
                     "push = '#1764ab'\ndrag = '#c8452f'\n",
                     plot::gnuplot_text(title));
}

}  // namespace berm::record
