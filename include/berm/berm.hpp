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
  double centre[3];            ///< m
  double displacement[3];      ///< since the start, m
  double embedment;            ///< of its lowest point below the bed's first surface, m: w of the history
  double velocity[3];          ///< m/s
  double angular_velocity[3];  ///< rad/s; in plane strain about z
  double force[3];             ///< of the soil on it in the last step, N/m or N
  double torque[3];            ///< the same about its centre, N or N m
  /// Of the soil on it since the start, N s/m or N s (0 of finite elements); about the centre as it was then, N s or N m s. The difference of two readings over the time between them is
  /// the mean force and torque.
  double impulse[3], angular_impulse[3];
};

/// A freedom of a rigid body: displacement of its centre along an axis, rotation about z in plane strain, about an axis in space.
enum class Freedom { x, y, z, rotation, rotation_x, rotation_y, rotation_z };

/// One run in the hands of its caller. A process may have several of one thread each, whose functions are called by one thread at a time, and not from a law or a
/// `message` of another; one of several threads must be alone until it ends, or there is a RunError. While a function works (with several threads: until the run
/// ends) the calling thread flushes denormal numbers to zero, and with several threads it is bound to a processor (not where OMP_PROC_BIND=false). A run that is
/// destroyed before its end leaves what a killed process does: resume() goes on from its last checkpoint.
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

  /// A second run in the state that this one is in, which goes on by itself to the same bits. It has a folder of its own, "": nothing is kept; a folder that is
  /// not empty, or lies in that of this run, is an InputError. Laws and messages go where those of this run go. A run with fills or excavations is cloned between them: where one may be due, at every
  /// sixteenth step, this is a RunError.
  Run clone(const std::string& folder = "");

  /// Drives a freedom of the body that the present stage drives otherwise than the stage says, from the next step on until another call or the end of the stage: by a
  /// velocity (m/s; of a rotation rad/s), or a force (N/m, in space N; of a rotation a moment, N or N m). Of stages of kind "drive", in the material point method;
  /// otherwise an InputError.
  void drive_by_velocity(Freedom freedom, double velocity);
  void drive_by_force(Freedom freedom, double force);
  /// No step is longer than this from now on, s, more than 0; infinity: any that is stable. It is kept in checkpoints, as drives are.
  void limit_time_step(double longest);

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

  int dimension() const;  ///< 2: plane strain, or around an axis; 3: space
  bool is_axisymmetric() const;
  std::vector<std::string> bodies() const;  ///< deformable bodies; none of finite elements, which have no particles
  /// The fields of a body's particles. Throws InputError where there is no such body.
  std::vector<ParticleField> particles(const std::string& body) const;
  std::vector<RigidBodyNow> rigid_bodies() const;
  /// Of the soil at the nodes that contacts moved in the last step, kg/m or kg; 0 before the first one of a run, of a clone and of what was resumed, and of finite elements.
  double contact_mass() const;

private:
  struct Parts;
  explicit Run(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace berm
#pragma GCC visibility pop
