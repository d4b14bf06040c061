// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"
#include "structures/lateral/lateral_run.hpp"

namespace berm::lateral {

/// How the soil resists a shaft at a depth, freed from noise, at equal steps of the displacement at the seabed: of one of its depth slices (rigid.NAME.depth_slices).
struct PyCurve {
  Real z;               ///< m below the seabed: the middle of the slice
  std::vector<Real> u;  ///< m, displacement at the seabed
  std::vector<Real> y;  ///< m, displacement of the axis at z along the load
  std::vector<Real> p;  ///< N/m, resistance along the load per metre of depth; negative where the soil pushes the shaft on
};

/// Those of a run from the bed down; none without slices, or where the load goes across the direction in which H counts.
std::vector<PyCurve> py_curves(const LateralRun& run);

/// The same by row of the run's loaded stages as a chart of the page, eight depths at most; without curves where there are none.
base::Chart py_chart(const LateralRun& run);

/// py.csv: z_m, u_at_bed_m (the displacement at the seabed), y_m and p_N_m, a row for each point; "" without curves.
std::string py_csv(const LateralRun& run);

/// The curves at the end by depth as an HTML table; "" without curves.
std::string py_table(const LateralRun& run, const std::string& id);

/// p over y, eight depths at most, as SVG and PNG. Gives the names of what was drawn.
std::vector<std::string> draw_py_figure(const LateralRun& run, const std::string& name, const std::filesystem::path& folder);

}  // namespace berm::lateral
