// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/load.hpp"

#include "core/error.hpp"
#include "io/sha256.hpp"
#include "user_law/library.hpp"
#include "user_law/trial.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

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
    const auto act_on_name = [&act, &own_name = name](auto& law) {
      if constexpr (requires { law.library; }) act(own_name, law);
    };
    std::visit(act_on_name, material);
  }
}

/// Pressure of the trials over Young's modulus.
constexpr Real trial_pressure = 1e-3;

template <Interface interface>
void load_law(const std::string& name, int dimension, UserLaw<interface>& law)
{
  const std::string key = fmt::format("material.{}.", name);
  const auto with_key = [&](const char* last, const auto& act) {
    try {
      return act();
    } catch (const InputError& error) {
      throw KeyError(fmt::format("{}{}: {}", key, last, error.what()));
    }
  };
  void* const library = with_key("library", [&] { return open_library(law.library); });
  const std::string hash = io::sha256_of_file(law.library);
  if (!law.library_sha256.empty() && law.library_sha256 != hash)
    throw KeyError(fmt::format("{}library: {} is another file than the one with the SHA-256 {}: it is {}", key, law.library,
                               law.library_sha256, hash));
  law.library_sha256 = hash;

  std::vector<std::string> names = {law.symbol};
  if (law.symbol.empty())
    names = interface == Interface::umat ? std::vector<std::string>{"umat_", "umat"} : std::vector<std::string>{"berm_law"};
  const Symbol symbol = with_key("symbol", [&] { return find_function(library, law.library, names); });
  LoadedLaw::Function function;
  if constexpr (interface == Interface::umat)
    function = Umat{reinterpret_cast<UmatFunction>(symbol.address)};
  else
    function = reinterpret_cast<OwnFunction>(symbol.address);
  const Constants constants{name, law.properties, law.state_variables};
  const std::string words = fmt::format("the law \"{}\" of [material.{}], {} of {},", law.word, name, symbol.name, law.library);
  const LoadedLaw alone(function, constants, words, true);
  TrialStart start{dimension, trial_pressure * law.young_modulus, law.initial_state};
  start.state.resize(static_cast<std::size_t>(law.state_variables), 0);
  with_key("library", [&] {
    refuse_failing(alone, start);
    refuse_memory(alone, start);
    refuse_unknown_arguments(alone, start);
  });
  using ThreadSafe = typename UserLaw<interface>::ThreadSafe;
  bool one_at_a_time = law.thread_safe == ThreadSafe::no;
  if (law.thread_safe == ThreadSafe::probed && !safe_in_threads(LoadedLaw(function, constants, words, false), start)) {
    one_at_a_time = true;
    spdlog::warn(
        "{} gives other results when two threads call it at a time (SAVE, COMMON, static variables or unit numbers): they take turns, "
        "which is slower; thread_safe = \"no\" says the same without a trial",
        words);
  }
  law.loaded = std::make_shared<LoadedLaw>(function, constants, words, one_at_a_time);
}

}  // namespace

void load(Materials& materials, int dimension)
{
  for_each_law(materials, [&](const std::string& name, auto& law) { load_law(name, dimension, law); });
}

void load(problem::Case& c)
{
  load(c.material, c.dimension);
}

std::vector<std::pair<std::string, std::string>> library_hashes(const problem::Case& c)
{
  std::map<std::string, std::string> hashes;
  for_each_law(c.material, [&](const std::string&, const auto& law) { hashes[law.library] = law.library_sha256; });
  return {hashes.begin(), hashes.end()};
}

void throw_failures(const problem::Case& c)
{
  throw_failures(c.material);
}

void throw_failures(const Materials& materials)
{
  for_each_law(materials, [](const std::string&, const auto& law) {
    if (const std::string failure = law.loaded ? law.loaded->failure() : ""; !failure.empty()) throw RunError(failure);
  });
}

void forget_failures(const problem::Case& c)
{
  for_each_law(c.material, [](const std::string&, const auto& law) {
    if (law.loaded) law.loaded->forget_failure();
  });
}

}  // namespace berm::user_law
