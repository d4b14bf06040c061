// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample.hpp"

#include "input/units.hpp"
#include "run_folder/csv_line.hpp"
#include "study/latin_hypercube.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::study {
namespace {

bool is_bare(const std::string& unit)
{
  return unit.empty() || unit == "1";
}

/// KEY=NUMBER or KEY=NUMBER UNIT.
std::string setting(const std::string& key, Real value, const std::string& unit)
{
  return fmt::format("{}={:.6g}{}{}", key, value, is_bare(unit) ? "" : " ", is_bare(unit) ? "" : unit);
}

/// All parameters at these numbers.
StudyValue value_at(const StudySample& sample, const std::string& name, const std::vector<Real>& numbers)
{
  StudyValue value{name, {}, {}, numbers};
  for (std::size_t j = 0; j < sample.parameter.size(); ++j) {
    const SampleParameter& parameter = sample.parameter[j];
    for (const std::string& key : parameter.keys) value.set.push_back(setting(key, numbers[j], parameter.distribution.unit));
    for (const auto& [key, text] : parameter.times) {
      const input::SiQuantity quantity = input::to_si(text);
      value.set.push_back(setting(key, numbers[j] * quantity.value, quantity.unit));
    }
  }
  return value;
}

/// KEY, NUMBER and UNIT of a setting.
struct TakenApart {
  std::string key, number, unit;
};

TakenApart taken_apart(const std::string& setting)
{
  const std::size_t equals = setting.find('='), space = setting.find(' ', equals);
  return {setting.substr(0, equals), setting.substr(equals + 1, space == std::string::npos ? space : space - equals - 1),
          space == std::string::npos ? "" : setting.substr(space + 1)};
}

/// Why a text is no quantity; "" where it is one.
std::string fault_of(const std::string& quantity)
{
  try {
    input::to_si(quantity);
    return "";
  } catch (const input::UnitError& error) {
    return error.what();
  }
}

}  // namespace

void describe(Describe& d, SampleParameter& parameter)
{
  d.value("name", parameter.name, {.meaning = "name of the parameter in tables and pictures", .required = true});
  d.value("keys", parameter.keys, {.meaning = "keys that get the number, as for --set; * stands for every name"});
  d.value("times", parameter.times, {.meaning = "keys that get a quantity times the number, which is bare"});
  describe(d, parameter.distribution);
}

void describe(Describe& d, StudySample& sample)
{
  constexpr int most = 100'000;
  d.value("size", sample.size, {.meaning = "number of rows", .range = {1, most}, .required = true});
  d.value("seed", sample.seed, {.meaning = "another one makes another sample", .range = not_negative});
  d.array("parameter", sample.parameter, {.meaning = "what is not known well", .required = true});
}

void check(Describe& d, const StudySample& sample)
{
  for (std::size_t j = 0; j < sample.parameter.size(); ++j) {
    const SampleParameter& parameter = sample.parameter[j];
    const std::string path = fmt::format("sample.parameter[{}]", j);
    check(d, path, parameter.distribution);
    d.check(!parameter.keys.empty() || !parameter.times.empty(), path, "sets nothing; give it keys, or times");
    for (const std::string& key : parameter.keys) d.check(key.find('=') == std::string::npos, path + ".keys", "a key has no =");
    if (!parameter.times.empty())
      d.check(is_bare(parameter.distribution.unit), path + ".times", "multiplies by the number, which must then be bare");
    for (const auto& [key, quantity] : parameter.times) {
      d.check(key.find('=') == std::string::npos, path + ".times", "a key has no =");
      const std::string fault = fault_of(quantity);
      d.check(fault.empty(), path + ".times." + key, fault);
    }
  }
}

StudyAxis sample_axis(const StudySample& sample)
{
  StudyAxis axis{"sample", {}, {}, {}};
  std::vector<Real> medians;
  for (const SampleParameter& parameter : sample.parameter) {
    axis.parameter.push_back({parameter.name, is_bare(parameter.distribution.unit) ? "" : parameter.distribution.unit});
    medians.push_back(quantile(parameter.distribution, 0.5));
  }
  axis.value.push_back(value_at(sample, "best", medians));
  for (std::size_t j = 0; j < sample.parameter.size(); ++j)
    for (const auto& [word, share] : {std::pair(" low", low_share), std::pair(" high", high_share)}) {
      std::vector<Real> numbers = medians;
      numbers[j] = quantile(sample.parameter[j].distribution, share);
      axis.value.push_back(value_at(sample, sample.parameter[j].name + word, numbers));
    }
  axis.sample_from = axis.value.size();
  const auto rows = static_cast<std::size_t>(sample.size);
  const std::vector<std::vector<Real>> shares = latin_hypercube(sample.parameter.size(), rows, static_cast<std::uint64_t>(sample.seed));
  for (std::size_t k = 0; k < rows; ++k) {
    std::vector<Real> numbers;
    for (std::size_t j = 0; j < sample.parameter.size(); ++j) numbers.push_back(quantile(sample.parameter[j].distribution, shares[j][k]));
    axis.value.push_back(value_at(sample, fmt::format("{}", k + 1), numbers));
  }
  return axis;
}

std::string samples_csv(const StudyAxis& axis)
{
  std::string text;
  const auto add_line = [&](const StudyValue& value, const auto& field_of) {
    for (const std::string& set : value.set) text += run_folder::csv_field(field_of(taken_apart(set))) + ',';
    text.back() = '\n';
  };
  add_line(axis.value[*axis.sample_from],
           [](const TakenApart& set) { return set.unit.empty() ? set.key : fmt::format("{} ({})", set.key, set.unit); });
  for (std::size_t k = *axis.sample_from; k < axis.value.size(); ++k)
    add_line(axis.value[k], [](const TakenApart& set) { return set.number; });
  return text;
}

}  // namespace berm::study
