// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "user_law/loaded_law.hpp"

namespace berm::user_law {

/// Where a trial begins: isotropic pressure, Pa, and state variables.
struct TrialStart {
  int dimension = 2;
  Real pressure = 0;
  std::vector<Real> state;
};

/// One increment without strain. Throws InputError where the law fails in it.
void refuse_failing(const LoadedLaw& law, const TrialStart& start);

/// Throws InputError where the law gives other results when calls for two points alternate than when one point comes after the other: then it keeps
/// variables from one call to the next, which all points would share.
void refuse_memory(const LoadedLaw& law, const TrialStart& start);

/// Throws InputError where a UMAT gives another result once an argument that berm does not know (Unknown) is another number; names it.
void refuse_unknown_arguments(const LoadedLaw& law, const TrialStart& start);

/// Whether two threads that call the law for different points at a time, some ten thousand times each, get what one thread gets, bit for bit. It can miss a
/// law that is unsafe seldom; it finds none unsafe that is not.
bool safe_in_threads(const LoadedLaw& law, const TrialStart& start);

}  // namespace berm::user_law
