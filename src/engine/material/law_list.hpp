// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/material.hpp"
#include "material/undrained.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace berm::material {

/// A law with precomputed constants.
template <Law L>
using PreparedLaw = decltype(prepare(std::declval<const L&>()));

/// The same with water in its pores; of a law of total stress the law itself.
template <Law L>
using PreparedWithWater = std::conditional_t<total_stress_alone<L>, PreparedLaw<L>, Undrained<PreparedLaw<L>>>;

/// A variant of these types, each of them once.
template <class Variant, class... Ts>
struct VariantOf {
  using Type = Variant;
};
template <class... Done, class T, class... Ts>
struct VariantOf<std::variant<Done...>, T, Ts...>
    : std::conditional_t<(std::is_same_v<Done, T> || ...), VariantOf<std::variant<Done...>, Ts...>,
                         VariantOf<std::variant<Done..., T>, Ts...>> {
};

/// A closed list of laws, and the types that follow from it.
template <Law... Ls>
struct LawList {
  static_assert(((Ls::state_size == PreparedLaw<Ls>::state_size) && ...),
                "a law and its prepared form must have the same number of state variables");

  using Any = std::variant<Ls...>;  ///< one of them, with its parameters
  /// One of them, with precomputed constants, drained or undrained; laws may share a prepared form.
  using Prepared = typename VariantOf<std::variant<>, PreparedLaw<Ls>..., PreparedWithWater<Ls>...>::Type;
  static constexpr int max_state = std::max({PreparedWithWater<Ls>::state_size...});

  /// Words of the input, in the order of the list.
  static std::vector<const char*> words() { return {Ls::word...}; }

  /// act(law) with the law of a material.
  template <class Act, class M>
  static decltype(auto) visit(const Act& act, M& material)
  {
    return visit_among<Ls...>(act, material);
  }

private:
  template <class L, class... Rest, class Act, class M>
  static decltype(auto) visit_among(const Act& act, M& material)
  {
    if constexpr (sizeof...(Rest) == 0) {
      return act(material.template get<L>());
    } else {
      if (auto* law = material.template get_if<L>()) return act(*law);
      return visit_among<Rest...>(act, material);
    }
  }
};

}  // namespace berm::material
