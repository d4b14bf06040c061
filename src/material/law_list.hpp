// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/law_answers.hpp"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

namespace berm::material {

/// A law with its constants worked out.
template <Law L>
using PreparedLaw = decltype(prepare(std::declval<const L&>()));

/// A closed list of laws, and what follows from it.
template <Law... Ls>
struct LawList {
  static_assert(((Ls::state_size == PreparedLaw<Ls>::state_size) && ...), "a law and its prepared form keep the same numbers");

  using Material = std::variant<Ls...>;               ///< one of them, as the user gives it
  using Prepared = std::variant<PreparedLaw<Ls>...>;  ///< one of them, for the inner loop
  static constexpr int max_state = std::max({Ls::state_size...});

  /// Of the input, in the order of the list.
  static std::vector<const char*> words() { return {Ls::word...}; }
};

}  // namespace berm::material
