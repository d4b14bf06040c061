// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/writer_thread.hpp"
#include "run_folder/frames.hpp"
#include "run_folder/history.hpp"
#include "run_folder/progress.hpp"
#include "run_folder/run_folder.hpp"
#include "simulation/checkpoints.hpp"
#include "simulation/run_clock.hpp"
#include "simulation/simulate.hpp"

namespace berm::simulation {

/// A method that counts iterations, and no particles.
template <class Method>
concept FiniteElements = std::is_same_v<decltype(std::declval<const Method&>().counts()), run_folder::FemCounts>;

/// The run of a problem by a method, MpmMethod<2>, MpmMethod<3>, FemMethod, SpaceFemMethod or PipelineMethod: steps, and what is written on the way. A method builds the problem, takes a
/// step, adds a row, makes a frame, changes to the next stage, names its own part of a checkpoint and says what can be trusted; when each is done is said
/// here, for all of them.
template <class Method>
class Run {
public:
  static constexpr int dim = Method::dim;

  /// Keeps all that it is given, which must outlive it.
  Run(const RunRequest& request, Context& context, Method& method, const run_folder::RunFolder& folder, run_folder::RunLog& log,
      const std::vector<std::string>& warnings);

  /// Reads the checkpoint of a resumed run, or finds and writes the start.
  void begin();
  /// One step, and the output that is due after it. Returns whether the run goes on: it is neither finished nor asked to stop.
  bool advance();
  /// Writes a checkpoint of this moment. Throws RunError where it cannot be written.
  void keep();
  /// The same into another run folder, with the line of the ground: what the run that was resumed has there is of a shorter mesh.
  void keep_in(const std::filesystem::path& run_folder);
  /// After the last step.
  void end();
  /// Waits until all that was handed over to be written is done; of an error the next function tells.
  void come_to_rest() { writer_.come_to_rest(); }
  /// Writes what follows from the history and from the last frame; also of a run that failed after it began.
  void leave_results();
  /// Once its results are there, a finished run needs none.
  void remove_checkpoints() const;
  /// Whether it came to its end, and not where it was asked to stop.
  bool finished() const { return finished_; }
  /// Rows written since it was begun or resumed.
  BigIndex rows() const { return rows_; }

private:
  bool read_checkpoint();
  bool decides_now() const;
  void step();
  void step_of_method();
  void write_checkpoint();
  std::filesystem::path history_path() const { return folder_.file("history.csv"); }
  void archive(Archive& k);
  void archive_progress(Archive& k);
  std::string command_to_lengthen() const;
  void advise_longer_mesh();
  void record();
  bool frame_is_due() const;
  void frame();
  void finish_files();
  void next_stage();
  Real part_done() const;
  void report_progress();

  const problem::Model<dim>& model() const { return method_.model(); }
  const problem::State<dim>& state() const { return method_.state(); }
  const settings::StageSettings& stage() const { return model().stages[state().stage.index]; }
  Index driven() const { return model().driven[state().stage.index]; }

  const RunRequest& request_;
  Context& context_;
  Method& method_;
  run_folder::RunLog& log_;
  const std::vector<std::string>& warnings_;
  const run_folder::RunFolder& folder_;
  RunClock clock_;
  Checkpoints checkpoints_;
  std::optional<run_folder::HistoryFile> history_;
  BigIndex history_bytes_ = 0;  ///< when the last checkpoint was written or read
  run_folder::FrameWriter<dim> frames_;
  /// A frame on its way to the disk.
  struct FrameInHand {
    run_folder::Frame<dim> frame;
    BigIndex piece = 0;  ///< that writes it
  };
  std::array<FrameInHand, 2>
      in_hand_;  ///< the last frame and the one before it, whose memory the next one takes; each stays where it is while it is written
  std::size_t last_in_hand_ = 0;
  run_folder::Progress progress_;
  bool finished_ = false;
  bool advised_ = false;  ///< of a longer mesh
  BigIndex rows_ = 0;
  Real last_row_ = -1, next_row_ = 0, frame_time_ = 0;  ///< s
  Real last_frame_ = -1;                                ///< s, of a frame that this process made
  Vec<dim> frame_displacement_ = Vec<dim>::Zero();
  std::vector<Real> held_forces_;  ///< N/m, V that each stage holds; NaN where none
  std::string unit_;               ///< vector unit that the run was begun on
  /// Beside the steps, unless their threads have all processors: one that compresses would hold up the others, who wait for the one whose processor it takes.
  using Compress = typename run_folder::FrameWriter<dim>::Compress;
  Compress compress_;
  io::WriterThread writer_;  ///< ends before all that it writes
};

}  // namespace berm::simulation
