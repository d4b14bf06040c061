// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jobs/outcome.hpp"
#include "simulation/simulate.hpp"
#include "uncertainty/bands.hpp"

namespace berm::uncertainty {

/// Where the variants of a run lie: a folder in its own, with NAME.toml and the run folder NAME for each.
constexpr const char* variants_folder = "uncertainty";

/// Builds every variant of a case and drops it, so that a band that cannot be found is refused before anything runs; prints what they will take. Throws InputError.
void try_to_plan(const simulation::RunRequest& request);

/// Finds the bands of the finished run in request.folder: runs the variants that have no result yet, at_once at a time, each on one thread and from its last checkpoint where one was stopped, and puts what they tell into
/// summary.json, curves.png, run.log and the standard output. Where one fails or Ctrl-C stops it there is no band, and summary.json and stderr say why. The run folder is locked
/// all the while. Unfinished where Ctrl-C stopped it. Throws InputError and RunError.
jobs::Outcome find_bands(const simulation::RunRequest& request, int at_once);

/// The runs that the bands of a run were made of, without those with grains, read from its folder. Throws RunError where one is not there.
std::vector<VariantRecord> variants_of(const record::RunRecord& run);

}  // namespace berm::uncertainty
