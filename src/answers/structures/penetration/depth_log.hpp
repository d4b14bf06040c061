// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// A curve of a log: values against depth, in the units of its panel and of the log.
struct LogCurve {
  enum class Line {
    rows,
    mean,
    level
  };                 ///< each row; averaged; a number that does not vary with depth, or the stress and strength of the soil
  std::string name;  ///< "" = not in the key
  Line line;
  std::size_t run;  ///< its colour
  std::vector<Real> value, depth;
};

struct LogPanel {
  std::string label;  ///< of the axis on top, with unit, plain
  std::vector<LogCurve> curves;
  Real max = 0;  ///< end of the axis
};

/// Resistance against depth as a CPT log shows it: depth downwards, panels beside one another, their axes on top.
struct DepthLog {
  std::string title, depth_label;
  Real shallowest = 0,
       deepest = 0;    ///< ends of the depth axis: from the surface, or from where a body begins that is above it or begins deep
  Real per_width = 0;  ///< D in the unit of depth of the first run: an axis of z/D where all runs have this width; else 0
  std::vector<LogPanel> panels;
};

/// Of runs of one reading; no panels where none has rows.
DepthLog depth_log(const PenetrationRuns& runs, const std::string& title);

/// As an SVG for the page, in its colours.
std::string svg_of(const DepthLog& log);

/// As a script of gnuplot, with its data in FOLDER/plots/NAME_K.dat.
std::string script_of(const DepthLog& log, const std::filesystem::path& folder, const std::string& name);

}  // namespace berm::penetration
