// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "springs/design.hpp"

namespace berm::springs {

/// A file for another program: its name, and what it holds.
struct ExportFile {
  std::string name, text;
};
using ExportFiles = std::vector<ExportFile>;

/// A program that springs go to.
struct Format {
  const char* name;  ///< on the command line
  const char* meaning;
  ExportFiles (*files)(const Design& design);
  bool whole_life = false;  ///< it takes the drags of all states, unless some are asked for
};

/// springs.csv: each number with its estimates and fit; curves.csv: the springs point by point, and what was computed. SI units.
ExportFiles table_files(const Design& design);
/// springs.json: all of it.
ExportFiles json_files(const Design& design);
/// springs_BEST.inp ...: *PIPE-SOIL STIFFNESS of pipe-soil interaction elements, N and m.
ExportFiles abaqus_files(const Design& design);
/// springs_BEST.csv ...: tables of the resistance over the displacement for a seabed's tangential resistance, and of the reaction over the penetration; kN and m.
ExportFiles orcaflex_files(const Design& design);
/// springs_BEST.mac ...: real constants of COMBIN39 springs for a length of pipe, N and m.
ExportFiles ansys_files(const Design& design);
/// springs_BEST.inp ...: seafloor contact components of RIFLEX, which know one friction coefficient: kN and m.
ExportFiles sima_files(const Design& design);

/// springs_BEST_SPRING.inp ...: nonlinear SPRING2 elements for 1 m of pipe, N and m.
ExportFiles calculix_files(const Design& design);
/// springs_BEST.py ...: a module with the points of zeroLength elements, N and m.
ExportFiles opensees_files(const Design& design);
/// springs_BEST.txt ...: friction and stiffness of the bottom, as options.
ExportFiles moordyn_files(const Design& design);
/// soils.csv: coefficients of friction, a row for each travel of the sheet Soils.
ExportFiles buckpy_files(const Design& design);

constexpr Format formats[] = {
    {"table", "CSV tables for a spreadsheet", table_files},
    {"json", "all of it for a program to read", json_files},
    {"abaqus", "pipe-soil interaction elements", abaqus_files},
    {"orcaflex", "tables of a seabed's tangential resistance", orcaflex_files},
    {"ansys", "COMBIN39 springs", ansys_files},
    {"sima", "seafloor contact of RIFLEX", sima_files},
    {"calculix", "nonlinear SPRING2 elements", calculix_files},
    {"opensees", "zeroLength elements of OpenSeesPy", opensees_files},
    {"moordyn", "friction and stiffness of the bottom", moordyn_files},
    {"buckpy", "rows of the sheet Soils", buckpy_files, true},
};

/// The springs of a design by the name of their estimate: best, and low and high where there is a sample.
std::vector<std::pair<std::string, const Springs*>> sets_of(const Design& design);

/// springs.png for each drag: the estimates over what the runs of the sample computed. Gives the names of what was drawn.
std::vector<std::string> draw_springs(const Design& design, const std::filesystem::path& folder);

}  // namespace berm::springs
