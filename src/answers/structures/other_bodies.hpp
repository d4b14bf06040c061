// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::structures {

/// All quantities of a run: those of its structure, which are of the main rigid body, and of each other one that a stage drives the same, named by it: "old.V_end_of_push".
std::vector<run_folder::Quantity> quantities_of(const record::RunRecord& run, const std::vector<Real>& held_forces);

/// Those that a run may have, as Structure::quantity_names; none where they are not known before the run.
std::vector<std::string> quantity_names_of(const settings::Case& c);

/// The rigid bodies but the main one that stages drive, in the order of the case.
std::vector<std::string> other_driven_bodies(const settings::Case& c);

}  // namespace berm::structures
