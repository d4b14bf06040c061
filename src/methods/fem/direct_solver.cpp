// SPDX-License-Identifier: BSD-3-Clause
#include "fem/direct_solver.hpp"

#include "core/timer.hpp"
#include "fem/blas.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <dmumps_c.h>
#include <fmt/format.h>

namespace berm::fem {

Index SparsePattern::index_of(Index row, Index col) const
{
  const auto begin = column.begin() + first[row], end = column.begin() + first[row + 1];
  return static_cast<Index>(std::lower_bound(begin, end, col) - column.begin());
}

struct DirectSolver::Mumps {
  DMUMPS_STRUC_C call{};
  std::vector<MUMPS_INT> row, column, kept;  // counted from 1
  std::vector<Real> entries, kept_matrix, kept_part;

  // The names of controls in the users' guide count from 1.
  MUMPS_INT& control(int number) { return call.icntl[number - 1]; }
  MUMPS_INT run(int job)
  {
    const OneBlasThread one;
    call.job = job;
    dmumps_c(&call);
    return call.infog[0];
  }
};

DirectSolver::DirectSolver(const SparsePattern& pattern, const std::vector<Index>& kept, MatrixKind kind, Ordering ordering)
    : mumps_(std::make_unique<Mumps>())
{
  const Timer timer("order equations");
  Mumps& m = *mumps_;
  for (Index r = 0; r < pattern.size(); ++r)
    for (Index k = pattern.first[r]; k < pattern.first[r + 1]; ++k) {
      m.row.push_back(r + 1);
      m.column.push_back(pattern.column[k] + 1);
    }
  if (kind == MatrixKind::unsymmetric) {
    const std::vector<MUMPS_INT> row = m.row, column = m.column;
    m.row.insert(m.row.end(), column.begin(), column.end());
    m.column.insert(m.column.end(), row.begin(), row.end());
  }
  m.entries.resize(m.row.size());
  m.call.par = 1;
  m.call.sym = kind == MatrixKind::unsymmetric ? 0 : kind == MatrixKind::indefinite ? 2 : 1;
  m.call.comm_fortran = -987654;  // MPI_COMM_WORLD
  m.run(-1);
  for (const int stream : {1, 2, 3}) m.control(stream) = 0;  // no messages
  m.control(4) = 0;
  m.control(6) = 0;  // no column permutation: the diagonal is suitable
  m.control(7) = ordering == Ordering::scotch ? 3 : 4;
  m.control(14) = 60;  // per cent of memory beyond the estimate of the analysis phase
  m.call.n = pattern.size();
  m.call.nnz = static_cast<MUMPS_INT8>(m.row.size());
  m.call.irn = m.row.data();
  m.call.jcn = m.column.data();
  m.call.a = m.entries.data();
  if (!kept.empty()) {
    for (const Index unknown : kept) m.kept.push_back(unknown + 1);
    m.kept_matrix.resize(kept.size() * kept.size());
    m.kept_part.resize(kept.size());
    m.control(19) = 1;  // the Schur complement by rows
    m.call.size_schur = m.call.lredrhs = static_cast<MUMPS_INT>(kept.size());
    m.call.listvar_schur = m.kept.data();
    m.call.schur = m.kept_matrix.data();
    m.call.redrhs = m.kept_part.data();
    m.call.nrhs = 1;
  }
  if (const MUMPS_INT error = m.run(1); error < 0) throw RunError(fmt::format("MUMPS cannot order the equations (error {})", error));
}

DirectSolver::~DirectSolver()
{
  mumps_->run(-2);
}

Real DirectSolver::memory() const
{
  constexpr Real megabyte = 1e6;
  return megabyte * mumps_->call.infog[15];
}

bool DirectSolver::factorize(std::span<const Real> entries)
{
  const Timer timer("factorize matrix");
  Mumps& m = *mumps_;
  std::copy(entries.begin(), entries.end(), m.entries.begin());
  const MUMPS_INT error = m.run(2);
  if (error == -10) return false;
  if (error == -9) {  // the estimate was too low
    m.control(14) *= 2;
    if (m.control(14) < 2000) return factorize(entries);
  }
  if (error < 0) throw RunError(fmt::format("MUMPS cannot factorize the matrix (error {}, {})", error, m.call.infog[1]));
  return true;
}

void DirectSolver::solve(std::span<Real> b, int part)
{
  const Timer timer("solve equations");
  Mumps& m = *mumps_;
  m.control(26) = part;
  m.call.rhs = b.data();
  if (const MUMPS_INT error = m.run(3); error < 0) throw RunError(fmt::format("MUMPS cannot solve (error {})", error));
}

void DirectSolver::solve(std::span<Real> b)
{
  solve(b, 0);
}

std::span<const Real> DirectSolver::kept_matrix() const
{
  return mumps_->kept_matrix;
}

std::span<Real> DirectSolver::condense(std::span<Real> b)
{
  solve(b, 1);
  return mumps_->kept_part;
}

void DirectSolver::expand(std::span<Real> b)
{
  solve(b, 2);
}

}  // namespace berm::fem
