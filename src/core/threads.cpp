// SPDX-License-Identifier: BSD-3-Clause
#include "core/threads.hpp"

#include <cstdlib>
#include <omp.h>
#include <sched.h>
#include <vector>

namespace berm {

int use_threads(int count)
{
  cpu_set_t allowed;
  std::vector<int> processors;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0)
    for (int p = 0; p < CPU_SETSIZE; ++p)
      if (CPU_ISSET(p, &allowed)) processors.push_back(p);
  if (count <= 0) count = processors.empty() ? omp_get_num_procs() : static_cast<int>(processors.size());
  omp_set_num_threads(count);
  if (count == 1 || count > static_cast<int>(processors.size()) || std::getenv("OMP_PROC_BIND") != nullptr) return count;
#pragma omp parallel
  {
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET(processors[omp_get_thread_num()], &own);
    sched_setaffinity(0, sizeof own, &own);
  }
  return count;
}

}  // namespace berm
