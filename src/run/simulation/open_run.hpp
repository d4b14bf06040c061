// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulation/fem_method.hpp"
#include "simulation/mpm_method.hpp"
#include "simulation/pipeline_method.hpp"
#include "simulation/run.hpp"
#include "simulation/run_place.hpp"
#include "simulation/space_fem_method.hpp"

#include <memory>
#include <optional>
#include <variant>

namespace berm::simulation {

/// A run in the hands of its caller, with all that it needs: built when it is made, then stepped, then ended. Errors go to run.log, too; a run that fails
/// (RunError) leaves the results of what it had before the error is passed on.
template <class Method>
class OpenRun {
public:
  /// Builds the problem, and makes the run folder after that. The context must outlive it. Throws KeyError, InputError and RunError.
  OpenRun(const RunRequest& request, Context& context);

  /// Before the first step: finds and writes the start, or goes to the last checkpoint.
  void begin();
  /// One step, and the output that is due after it. Returns whether the run goes on.
  bool advance();
  /// Writes a checkpoint of this moment into its folder.
  void keep();
  /// Leaves the process's messages to others, and takes them again.
  void step_aside();
  void take_over();
  /// After the last step: writes the results. Returns whether the run came to its end.
  bool end();
  /// The same of a run whose results nobody wants.
  bool end_without_results();
  bool to_the_end();

  const std::filesystem::path& folder() const { return place_->folder().path(); }
  Method& method() { return method_; }
  const Run<Method>& run() const { return run_; }

private:
  template <class Act>
  auto leaving_results(const Act& act);

  RunRequest request_;
  io::ScratchFolder scratch_;
  Method method_;
  std::vector<std::string> warnings_;
  std::optional<RunPlace> place_;  ///< until the run ends: then others may write there
  Run<Method> run_;
};

using AnyOpenRun =
    std::variant<std::unique_ptr<OpenRun<MpmMethod<2>>>, std::unique_ptr<OpenRun<MpmMethod<3>>>, std::unique_ptr<OpenRun<FemMethod>>,
                 std::unique_ptr<OpenRun<SpaceFemMethod>>, std::unique_ptr<OpenRun<PipelineMethod>>>;

/// The run of a case by the method that it names. An error that names a key gets the line where that was written. Throws InputError and RunError.
AnyOpenRun open_run(const RunRequest& request, Context& context);

}  // namespace berm::simulation
