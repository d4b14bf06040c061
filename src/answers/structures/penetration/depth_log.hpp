// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plot/panels.hpp"
#include "structures/penetration/penetration_run.hpp"

namespace berm::penetration {

/// Resistance against depth of runs of one penetrometer, as a CPT log shows it: depth downwards, panels beside one another, their axes on top; an axis of z/D where all
/// runs have one width. No panels where none has rows.
plot::Panels depth_log(const PenetrationRuns& runs, const std::string& title);

/// As a script of gnuplot, with its data in FOLDER/plots/NAME_K.dat.
std::string script_of(const plot::Panels& log, const std::filesystem::path& folder, const std::string& name);

}  // namespace berm::penetration
