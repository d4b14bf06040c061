// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/base/observable.hpp"

#include <memory>

namespace berm::pipe {

/// What a claim may be about: numbers that a run with a pipe gives. Lengths are in D, areas in D2, forces in N/m; u is counted from the begin of the drag.
const base::Observables& pipe_observables();

/// A run, which must outlive it, as claims look at it.
std::unique_ptr<base::ObservedRun> observed_pipe(const record::RunRecord& run);

}  // namespace berm::pipe
