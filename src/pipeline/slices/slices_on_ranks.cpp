// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
#include "core/ranks.hpp"
#include "problem/archive_state.hpp"
#include "slices/coupled_line.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

namespace berm::slices {
namespace {

/// What the line, the rows and the stages need of a slice after a step.
struct RankMessage {
  Vec<2> displacement, velocity, reaction, impulse;
  bodies::RecentReaction<2> recent;
  Real contact_mass, failed;  ///< on its rank: 0 or 1
};
constexpr std::size_t numbers = sizeof(RankMessage) / sizeof(Real);

RankMessage told_by(const problem::State<2>& slice, Real contact_mass, bool failed)
{
  const bodies::RigidState<2>& pipe = slice.rigid_bodies[0];
  return {pipe.displacement,         pipe.velocity, pipe.reaction, slice.ledger.contact_sums[0].impulse, pipe.recent, contact_mass,
          failed ? Real(1) : Real(0)};
}

void hear(const RankMessage& told, problem::State<2>& slice, SliceForce& force)
{
  bodies::RigidState<2>& pipe = slice.rigid_bodies[0];
  pipe.displacement = told.displacement;
  pipe.velocity = told.velocity;
  pipe.reaction = told.reaction;
  pipe.recent = told.recent;
  slice.ledger.contact_sums[0].impulse = told.impulse;
  force = {told.reaction, told.contact_mass};
}

/// The words of the first rank that failed, on all of them.
[[noreturn]] void throw_first_of(const std::string& fault)
{
  std::vector<char> own(fault.begin(), fault.end()), all;
  if (!fault.empty()) own.push_back('\0');
  Ranks::of_run().gather_from_all(own, all);
  throw RunError(std::string(all.data()));
}

}  // namespace

int CoupledLine::rank_of(std::size_t k)
{
  return static_cast<int>(k % static_cast<std::size_t>(Ranks::of_run().count()));
}

bool CoupledLine::own(Index k) const
{
  return rank_of(static_cast<std::size_t>(k)) == Ranks::of_run().rank();
}

/// The smallest of all ranks is that of each slice that another rank steps.
void CoupledLine::share_time_steps(problem::State<2>& first, const std::string& fault)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return;
  constexpr Real failed = -1;
  Real smallest = fault.empty() ? infinity : failed;
  for (std::size_t k = 0; k < count(); ++k)
    if (fault.empty() && own(static_cast<Index>(k)) && (k == 0 || !is_spring(k)))
      smallest = std::min(smallest, (k == 0 ? first : *others_[k - 1]).stable_dt);
  smallest = -ranks.messenger()->largest(-smallest);
  if (smallest == failed) throw_first_of(fault);
  for (std::size_t k = 0; k < count(); ++k) {
    if (own(static_cast<Index>(k))) continue;
    problem::State<2>& slice = k == 0 ? first : *others_[k - 1];
    slice.stable_dt = smallest;
    slice.stable_dt_holds = true;
  }
}

/// One call for all slices.
void CoupledLine::share_slices(problem::State<2>& first, const std::string& fault)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return;
  const std::size_t many = static_cast<std::size_t>(ranks.count());
  told_.clear();
  for (std::size_t k = static_cast<std::size_t>(ranks.rank()); k < count(); k += many) {
    const RankMessage told = told_by(k == 0 ? first : *others_[k - 1], forces_[k].contact_mass, !fault.empty());
    const Real* values = reinterpret_cast<const Real*>(&told);
    told_.insert(told_.end(), values, values + numbers);
  }
  first_of_rank_.assign(many + 1, 0);
  for (std::size_t k = 0; k < count(); ++k) first_of_rank_[k % many + 1] += sizeof(RankMessage);
  for (std::size_t r = 0; r < many; ++r) first_of_rank_[r + 1] += first_of_rank_[r];
  told_by_all_.resize(count() * numbers);
  ranks.messenger()->gather(reinterpret_cast<const std::byte*>(told_.data()), reinterpret_cast<std::byte*>(told_by_all_.data()),
                            first_of_rank_);
  bool failed = false;
  for (std::size_t k = 0; k < count(); ++k) {
    RankMessage told;
    std::memcpy(static_cast<void*>(&told),
                reinterpret_cast<const std::byte*>(told_by_all_.data()) + first_of_rank_[k % many] + k / many * sizeof(RankMessage),
                sizeof(RankMessage));
    failed = failed || told.failed != 0;
    if (!own(static_cast<Index>(k)) && !is_spring(k)) hear(told, k == 0 ? first : *others_[k - 1], forces_[k]);
  }
  if (failed) throw_first_of(fault);
}

void CoupledLine::archive_of_rank(Archive& k, int rank)
{
  for (std::size_t s = 1; s < count(); ++s)
    if (rank_of(s) == rank) k.table(fmt::format("slice_{}", s), [&] { problem::archive(k, model_of(s), *others_[s - 1]); });
}

}  // namespace berm::slices
