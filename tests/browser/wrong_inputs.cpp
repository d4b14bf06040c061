// SPDX-License-Identifier: BSD-3-Clause
// Prints the wrong inputs that lie in a file as a JSON list of texts by their names, for web/tests/schema.test.ts.
#include "samples/wrong_inputs.hpp"

#include <iostream>
#include <nlohmann/json.hpp>

int main()
{
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const berm::test::WrongInput& wrong : berm::test::wrong_inputs())
    if (wrong.overrides.empty()) all[wrong.name] = berm::test::text_of(wrong);
  std::cout << all.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}
