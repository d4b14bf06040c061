// SPDX-License-Identifier: BSD-3-Clause
// What users write beside cases. The first byte of an input says what the rest is: t the table of an axis of a study (CSV), e an expected.toml, q a quantity with or without a unit.
#include "target.hpp"

#include "expectations/expectation.hpp"
#include "input/units.hpp"
#include "os/control_characters.hpp"
#include "study/table_axis.hpp"

using namespace berm;

namespace {

void read_table_of_study(const std::string& text)
{
  static const MemoryFile file;
  const study::StudyAxis axis = study::read_table(file.hold(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), "axis");
  promise(!axis.value.empty(), "a table has rows", "");
  for (const study::StudyValue& value : axis.value) {
    promise(study::fault_of_name(value.name).empty(), "names of rows are sound", value.name);
    promise(value.number.size() == axis.parameter.size() && value.set.size() == axis.parameter.size(),
            "a row has a value for each parameter", value.name);
    for (const std::string& set : value.set)
      promise(!has_control_character(set) && set.find('=') != std::string::npos, "values are KEY=VALUE", set);
  }
}

void read_quantity(const std::string& text)
{
  for (const char* unit : {"m", "Pa", "rad", "s", ""}) try {
      const Real value = input::to_si(text, unit);
      promise(std::isfinite(value), "a quantity is a number", text);
    } catch (const input::UnitError& error) {
      promise_one_line(error.what());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const auto [kind, text] = kind_and_text(data, size, 't');
  may_be_refused([&, &kind = kind, &text = text] {
    if (kind == 'q')
      read_quantity(text);
    else if (kind == 'e')
      expectations::read_expectations_text("expected.toml", text);
    else
      read_table_of_study(text);
  });
  return 0;
}
