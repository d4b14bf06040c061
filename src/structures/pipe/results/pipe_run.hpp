// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "structures/pipe/results/pipe_quantities.hpp"

namespace berm::pipe {

/// The pushes and the drags of a case; held_force is left empty.
PipeStages pipe_stages(const problem::Case& c);

/// A run as that of a pipe: the record, which must outlive it, with what its results are measured by.
struct PipeRun {
  explicit PipeRun(const record::RunRecord& run, std::size_t place = 0);

  const record::RunRecord& record;
  const std::string& name;
  const problem::Case& settings;
  const run_folder::History& history;
  const std::vector<run_folder::Quantity>& quantities;
  record::RunEnd end;
  BodyScale scale;
  PipeStages stages;
  std::size_t place;  ///< on the page, which gives its colour
};

using PipeRuns = std::vector<PipeRun>;

}  // namespace berm::pipe
