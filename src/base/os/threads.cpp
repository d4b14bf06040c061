// SPDX-License-Identifier: BSD-3-Clause
#include "os/threads.hpp"

#include "os/control_group.hpp"

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <omp.h>
#include <sched.h>
#include <string_view>
#include <unistd.h>
#ifdef __SSE2__
#include <pmmintrin.h>
#endif

namespace berm {
namespace {

/// The processor's control word of floating-point arithmetic; 0 where there is none.
unsigned arithmetic()
{
#ifdef __SSE2__
  return _mm_getcsr();
#else
  return 0;
#endif
}
void set_arithmetic([[maybe_unused]] unsigned control_word)
{
#ifdef __SSE2__
  _mm_setcsr(control_word);
#endif
}

/// Numbers below 2e-308, which a stress wave leaves ahead of itself, take a processor many times as long as others.
void flush_denormals_to_zero()
{
#ifdef __SSE2__
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

/// Those that this process may use, as it was before any of its threads was bound; none where the system does not say.
std::vector<int>& allowed_processors()
{
  static std::vector<int> processors = [] {
    cpu_set_t allowed;
    std::vector<int> found;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
      for (int p = 0; p < CPU_SETSIZE; ++p)
        if (CPU_ISSET(p, &allowed)) found.push_back(p);
    return found;
  }();
  return processors;
}

/// As the control groups were when they were first asked for.
Real processors_of_groups()
{
  static const Real processors = ControlGroups().processors();
  return processors;
}

/// Lets the calling thread use all of them.
void allow_all_processors()
{
  cpu_set_t all;
  CPU_ZERO(&all);
  for (const int processor : allowed_processors()) CPU_SET(processor, &all);
  sched_setaffinity(0, sizeof all, &all);
}

/// Gives the calling thread, which OpenMP has bound to the first of its places, the processors of all of them.
void let_go_of_places()
{
  cpu_set_t all;
  CPU_ZERO(&all);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> processors(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, processors.data());
    for (const int processor : processors) CPU_SET(processor, &all);
  }
  sched_setaffinity(0, sizeof all, &all);
}

}  // namespace

int processor_count()
{
  const std::vector<int>& processors = allowed_processors();
  const int count = processors.empty() ? omp_get_num_procs() : static_cast<int>(processors.size());
  return std::max(1, static_cast<int>(std::min<Real>(count, processors_of_groups())));
}

std::vector<int> processors()
{
  return allowed_processors();
}

int usual_thread_count()
{
  const char* named = std::getenv("OMP_NUM_THREADS");
  const int count = named == nullptr ? 0 : std::atoi(named);  // of nested loops, which there are none, the first
  return count > 0 ? std::min(count, processor_count()) : processor_count();
}

void bind_to_cores(int index, int count)
{
  std::vector<int>& all = allowed_processors();
  const int size = static_cast<int>(all.size()) / count;
  if (size > 0) all = std::vector<int>(all.begin() + index * size, all.begin() + (index + 1) * size);
}

void begin_lone_thread()
{
  allow_all_processors();
  omp_set_num_threads(1);
}

Threads::Threads(int count)
    : count_(count > 0 ? count : usual_thread_count()),
      count_before_(omp_get_max_threads()),
      arithmetic_before_(arithmetic())
{
  const std::vector<int>& processors = allowed_processors();
  CPU_ZERO(&processors_before_);
  sched_getaffinity(0, sizeof processors_before_, &processors_before_);
  // A share of the time of all processors is better taken where there is time.
  const bool shares = processors_of_groups() < static_cast<Real>(processors.size());
  bound_ = count_ > 1 && count_ <= static_cast<int>(processors.size()) && !shares && std::getenv("OMP_PROC_BIND") == nullptr;
  omp_set_num_threads(count_);
#pragma omp parallel
  {
    flush_denormals_to_zero();
    cpu_set_t own;
    CPU_ZERO(&own);
    if (bound_) CPU_SET(processors[omp_get_thread_num()], &own);
    if (bound_) sched_setaffinity(0, sizeof own, &own);
  }
}

Threads::~Threads()
{
  cpu_set_t all;
  CPU_ZERO(&all);
  for (const int processor : allowed_processors()) CPU_SET(processor, &all);
#pragma omp parallel
  {
    set_arithmetic(arithmetic_before_);
    if (bound_) sched_setaffinity(0, sizeof all, omp_get_thread_num() == 0 ? &processors_before_ : &all);
  }
  omp_set_num_threads(count_before_);
}

void reexec_with_openmp_environment(char** argv)
{
  constexpr const char* spins = "GOMP_SPINCOUNT";
  const bool wait_is_open = std::getenv(spins) == nullptr && std::getenv("OMP_WAIT_POLICY") == nullptr, is_bound = omp_get_num_places() > 0;
  // Without memory, for want of which main() could not end in order.
  char program[PATH_MAX] = "";
  if ((!wait_is_open && !is_bound) || readlink("/proc/self/exe", program, sizeof program - 1) <= 0) return;
  // Where the loader was called by name, it is the program that would be started.
  if (std::string_view(program).substr(std::string_view(program).rfind('/') + 1).starts_with("ld-")) return;
  if (wait_is_open && setenv(spins, "10000", 1) != 0) return;
  if (is_bound) {
    let_go_of_places();
    for (const char* name : {"OMP_PROC_BIND", "OMP_PLACES", "GOMP_CPU_AFFINITY"}) unsetenv(name);
  }
  setenv("OPENBLAS_NUM_THREADS", "1", 0);  // its threads gain nothing on matrices of this size, and spin
  // Where this fails, the run goes on, only slower.
  execv(program, argv);
}

}  // namespace berm
