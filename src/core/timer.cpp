// SPDX-License-Identifier: BSD-3-Clause
#include "core/timer.hpp"

#include <cstring>

namespace berm {
namespace {

struct Slot {
  const char* label;
  std::chrono::steady_clock::duration total{};
  BigIndex calls = 0;
};

std::vector<Slot>& slots()
{
  static std::vector<Slot> all;
  return all;
}

Index slot_of(const char* label)
{
  auto& all = slots();
  for (Index k = 0; k < static_cast<Index>(all.size()); ++k)
    if (all[k].label == label || std::strcmp(all[k].label, label) == 0) return k;
  all.push_back({label});
  return static_cast<Index>(all.size()) - 1;
}

}  // namespace

Timer::Timer(const char* label) : slot_(slot_of(label)), start_(std::chrono::steady_clock::now()) {}

Timer::~Timer()
{
  Slot& slot = slots()[slot_];
  slot.total += std::chrono::steady_clock::now() - start_;
  ++slot.calls;
}

std::vector<Timing> timings()
{
  std::vector<Timing> table;
  for (const Slot& slot : slots())
    if (slot.calls > 0) table.push_back({slot.label, std::chrono::duration<Real>(slot.total).count(), slot.calls});
  return table;
}

void reset_timings()
{
  for (Slot& slot : slots()) slot.total = {}, slot.calls = 0;
}

}  // namespace berm
