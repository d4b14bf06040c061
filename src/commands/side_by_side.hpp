// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "commands/case_options.hpp"

namespace berm::commands {

/// Runs cases at the same time, each by a process of its own on one thread, and prints the run.log and the key results of each as it ends. Local processes
/// run each of them anew: finite elements, which hardly gain by threads. For another runner those are left out that have a result of the same case, and those
/// that were stopped go on, unless --force was given; its folder is FOLDER.queue beside the first run folder. The options are those that the
/// requests were read with. Each makes its bands itself, where they are asked for and `with_bands`.
jobs::Outcome run_side_by_side(const std::vector<simulation::RunRequest>& requests, const CaseOptions& options, bool with_bands);

/// Of several runs, beside the folder of the first.
std::filesystem::path queue_of(const std::vector<simulation::RunRequest>& requests);

}  // namespace berm::commands
