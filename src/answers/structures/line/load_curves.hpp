// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/run_folder.hpp"
#include "structures/base/structure.hpp"

namespace berm::line {

/// A curve over the load of the line.
struct LoadCurve {
  enum class By { line, constrained, springs, hobbs };
  By by;
  std::string name;
  std::vector<Real> x, y;  ///< in the units of the panel
};

/// Curves of one number over the load.
struct LoadPanel {
  std::string name;   ///< of a file: "P", "y", "M"
  std::string title;  ///< "compression P (kN)"
  std::vector<LoadCurve> curves;
};

/// P, y and M of a run over the rise of temperature; of a line that is not heated over that of pressure, of one that is neither over time.
struct LoadCurves {
  std::string x_title;
  std::vector<LoadPanel> panels;  ///< none where the line has not been loaded
};
LoadCurves load_curves(const record::RunRecord& run);

/// curves.png of a run. False, with a warning, where it could not be drawn.
bool draw_load_curves(const run_folder::RunFolder& folder, const record::RunRecord& run);

/// pipeline_P, pipeline_y, pipeline_M of all runs over one another, as SVG and PNG. Gives their names.
std::vector<std::string> draw_load_figures(const base::Runs& runs, const std::filesystem::path& folder);

/// The curves of a run as an SVG for the page; "" where there is none.
std::string load_chart(const record::RunRecord& run);

}  // namespace berm::line
