// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "springs/formats.hpp"

namespace berm::springs {

/// What is written of one run by itself, but for its springs. `files` throws InputError where it takes a pipeline and the run is of none, RunError where that has not come to its line or
/// line.csv is damaged.
struct LineFormat {
  const char* name;  ///< on the command line
  const char* meaning;
  ExportFiles (*files)(const record::RunRecord& run);
};

/// line.csv: the shape of the line at each frame of its stages.
ExportFiles shape_files(const record::RunRecord& run);
/// Of a pipeline py.csv: u, w, H and V of each slice by row; py_backbone.csv: H and V where a slice goes farther than ever before, freed from noise. Of a pile as pile_files.
ExportFiles py_files(const record::RunRecord& run);
/// py.csv and py_codes.csv: p over y by depth, computed and by codes; the same as nonlinear SPRING elements, py_computed.inp and py_CODE.inp; tz.csv and qz.csv: axial resistance by API.
ExportFiles pile_files(const record::RunRecord& run);
/// curves.json, as a run leaves it.
ExportFiles curve_files(const record::RunRecord& run);

constexpr LineFormat line_formats[] = {
    {"line", "shape, compression and moment of a pipeline over time, as a table", shape_files},
    {"curves", "the curves of a run of any structure, as curves.json", curve_files},
    {"py", "p-y curves of a pipeline's slices, or of a pile with those of codes and its t-z and Q-z, as tables", py_files},
};

}  // namespace berm::springs
