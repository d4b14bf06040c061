// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/mpm/divide_test.cpp, tests/ranks/run
#include "mpm/divide.hpp"

#include "core/ranks.hpp"

#include <numeric>

namespace berm::mpm {

std::vector<Index> equal_shares(const std::vector<Real>& costs, int ranks)
{
  const auto chunks = static_cast<Index>(costs.size());
  const Real all = std::accumulate(costs.begin(), costs.end(), Real(0));
  std::vector<Index> first = {0};
  Real before = 0;
  Index chunk = 0;
  for (int r = 1; r < ranks; ++r) {
    // The border that comes nearest to r parts of `ranks`, with a chunk at least on both sides.
    const Index last = std::min(chunks, std::max(first.back() + 1, chunks - (ranks - r)));
    while (chunk < last && (chunk <= first.back() || before + 0.5 * costs[chunk] < all * r / ranks)) before += costs[chunk++];
    first.push_back(chunk);
  }
  first.push_back(chunks);
  return first;
}

namespace {

/// Of each chunk, by what is in it on this rank.
template <int dim>
std::vector<Real> costs_of(const problem::Model<dim>& model, const problem::State<dim>& state)
{
  constexpr Real of_cell = 3;  // what a cell with particles costs, in particles
  std::vector<Real> costs(model.mesh.cell_chunks.size() - 1, 0);
  for (const bodies::Particles<dim>& particles : state.particles)
    for (Index k = 0; k < particles.active_chunks().count(); ++k)
      for (Index c = particles.active_chunks().begin[k]; c < particles.active_chunks().begin[k + 1]; ++c)
        costs[particles.active_chunks().number[k]] += particles.count_in(particles.active()[c]) + of_cell;
  return costs;
}

/// The largest sum of the costs of a rank.
Real longest(const std::vector<Real>& costs, const std::vector<Index>& first)
{
  Real most = 0;
  for (std::size_t r = 0; r + 1 < first.size(); ++r)
    most = std::max(most, std::accumulate(costs.begin() + first[r], costs.begin() + first[r + 1], Real(0)));
  return most;
}

}  // namespace

template <int dim>
void divide(const problem::Model<dim>& model, problem::State<dim>& state)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return;
  const std::vector<Real> costs = costs_of(model, state);
  ranks.divide(equal_shares(costs, ranks.count()), model.mesh.cell_chunks, model.mesh.node_chunks);
  for (bodies::Particles<dim>& particles : state.particles) {
    std::vector<std::byte> bytes;
    particles.pack(ranks.first_cell()[ranks.rank()], ranks.first_cell()[ranks.rank() + 1], bytes);
    particles.unpack(bytes);
  }
}

namespace {

/// Gives all ranks what the state has at all nodes and in all cells.
template <int dim>
void share_fields(problem::State<dim>& state)
{
  Ranks& ranks = Ranks::of_run();
  for (std::vector<NodeField<Vec<dim>>>* fields : {&state.flux, &state.held_forces})
    for (NodeField<Vec<dim>>& field : *fields)
      if (!field.empty())
        ranks.share<Vec<dim>>(
            field.size(), [&](Index node) { return ranks.owner_of_node(node); }, [&](Index node, Vec<dim>& v) { v = field[node]; },
            [&](Index node, const Vec<dim>& v) { field[node] = v; });
  for (CellField<Real>& sums : state.pressure_sums)
    if (!sums.empty())
      ranks.share<Real>(
          sums.size(), [&](Index cell) { return ranks.owner_of_cell(cell); }, [&](Index cell, Real& sum) { sum = sums[cell]; },
          [&](Index cell, const Real& sum) { sums[cell] = sum; });
}

}  // namespace

template <int dim>
bool divide_anew(const problem::Model<dim>& model, problem::State<dim>& state, Real busy)
{
  constexpr Real little = 0.05;
  Ranks& ranks = Ranks::of_run();
  if (!ranks.divided()) return false;
  std::vector<Real> costs = costs_of(model, state);
  const Real whole = std::accumulate(costs.begin(), costs.end(), Real(0));
  for (Real& cost : costs) cost *= whole > 0 ? busy / whole : 0;
  ranks.share_chunks(costs.data(), sizeof(Real));
  const std::vector<Index> before = ranks.first_chunk(), after = equal_shares(costs, ranks.count());
  if (!(longest(costs, after) < (1 - little) * longest(costs, before))) return false;
  share_fields(state);
  std::vector<Messenger::Letter> letters;
  for (int r = 0; r < ranks.count(); ++r)
    if (r != ranks.rank()) letters.push_back({r, {}, {}});
  const auto first_cell = [&](int r) { return model.mesh.cell_chunks[after[r]]; };
  for (bodies::Particles<dim>& particles : state.particles) {
    for (Messenger::Letter& letter : letters) {
      letter.out.clear();
      particles.pack(first_cell(letter.rank), first_cell(letter.rank + 1), letter.out);
    }
    ranks.messenger()->exchange(letters);
    std::vector<std::byte> own, all;
    particles.pack(first_cell(ranks.rank()), first_cell(ranks.rank() + 1), own);
    const auto add = [&](const std::vector<std::byte>& bytes) { all.insert(all.end(), bytes.begin(), bytes.end()); };
    for (const Messenger::Letter& letter : letters)
      if (letter.rank < ranks.rank()) add(letter.in);
    add(own);
    for (const Messenger::Letter& letter : letters)
      if (letter.rank > ranks.rank()) add(letter.in);
    particles.unpack(all);
  }
  ranks.divide(after, model.mesh.cell_chunks, model.mesh.node_chunks);
  return true;
}

namespace {

/// The packed particles of all ranks on the first, in the order of their cells; nothing on the others. Each message has those of some thousand cells.
template <int dim>
std::vector<std::byte> packed_of_all(const bodies::Particles<dim>& particles)
{
  constexpr Index cells_of_message = 1 << 16;
  Ranks& ranks = Ranks::of_run();
  const std::vector<Index>& first = ranks.first_cell();
  Index rounds = 0;
  for (int r = 0; r < ranks.count(); ++r) rounds = std::max(rounds, (first[r + 1] - first[r] + cells_of_message - 1) / cells_of_message);
  std::vector<Messenger::Letter> letters;
  if (!ranks.is_first()) letters.push_back({0, {}, {}});
  for (int r = 1; r < ranks.count() && ranks.is_first(); ++r) letters.push_back({r, {}, {}});
  std::vector<std::vector<std::byte>> parts(letters.size());
  for (Index round = 0; round < rounds; ++round) {
    const Index begin = std::min(first[ranks.rank()] + round * cells_of_message, first[ranks.rank() + 1]);
    if (!ranks.is_first()) {
      letters[0].out.clear();
      particles.pack(begin, std::min(begin + cells_of_message, first[ranks.rank() + 1]), letters[0].out);
    }
    ranks.messenger()->exchange(letters);
    if (ranks.is_first())
      for (std::size_t k = 0; k < letters.size(); ++k) parts[k].insert(parts[k].end(), letters[k].in.begin(), letters[k].in.end());
  }
  std::vector<std::byte> all;
  if (!ranks.is_first()) return all;
  particles.pack(first[0], first[1], all);
  std::size_t bytes = all.size();
  for (const std::vector<std::byte>& part : parts) bytes += part.size();
  all.reserve(bytes);
  for (std::vector<std::byte>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    std::vector<std::byte>().swap(part);
  }
  return all;
}

}  // namespace

template <int dim>
WholeState<dim>::WholeState(problem::State<dim>& state) : state_(state)
{
  const Ranks& ranks = Ranks::of_run();
  if (!ranks.divided()) return;
  share_fields(state);
  std::vector<std::vector<std::byte>> packed;
  for (const bodies::Particles<dim>& particles : state.particles) packed.push_back(packed_of_all(particles));
  if (!ranks.is_first()) return;
  of_rank_ = state.particles;
  of_rank_.swap(state.particles);
  for (std::size_t b = 0; b < packed.size(); ++b) {
    state.particles[b].unpack(packed[b]);
    std::vector<std::byte>().swap(packed[b]);
  }
}

template <int dim>
WholeState<dim>::~WholeState()
{
  if (!of_rank_.empty()) of_rank_.swap(state_.particles);
}

template void divide(const problem::Model<2>&, problem::State<2>&);
template void divide(const problem::Model<3>&, problem::State<3>&);
template bool divide_anew(const problem::Model<2>&, problem::State<2>&, Real);
template bool divide_anew(const problem::Model<3>&, problem::State<3>&, Real);
template class WholeState<2>;
template class WholeState<3>;

}  // namespace berm::mpm
