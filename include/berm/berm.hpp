// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <berm/error.hpp>
#include <berm/law.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

// berm as a library: a case is built, stepped and looked at by a program of the user. SI units and radians; in plane strain forces are N/m, masses kg/m and
// volumes m2. All functions throw InputError and RunError as the program berm reports them.

#pragma GCC visibility push(default)
namespace berm {

/// "0.1.0", of the library that is loaded.
std::string version();

/// What is chosen for a run besides its case.
struct RunOptions {
  std::vector<std::string> set;  ///< changes to the case, KEY=VALUE as in berm run --set
  std::string folder;            ///< where the run leaves what berm run leaves; "": nothing is kept
  bool replace = false;          ///< an earlier run in the folder; otherwise that is refused
  int threads = 1;               ///< 0: one for each processor. More than one are bound to a processor each
  /// Laws of the program, by the name of the material with law = "user": each stands for the library that the case names, and is called by one thread at a time.
  std::map<std::string, std::function<int(berm_law_increment*)>> laws;
  std::function<void(const std::string&)> message;  ///< gets what berm run writes to stderr, line by line; none: nobody does
};

/// A column of a run's history.
struct HistoryColumn {
  std::string name;     ///< as in history.csv: V_N_m
  std::string unit;     ///< SI, as UDUNITS-2 spells it; "1": a bare number
  std::string meaning;  ///< in some words
};

/// A field of the particles of a body, in the memory of the run: the number of a block, component and lane lies block * block_stride + component *
/// component_stride + lane * sizeof(number) bytes behind `data`. A lane holds a particle where its mass is above 0. Components of a stress: xx yy zz xy yz zx (the first
/// four in plane strain), tension positive. The memory stays where it is as long as the run lives; a step changes what it holds and may use more blocks.
struct ParticleField {
  std::string name, unit;
  bool is_integer;  ///< std::int32_t, otherwise double
  const void* data;
  std::size_t blocks, components, lanes;
  std::size_t block_stride, component_stride;  ///< bytes
};

/// A rigid body now. In plane strain z is 0.
struct RigidBodyNow {
  std::string name;
  double centre[3];        ///< m
  double displacement[3];  ///< since the start, m
  double velocity[3];      ///< m/s
  double force[3];         ///< of the soil on it in the last step, N/m or N
};

/// One run in the hands of its caller. A process has one at a time that has not ended: a second is a RunError. Until it ends, the calling thread flushes denormal
/// numbers to zero, and with several threads it is bound to a processor (not where OMP_PROC_BIND=false). A run that is destroyed before its end leaves what a
/// killed process does: resume() goes on from its last checkpoint.
class Run {
public:
  /// Reads and builds the case, and finds its start.
  explicit Run(const std::string& case_file, const RunOptions& options = {});
  /// Continues the unfinished run in a folder from its last checkpoint; of the options, `set`, `folder` and `replace` must not be given.
  static Run resume(const std::string& folder, const RunOptions& options = {});
  ~Run();
  Run(Run&&) noexcept;
  Run& operator=(Run&&) noexcept;

  /// Steps so often, or to the end of the last stage, where the results are written to the folder. Returns whether the run goes on. A step of finite elements is
  /// an increment.
  bool step(long long count = 1);
  /// Steps until a row is added to the history, or to the end. Returns whether the run goes on.
  bool step_to_row();
  /// Steps to the end.
  void finish();
  /// Ends the run where it is: results of what was computed and a checkpoint go to the folder, from which resume() continues.
  void stop();

  /// Whether nothing is left to do: it came to its end, or was stopped.
  bool ended() const;
  /// Whether it came to the end of its last stage.
  bool finished() const;
  long long steps() const;
  double time() const;       ///< s
  double time_step() const;  ///< s, of the last step
  std::string stage() const;

  /// Columns of the history but for the stage, and the numbers of its last row.
  const std::vector<HistoryColumn>& columns() const;
  const std::vector<double>& row() const;

  int dimension() const;                    ///< 2: plane strain; 3: space
  std::vector<std::string> bodies() const;  ///< deformable bodies; none of finite elements, which have no particles
  /// The fields of a body's particles. Throws InputError where there is no such body.
  std::vector<ParticleField> particles(const std::string& body) const;
  std::vector<RigidBodyNow> rigid_bodies() const;

private:
  struct Parts;
  explicit Run(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace berm
#pragma GCC visibility pop
