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
  bool (*takes)(const Springs& springs);  ///< whether there is something among them that it can write
  bool whole_life = false;                ///< it takes the drags of all states, unless some are asked for
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

/// Whether there is a spring, or a stiffness of V over w of a pipe that V presses onto the bed.
bool takes_numbers(const Springs& springs);
/// Whether there is a spring.
bool takes_points(const Springs& springs);
/// Whether there is a vertical spring, or another one under a V that is positive.
bool takes_profiles(const Springs& springs);
/// Whether there is a lateral or an axial spring under a V that is positive.
bool takes_coefficients(const Springs& springs);
/// Whether there is a lateral spring with a stiffness under a V that is positive.
bool takes_components(const Springs& springs);
/// Whether there is a lateral spring under a V that is positive, or no drag but a stiffness of V over w.
bool takes_options(const Springs& springs);

constexpr Format formats[] = {
    {"table", "CSV tables for a spreadsheet", table_files, takes_numbers},
    {"json", "all results, machine-readable", json_files, takes_numbers},
    {"abaqus", "pipe-soil interaction elements", abaqus_files, takes_points},
    {"orcaflex", "tables of a seabed's tangential resistance", orcaflex_files, takes_profiles},
    {"ansys", "COMBIN39 springs", ansys_files, takes_points},
    {"sima", "seafloor contact of RIFLEX", sima_files, takes_components},
    {"calculix", "nonlinear SPRING2 elements", calculix_files, takes_points},
    {"opensees", "zeroLength elements of OpenSeesPy", opensees_files, takes_points},
    {"moordyn", "friction and stiffness of the bottom", moordyn_files, takes_options},
    {"buckpy", "rows of the sheet Soils", buckpy_files, takes_coefficients, true},
};

/// Throws RunError, which says why, where there is nothing that the program can take.
void check_taken(const Design& design, const Format& format);

/// The springs of a design by the name of their estimate: best, and low and high where there is a sample.
std::vector<std::pair<std::string, const Springs*>> sets_of(const Design& design);

/// springs.png for each drag: the estimates over what the runs of the sample computed. Gives the names of what was drawn.
std::vector<std::string> draw_springs(const Design& design, const std::filesystem::path& folder);

}  // namespace berm::springs
