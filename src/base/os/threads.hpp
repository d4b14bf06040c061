// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sched.h>
#include <vector>

namespace berm {

/// The number of processors that this process may use.
int processor_count();
/// Which they are; none where the system does not say.
std::vector<int> processors();
/// Threads where none are asked for: OMP_NUM_THREADS, at most the processors; else all of them.
int usual_thread_count();

/// From now on this process may use one of `count` equal parts of them, that of this index; all, where there are fewer than parts.
void bind_to_cores(int index, int count);

/// For a thread that was begun beside those of the loops: it may use all processors of the process, and is alone in its loops.
void begin_lone_thread();

/// The threads of the loops of for_each, while it lives: more than one are bound to a processor each, unless OMP_PROC_BIND=false (threads that
/// wander can be slower together than one alone), and numbers below 2e-308 count as zero in them. After it the calling thread has its processors, its
/// number of threads and its arithmetic back. One at a time in a process.
class Threads {
public:
  /// 0: one for each processor that this process may use.
  explicit Threads(int count);
  ~Threads();
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

  int count() const { return count_; }

private:
  int count_, count_before_;
  unsigned arithmetic_before_;   ///< of floating-point numbers: the processor's control word
  cpu_set_t processors_before_;  ///< of the calling thread
  bool bound_;
};

/// Starts the program once more with argv and with settings that libraries read from the environment when they are loaded; to be called first of
/// all. Does nothing where nothing is to be set.
/// - Threads wait for each other awake for some 30 microseconds and asleep from then on, unless the environment says how they wait: OpenMP's own choice is to stay
///   awake, which takes the processor from the very thread that is waited for as soon as anything else runs on the machine.
/// - Where the environment binds threads (OMP_PROC_BIND=true, OMP_PLACES), OpenMP has bound the calling thread by now, and all that it starts would have its processor
///   alone. It gets back the processors of all places, and Threads binds.
/// - OpenBLAS gets one thread.
void reexec_with_openmp_environment(char** argv);

}  // namespace berm
