// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"
#include "run_folder/frame.hpp"
#include "run_folder/run_folder.hpp"
#include "run_folder/summary.hpp"

#include <functional>

namespace berm::simulation {

/// The soil and the rigid bodies at the end of a run.
template <int dim>
struct LastState {
  const problem::Model<dim>& model;
  const std::vector<bodies::RigidState<dim>>& rigid_bodies;
  const run_folder::Frame<dim>& frame;
};

/// A run after its end, or where it was stopped or failed.
struct EndedRun {
  const run_folder::RunFolder& folder;
  std::variant<LastState<2>, LastState<3>> last;
  std::vector<Real> held_forces;       ///< N/m, V that each stage was to hold; NaN where none
  run_folder::Summary::Checks checks;  ///< "finished", and those of its method
  record::RunRecord run;               ///< its case, ground and history; its answers add the quantities and what a summary says
};

/// What is known of a run beyond what its method says.
struct Answers {
  std::vector<run_folder::Quantity> quantities;
  std::optional<run_folder::Quantity> force_measure;
  std::vector<std::pair<std::string, std::string>> text;  ///< further entries of Summary::text
  std::vector<std::string> invalid;                       ///< Summary::invalid
  std::string key_results;                                ///< as a table of the log; "" where there is none
};

/// What is made of a run after its end by the program that calls it: its answers, which go to summary.json, then drawings and tables in this order.
struct AfterRun {
  std::function<Answers(EndedRun&)> answers;
  std::vector<std::function<void(const EndedRun&)>> drawings;
};

}  // namespace berm::simulation
