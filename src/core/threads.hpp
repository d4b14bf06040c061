// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace berm {

/// The number of processors that this process may use.
int processor_count();

/// Uses `count` threads from now on (0: one for each processor that this process may use) and gives the number. More than one thread are bound to a
/// processor each, unless OMP_PROC_BIND says otherwise: threads that wander can be slower together than one alone.
int use_threads(int count);

/// Starts the program once more with argv and with settings that libraries read from the environment when they are loaded; to be called first of
/// all. Does nothing where the environment says how OpenMP's threads wait.
/// - Threads wait for each other awake for some 30 microseconds and asleep from then on: OpenMP's own choice is to stay awake, which takes the
///   processor from the very thread that is waited for as soon as anything else runs on the machine.
/// - OpenBLAS gets one thread.
void reexec_with_openmp_environment(char** argv);

/// Lets the calling thread run on all processors that the process had before use_threads bound it to one: for processes that it is about to start, which
/// inherit where they may run.
void unbind_thread();

}  // namespace berm
