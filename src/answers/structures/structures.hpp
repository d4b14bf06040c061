// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/base/structure.hpp"

namespace berm::structures {

/// All structures that berm knows; the last applies to every case.
const std::vector<base::Structure>& all_structures();

/// The structure of a case: the first that applies to it.
const base::Structure& structure_of(const settings::Case& c);

/// Those of the runs that are of a structure.
base::Runs runs_of(const base::Structure& structure, const std::vector<record::RunRecord>& runs);

/// Reads a run folder (record::read_run); of an unfinished run the quantities are what its structure makes of the history. Throws InputError or RunError where
/// its resolved.toml cannot be read.
record::RunRecord read_run(const std::filesystem::path& folder);

/// All curves of a run as curves.json has them, with the bands of its summary: those of its structure, and what pushes and drags give of any body.
std::string curves_json(const record::RunRecord& run);

/// Writes curves.json into its folder.
void write_curves(const run_folder::RunFolder& folder, const record::RunRecord& run);

}  // namespace berm::structures
