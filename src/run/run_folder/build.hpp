// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary_file.hpp"
#include "settings/case.hpp"

namespace berm::run_folder {

/// Which program computes: the build ids of the executable and of the engine that is loaded, and the vector unit that this engine is for. As entries
/// of `text` in summary.json: program_build, engine_build, vector_unit.
std::vector<std::pair<std::string, std::string>> this_build();

/// Whether a summary was written by this version of berm and by this build of what the method needs: of the engine for the vector unit that the summary
/// names (the material point method) and of the executable, too (finite elements). The machine does not matter, nor when a file was written.
bool by_this_build(const RunSummary& summary, settings::Method method);

/// Whether the executable is the one that wrote the summary: it records what the engine computes and makes the key results of it.
bool recorded_by_this_program(const RunSummary& summary);

/// The vector unit that a run was computed on; "" where its summary does not say.
std::string vector_unit_of(const RunSummary& summary);

}  // namespace berm::run_folder
