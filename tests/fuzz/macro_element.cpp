// SPDX-License-Identifier: BSD-3-Clause
// A macro_element.json, as the Python package takes its parameters, and beside "parameters" a list "steps" of [du, dw]: an error, with which the state stays as
// it was, or numbers.
#include "target.hpp"

#include "core/types.hpp"
#include "macro_element/members.hpp"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

using namespace berm;

namespace {

using Json = nlohmann::json;
using Parameters = berm_macro_element_parameters;

Real number_of(const Json& json)
{
  return json.is_number() ? json.get<Real>() : 0;
}

std::vector<Real> numbers_of(const Json& json)
{
  std::vector<Real> numbers;
  if (json.is_array())
    for (const Json& number : json) numbers.push_back(number_of(number));
  return numbers;
}

Json member(const Json& json, const char* name)
{
  return json.is_object() && json.contains(name) ? json.at(name) : Json();
}

Parameters parameters_of(const Json& json)
{
  Parameters p{};
  p.version = BERM_MACRO_ELEMENT_VERSION;
  const auto value = [&](const char* name) { return member(member(json, name), "value"); };
  for (const auto& [name, place, unit] : macro_element::members) p.*place = number_of(value(name));
  std::vector<Real> w = numbers_of(value("backbone_w")), V = numbers_of(value("backbone_V"));
  const std::size_t points = std::min({w.size(), V.size(), std::size_t(BERM_MACRO_ELEMENT_MAX_POINTS)});
  std::copy_n(w.begin(), points, p.backbone_w);
  std::copy_n(V.begin(), points, p.backbone_V);
  p.backbone_points = static_cast<int>(points);
  return p;
}

void promise_numbers(const berm_macro_element_state& s)
{
  for (const Real number : {s.u, s.w, s.u_p, s.w_p, s.disturbed, s.mobilised, s.H, s.V})
    promise(std::isfinite(number), "a state is of numbers", fmt::format("{}", number));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Json json = Json::parse(text_of(data, size), nullptr, false);
  if (json.is_discarded()) return 0;
  const Parameters p = parameters_of(member(json, "parameters"));
  berm_macro_element_state state{};
  const int checked = berm_macro_element_check(&p), started = berm_macro_element_start(&p, 0, 0, 0, &state);
  promise(checked != 0 ? started != 0 : started == 0, "with sound parameters it starts at the seabed", berm_macro_element_error(started));
  if (started != 0) return 0;
  promise_numbers(state);
  constexpr int most_steps = 20;
  int steps = 0;
  for (const Json& step : member(json, "steps")) {
    const std::vector<Real> by = numbers_of(step);
    if (by.size() < 2 || ++steps > most_steps) break;
    const double du[2] = {by[0], by[1]};
    double F[2] = {0, 0}, K[2][2] = {{0, 0}, {0, 0}};
    const berm_macro_element_state before = state;
    if (const int error = berm_macro_element_step(&p, &state, du, F, K); error != 0) {
      promise(std::memcmp(&before, &state, sizeof state) == 0, "with an error the state stays as it was", berm_macro_element_error(error));
      break;
    }
    promise_numbers(state);
    for (const Real number : {F[0], F[1], K[0][0], K[0][1], K[1][0], K[1][1]})
      promise(std::isfinite(number), "forces and stiffness are numbers", fmt::format("{}", number));
  }
  return 0;
}
