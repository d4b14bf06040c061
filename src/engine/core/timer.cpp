// SPDX-License-Identifier: BSD-3-Clause
#include "core/timer.hpp"

#include <cstring>
#include <utility>

namespace berm {
namespace {

thread_local Timings* current = nullptr;

}  // namespace

std::vector<Timing> Timings::table() const
{
  std::vector<Timing> table;
  for (const Slot& slot : slots_)
    if (slot.calls > 0) table.push_back({slot.label, std::chrono::duration<Real>(slot.total).count(), slot.calls});
  return table;
}

std::size_t Timings::slot_of(const char* label)
{
  for (std::size_t k = 0; k < slots_.size(); ++k)
    if (slots_[k].label == label || std::strcmp(slots_[k].label, label) == 0) return k;
  slots_.push_back({label});
  return slots_.size() - 1;
}

Timings::Use::Use(Timings& timings) : before_(current)
{
  current = &timings;
}

Timings::Use::~Use()
{
  current = before_;
}

Timer::Timer(const char* label) : timings_(current)
{
  if (timings_ == nullptr) return;
  slot_ = timings_->slot_of(label);
  inner_before_ = std::exchange(timings_->inner_, {});
  start_ = std::chrono::steady_clock::now();
}

Timer::~Timer()
{
  if (timings_ == nullptr) return;
  const auto life = std::chrono::steady_clock::now() - start_;
  Timings::Slot& slot = timings_->slots_[slot_];
  slot.total += life - timings_->inner_;
  timings_->inner_ = inner_before_ + life;
  ++slot.calls;
}

}  // namespace berm
