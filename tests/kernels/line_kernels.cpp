// SPDX-License-Identifier: BSD-3-Clause
// A step of a pipeline, and its matrix by itself and by Eigen (docs/decisions/0073).
#include "beam/step.hpp"
#include "kernels.hpp"
#include "macro_element/under_force.hpp"
#include "samples/macro_element_parameters.hpp"

#include <Eigen/SparseCholesky>
#include <benchmark/benchmark.h>

namespace berm {
namespace {

constexpr Index line_nodes = 103, line_freedoms = 5 * line_nodes, line_band = 9;

void factorize_band(benchmark::State& state)
{
  beam::BandMatrix matrix(line_freedoms, line_band);
  std::vector<Real> values(line_freedoms);
  beam::BandMatrix filled = matrix;
  for (Index i = 0; i < line_freedoms; ++i)
    for (Index j = std::max(0, i - line_band); j <= i; ++j) filled.add(i, j, i == j ? 40 : 1. / (1 + i - j));
  Index negative = 0;
  for (auto _ : state) {
    matrix = filled;
    negative += matrix.factorize();
    std::fill(values.begin(), values.end(), 1);
    matrix.solve(values);
    benchmark::DoNotOptimize(values.data());
  }
  if (negative != 0) state.SkipWithError("the matrix is positive definite");
}

void factorize_by_eigen(benchmark::State& state)
{
  std::vector<Eigen::Triplet<Real>> entries;
  for (Index i = 0; i < line_freedoms; ++i)
    for (Index j = std::max(0, i - line_band); j <= i; ++j) entries.emplace_back(i, j, i == j ? 40 : 1. / (1 + i - j));
  Eigen::SparseMatrix<Real> matrix(line_freedoms, line_freedoms);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>, Eigen::Lower, Eigen::NaturalOrdering<int>> solver;
  solver.analyzePattern(matrix);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(line_freedoms);
  Eigen::VectorXd values = ones;
  for (auto _ : state) {
    solver.factorize(matrix);
    values = solver.solve(ones);
    benchmark::DoNotOptimize(values.data());
  }
  if (solver.info() != Eigen::Success) state.SkipWithError("the matrix is positive definite");
}

/// A line in both planes on its springs or macro-elements, swinging, so that each step has one iteration.
void step_line(benchmark::State& state, bool on_macro_elements)
{
  std::vector<Real> x(line_nodes);
  for (Index i = 0; i < line_nodes; ++i) x[i] = i;
  beam::Line line = beam::straight_line(std::move(x), {69.4e6, 3.74e9, 330, 330, 1500, 0.2}, {beam::Plane::lateral, beam::Plane::vertical});
  const std::vector<Real> lengths = lengths_of_nodes(line);
  if (on_macro_elements) {
    const macro_element::Parameters soil = macro_element::sample_parameters();
    add_macro_elements(line, soil, lengths, macro_element::laid(soil, 2500, 1500));
  } else {
    add_springs(line, beam::Direction::axial, beam::friction(900, 1e-3), lengths);
    add_springs(line, beam::Direction::lateral, beam::friction(900, 1e-3), lengths);
    add_springs(line, beam::Direction::vertical, beam::OneSidedSpring{1e5}, lengths);
  }
  beam::State now = state_of(line);
  beam::Work work(line);
  beam::Loads loads = no_loads(line);
  add_weight(line, loads);
  BigIndex iterations = 0;
  for (auto _ : state) iterations += step(line, loads, 1e-3, now, work).iterations;
  if (iterations > 2 * state.iterations()) state.SkipWithError("a step has more than two iterations");
}

}  // namespace

void add_line_kernels()
{
  benchmark::RegisterBenchmark("line/factorize/band", factorize_band);
  benchmark::RegisterBenchmark("line/factorize/eigen", factorize_by_eigen);
  benchmark::RegisterBenchmark("line/step/springs", step_line, false);
  benchmark::RegisterBenchmark("line/step/macro_elements", step_line, true);
}

}  // namespace berm
