// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/step_speed.hpp"

#include "os/interrupt.hpp"
#include "os/threads.hpp"
#include "simulation/run_of_ranks.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

int main(int argc, char** argv)
{
  berm::reexec_with_openmp_environment(argv);
  CLI::App app("measures the speed of the time step on fixed problems, beside a bare kernel", "bench_steps");
  std::vector<std::string> names;
  std::string json;
  int threads = 0;
  app.add_option("NAME", names, "problems (default: all)")->check(CLI::IsMember(berm::bench::problem_names()));
  app.add_option("--json", json, "also write the table to this file");
  app.add_option("--threads", threads, "threads to use (default: OMP_NUM_THREADS, else all processors)")->check(CLI::Range(1, 1024));
  CLI11_PARSE(app, argc, argv);
  try {
    berm::simulation::join_ranks();
    berm::simulation::Context context(threads);
    berm::bench::measure_steps(names, json, context);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_steps: %s\n", error.what());
    return 1;
  }
  return 0;
}
