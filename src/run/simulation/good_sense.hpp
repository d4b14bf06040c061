// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sanity/sanity.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// Whether what a case asks for makes sense.
struct Diagnostics {
  std::vector<input::Located> refusals, warnings;
};
Diagnostics diagnose(const sanity::Scene& scene);

/// Throws LocatedError with the first refusal; others go to stderr before it.
void throw_refusals(const Diagnostics& doubts);

/// The warnings, "FILE:LINE: KEY: MESSAGE" each, of a case without refusals; others are thrown.
std::vector<std::string> warnings_of(const sanity::Scene& scene);

/// What is free on the disk of the folder, or of the nearest one above it that exists, bytes.
Real free_disk(const std::filesystem::path& folder);

/// Keeps the warnings in the run folder for a run that is resumed, and reads them there.
void note_warnings(const std::filesystem::path& run_folder, const std::vector<std::string>& warnings);
std::vector<std::string> noted_warnings(const std::filesystem::path& run_folder);

}  // namespace berm::simulation
