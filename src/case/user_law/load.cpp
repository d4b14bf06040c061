// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/load.hpp"

#include "io/log.hpp"
#include "material/user_law.hpp"
#include "os/error.hpp"
#include "user_law/library.hpp"
#include "user_law/trial.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::user_law {
namespace {

using material::Interface;
using material::UserLaw;

using Materials = std::vector<std::pair<std::string, material::Material>>;

/// Calls act(name, law) for the user's own laws among materials.
template <class List, class Act>
void for_each_law(List& materials, const Act& act)
{
  for (auto& [name, material] : materials) {
    if (auto* law = material.template get_if<UserLaw<Interface::own>>()) act(name, *law);
    if (auto* law = material.template get_if<UserLaw<Interface::umat>>()) act(name, *law);
  }
}

/// Pressure of the trials over Young's modulus.
constexpr Real trial_pressure = 1e-3;

/// Calls act; an InputError becomes one of this key of a material.
template <class Act>
auto with_key(const std::string& material, const char* last, const Act& act)
{
  try {
    return act();
  } catch (const InputError& error) {
    throw KeyError(fmt::format("material.{}.{}: {}", material, last, error.what()));
  }
}

/// A function, and what messages call it.
struct Found {
  LoadedLaw::Function function;
  std::string words;
};

/// The function of the library that the law names, whose SHA-256 it gets.
template <Interface interface>
Found find_in_library(const std::string& name, UserLaw<interface>& law)
{
  const Library library = with_key(name, "library", [&] { return open_library(law.library, law.library_sha256); });
  law.library_sha256 = library.sha256;
  std::vector<std::string> names = {law.symbol};
  if (law.symbol.empty())
    names = interface == Interface::umat ? std::vector<std::string>{"umat_", "umat"} : std::vector<std::string>{"berm_law"};
  const Symbol symbol = with_key(name, "symbol", [&] { return find_function(library.handle, law.library, names); });
  const std::string words = fmt::format("the law \"{}\" of [material.{}], {} of {},", law.word, name, symbol.name, law.library);
  if constexpr (interface == Interface::umat)
    return {Umat{reinterpret_cast<UmatFunction>(symbol.address)}, words};
  else
    return {reinterpret_cast<int (*)(berm_law_increment*)>(symbol.address), words};
}

template <Interface interface>
void load_law(const std::string& name, int dimension, const OwnFunction* given, UserLaw<interface>& law)
{
  const auto [function, words] =
      given == nullptr ? find_in_library(name, law) : Found{*given, fmt::format("the law of [material.{}] that the program gives", name)};
  if (given != nullptr) law.library_sha256.clear();
  const Constants constants{name, law.properties, law.state_variables};
  const LoadedLaw alone(function, constants, words, true);
  TrialStart start{dimension, trial_pressure * law.young_modulus, law.initial_state};
  start.state.resize(static_cast<std::size_t>(law.state_variables), 0);
  with_key(name, "library", [&] {
    refuse_failing(alone, start);
    refuse_memory(alone, start);
    refuse_unknown_arguments(alone, start);
  });
  using ThreadSafe = typename UserLaw<interface>::ThreadSafe;
  bool one_at_a_time = law.thread_safe == ThreadSafe::no || given != nullptr;
  if (!one_at_a_time && law.thread_safe == ThreadSafe::probed && !safe_in_threads(LoadedLaw(function, constants, words, false), start)) {
    one_at_a_time = true;
    io::warn("{} gives other results when two threads call it at once (SAVE, COMMON, static variables or unit numbers): calls are "
             "serialised, which is slower; thread_safe = \"no\" says the same without a trial",
             words);
  }
  law.loaded = std::make_shared<LoadedLaw>(function, constants, words, one_at_a_time);
}

/// A law of the caller's own stands for the library of a material with law = "user".
void refuse_unused(const GivenLaws& given, const Materials& materials)
{
  for (const auto& [wanted, function] : given) {
    const bool used = std::any_of(materials.begin(), materials.end(), [&](const auto& material) {
      return material.first == wanted && material.second.template get_if<UserLaw<Interface::own>>() != nullptr;
    });
    if (!used) throw KeyError(fmt::format("material.{}: the program gives a law for it, but there is none of law = \"user\"", wanted));
  }
}

}  // namespace

bool names_library(const Materials& materials)
{
  bool found = false;
  for_each_law(materials, [&](const std::string&, const auto&) { found = true; });
  return found;
}

void load(Materials& materials, int dimension, const GivenLaws& given)
{
  refuse_unused(given, materials);
  for_each_law(materials, [&](const std::string& name, auto& law) {
    const auto own = given.find(name);
    load_law(name, dimension, own == given.end() ? nullptr : &own->second, law);
  });
}

void load(settings::Case& c, const GivenLaws& given)
{
  load(c.material, c.dimension(), given);
}

std::vector<std::pair<std::string, std::string>> library_hashes(const settings::Case& c)
{
  std::map<std::string, std::string> hashes;
  for_each_law(c.material, [&](const std::string&, const auto& law) {
    if (!law.library_sha256.empty()) hashes[law.library] = law.library_sha256;
  });
  return {hashes.begin(), hashes.end()};
}

void throw_failures(const settings::Case& c)
{
  throw_failures(c.material);
}

void throw_failures(const Materials& materials)
{
  for_each_law(materials, [](const std::string&, const auto& law) {
    if (const std::string failure = law.loaded ? law.loaded->failure() : ""; !failure.empty()) throw RunError(failure);
  });
}

void forget_failures(const settings::Case& c)
{
  for_each_law(c.material, [](const std::string&, const auto& law) {
    if (law.loaded) law.loaded->forget_failure();
  });
}

}  // namespace berm::user_law
