// SPDX-License-Identifier: BSD-3-Clause
#include "core/vector_unit.hpp"
#include "kernels.hpp"

#include <benchmark/benchmark.h>

int main(int count, char** words)
{
  benchmark::AddCustomContext("vector unit", berm::vector_unit());
  berm::add_stress_kernels();
  berm::add_lane_kernels();
  berm::add_mesh_kernels();
  berm::add_contact_kernels();
  berm::add_surface_kernels();
  berm::add_tangent_kernels();
  berm::add_line_kernels();
  benchmark::Initialize(&count, words);
  if (benchmark::ReportUnrecognizedArguments(count, words)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
