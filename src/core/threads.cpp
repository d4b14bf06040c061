// SPDX-License-Identifier: BSD-3-Clause
#include "core/threads.hpp"

#include <cstdlib>
#include <filesystem>
#include <omp.h>
#include <sched.h>
#include <string>
#include <unistd.h>
#include <vector>
#ifdef __SSE2__
#include <pmmintrin.h>
#endif

namespace berm {
namespace {

/// Numbers below 2e-308, which a stress wave leaves ahead of itself, take a processor many times as long as others.
void flush_denormals_to_zero()
{
#ifdef __SSE2__
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

/// Those that this process may use, as it was before any of its threads was bound; none where the system does not say.
const std::vector<int>& allowed_processors()
{
  static const std::vector<int> processors = [] {
    cpu_set_t allowed;
    std::vector<int> found;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
      for (int p = 0; p < CPU_SETSIZE; ++p)
        if (CPU_ISSET(p, &allowed)) found.push_back(p);
    return found;
  }();
  return processors;
}

}  // namespace

int processor_count()
{
  const std::vector<int>& processors = allowed_processors();
  return processors.empty() ? omp_get_num_procs() : static_cast<int>(processors.size());
}

int use_threads(int count)
{
  const std::vector<int>& processors = allowed_processors();
  if (count <= 0) count = processor_count();
  omp_set_num_threads(count);
  const bool bind = count > 1 && count <= static_cast<int>(processors.size()) && std::getenv("OMP_PROC_BIND") == nullptr;
#pragma omp parallel
  {
    flush_denormals_to_zero();
    cpu_set_t own;
    CPU_ZERO(&own);
    if (bind) CPU_SET(processors[omp_get_thread_num()], &own);
    if (bind) sched_setaffinity(0, sizeof own, &own);
  }
  return count;
}

void unbind_thread()
{
  cpu_set_t all;
  CPU_ZERO(&all);
  for (const int processor : allowed_processors()) CPU_SET(processor, &all);
  if (!allowed_processors().empty()) sched_setaffinity(0, sizeof all, &all);
}

void reexec_with_openmp_environment(char** argv)
{
  constexpr const char* spins = "GOMP_SPINCOUNT";
  if (std::getenv(spins) != nullptr || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  // Where the loader was called by name, it is the program that would be started.
  if (error || program.filename().string().starts_with("ld-") || setenv(spins, "10000", 1) != 0) return;
  setenv("OPENBLAS_NUM_THREADS", "1", 0);  // its threads gain nothing on matrices of this size, and spin
  // Where this fails, the run goes on, only slower.
  execv(program.c_str(), argv);
}

}  // namespace berm
