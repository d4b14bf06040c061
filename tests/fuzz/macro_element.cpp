// SPDX-License-Identifier: BSD-3-Clause
// A macro_element.json, and beside its parameters a list "steps" of [x, u, w]: a refusal, an error, with which nothing is written, or numbers, and the same when asked again.
#include "target.hpp"

#include "macro_element/parameters.hpp"
#include "os/error.hpp"

#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

using namespace berm;

namespace {

using Json = nlohmann::json;

void promise_numbers(const berm_macro_element_state& s)
{
  for (const double number : {s.x, s.u, s.w, s.u_p, s.w_p, s.disturbed, s.mobilised, s.T, s.H, s.V})
    promise(std::isfinite(number), "a state is of numbers", fmt::format("{}", number));
}

/// Where a step goes; zeros for what is no list of numbers.
std::array<double, 3> displacement_of(const Json& step)
{
  std::array<double, 3> to{};
  for (std::size_t k = 0; k < 3 && step.is_array() && k < step.size(); ++k) to[k] = step[k].is_number() ? step[k].get<double>() : 0;
  return to;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text = text_of(data, size);
  berm_macro_element_parameters p;
  try {
    p = macro_element::parameters_in(text, "input");
  } catch (const InputError& error) {
    promise_one_line(error.what());
    return 0;
  }
  berm_macro_element_state state{};
  const double seabed[3] = {0, 0, 0};
  promise(berm_macro_element_start(&p, seabed, 0, &state) == 0, "with sound parameters it starts at the seabed", text);
  promise_numbers(state);
  constexpr int most_steps = 20;
  int steps = 0;
  for (const Json& step : Json::parse(text).value("steps", Json::array())) {
    if (++steps > most_steps) break;
    const std::array<double, 3> to = displacement_of(step);
    struct Answer {
      double F[3], K[3][3];
    } first{}, second{};
    const berm_macro_element_state before = state;
    berm_macro_element_state again = before;
    const int error = berm_macro_element_step(&p, &state, to.data(), &state, first.F, first.K);
    promise(berm_macro_element_step(&p, &before, to.data(), &again, second.F, second.K) == error &&
                std::memcmp(&first, &second, sizeof first) == 0 && std::memcmp(&state, &again, sizeof state) == 0,
            "asked again it says the same", fmt::format("step {}", steps));
    if (error != 0) {
      promise(std::memcmp(&before, &state, sizeof state) == 0 && first.F[0] == 0, "with an error nothing is written",
              berm_macro_element_error(error));
      break;
    }
    promise_numbers(state);
    for (int i = 0; i < 3; ++i)
      for (const double number : {first.F[i], first.K[i][0], first.K[i][1], first.K[i][2]})
        promise(std::isfinite(number), "forces and stiffness are numbers", fmt::format("{}", number));
  }
  return 0;
}
