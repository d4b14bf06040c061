// SPDX-License-Identifier: BSD-3-Clause
#include "jobs/thread_shares.hpp"

#include "bodies/fill.hpp"

#include <algorithm>
#include <cmath>

namespace berm::jobs {
namespace {

/// Of the soil, before there is a mesh: half of the cells of a bed hold some, at least; 0 where it is not known.
template <int dim>
Real expected_particles(const settings::Case& c)
{
  Real cells = 0;
  if (const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh)) {
    cells = dim == 2 ? 2 : 6;  // of a square or a cube, at least
    for (const Real along : box->cells) cells *= along;
  } else if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    cells = expected_cells(*bed) / 2;
  }
  Real particles = 0;
  for (const auto& [name, body] : c.body) {
    if (body.block) particles += bodies::particles_in<dim>(*body.block);
    if (body.disk) particles += bodies::particles_in(*body.disk);
    if (!body.regions.empty()) particles += cells * bodies::particles_per_cell<dim>(body, body.regions.front());
  }
  return particles;
}

}  // namespace

int threads_worth(const settings::Case& settings)
{
  constexpr Real particles_a_thread = 10'000, most = 1024;
  if (settings.method != settings::Method::mpm) return 1;
  const Real particles = settings.dimension() == 2 ? expected_particles<2>(settings) : expected_particles<3>(settings);
  return static_cast<int>(std::clamp(std::floor(particles / particles_a_thread), Real(1), most));
}

ThreadShares::ThreadShares(int at_once, std::vector<int> processors)
    : at_once_(at_once),
      most_(std::max(1, std::min(at_once, static_cast<int>(processors.size())))),
      free_(std::move(processors))
{
}

int ThreadShares::for_next(std::size_t left) const
{
  const int jobs = static_cast<int>(std::max<std::size_t>(left, 1)), free = at_once_ - taken_;
  return std::clamp((free + jobs - 1) / jobs, 1, most_);
}

std::vector<int> ThreadShares::begin(std::size_t job, int threads)
{
  Share share{threads, {}};
  if (threads > 1 && threads <= static_cast<int>(free_.size())) {
    share.processors.assign(free_.end() - threads, free_.end());
    free_.resize(free_.size() - static_cast<std::size_t>(threads));
  }
  taken_ += threads;
  return shares_.emplace(job, std::move(share)).first->second.processors;
}

void ThreadShares::end(std::size_t job)
{
  const auto found = shares_.find(job);
  taken_ -= found->second.threads;
  free_.insert(free_.end(), found->second.processors.begin(), found->second.processors.end());
  shares_.erase(found);
}

}  // namespace berm::jobs
