// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample.hpp"

#include "input/units.hpp"
#include "run_folder/csv_line.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <random>
#include <utility>

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
  d.value("seed", sample.seed, {.meaning = "another seed makes another sample", .range = not_negative});
  d.array("parameter", sample.parameter, {.meaning = "uncertain parameters"});
  d.value("seeds", sample.seeds,
          {.meaning =
               "keys that get another whole number in each row of the sample, such as random_field.*.seed: each row has a realisation of "
               "its own"});
  d.array("correlation", sample.correlation, {.meaning = "parameters that are not independent"});
}

void check(Describe& d, const StudySample& sample)
{
  std::vector<std::string> names;
  for (const SampleParameter& parameter : sample.parameter) names.push_back(parameter.name);
  check(d, sample.correlation, names, sample.size);
  d.check(!sample.parameter.empty() || !sample.seeds.empty(), "sample", "varies nothing: give it a parameter, or seeds");
  for (const std::string& key : sample.seeds) d.check(key.find('=') == std::string::npos, "sample.seeds", "a key has no =");
  d.check(sample.seeds.empty() || static_cast<Real>(sample.size) * (1. + sample.seed) < 2e9, "sample.seed",
          "is too large: seeds of the rows are whole numbers up to 2e9, (seed - 1) size + 1 and so on");
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
  std::vector<std::string> names;
  for (const SampleParameter& parameter : sample.parameter) {
    axis.parameter.push_back({parameter.name, is_bare(parameter.distribution.unit) ? "" : parameter.distribution.unit});
    medians.push_back(quantile(parameter.distribution, 0.5));
    names.push_back(parameter.name);
  }
  if (!sample.parameter.empty()) axis.value.push_back(value_at(sample, "best", medians));
  for (std::size_t j = 0; j < sample.parameter.size(); ++j)
    for (const auto& [word, share] : {std::pair(" low", low_share), std::pair(" high", high_share)}) {
      std::vector<Real> numbers = medians;
      numbers[j] = quantile(sample.parameter[j].distribution, share);
      axis.value.push_back(value_at(sample, sample.parameter[j].name + word, numbers));
    }
  axis.sample_from = axis.value.size();
  const auto rows = static_cast<std::size_t>(sample.size);
  const std::vector<std::vector<Real>> shares = with_rank_correlations(
      latin_hypercube(sample.parameter.size(), rows, static_cast<std::uint64_t>(sample.seed)), sample.correlation, names);
  for (std::size_t k = 0; k < rows; ++k) {
    std::vector<Real> numbers;
    for (std::size_t j = 0; j < sample.parameter.size(); ++j) numbers.push_back(quantile(sample.parameter[j].distribution, shares[j][k]));
    axis.value.push_back(value_at(sample, fmt::format("{}", k + 1), numbers));
    for (const std::string& key : sample.seeds)
      axis.value.back().set.push_back(fmt::format("{}={}", key, std::max(0, sample.seed - 1) * sample.size + static_cast<int>(k) + 1));
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

namespace {

/// One of 0, 1, ..., count - 1, all as likely: what is left beyond a whole number of rounds is drawn again. std::uniform_int_distribution differs from library to library.
std::uint64_t draw_below(std::uint64_t count, std::mt19937_64& random)
{
  const std::uint64_t end = std::mt19937_64::max() - std::mt19937_64::max() % count;
  std::uint64_t bits = random();
  while (bits >= end) bits = random();
  return bits % count;
}

/// Between 0 and 1, neither of them: the middle of one of 2^52 parts, which a double holds exactly.
Real draw_share(std::mt19937_64& random)
{
  return (static_cast<Real>(random() >> 12) + 0.5) * 0x1p-52;
}

}  // namespace

std::vector<std::vector<Real>> latin_hypercube(std::size_t parameters, std::size_t rows, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::vector<std::vector<Real>> shares(parameters, std::vector<Real>(rows));
  std::vector<std::size_t> order(rows);
  for (std::vector<Real>& share : shares) {
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = rows; k-- > 1;) std::swap(order[k], order[draw_below(k + 1, random)]);
    for (std::size_t k = 0; k < rows; ++k) share[k] = (static_cast<Real>(order[k]) + draw_share(random)) / static_cast<Real>(rows);
  }
  return shares;
}

namespace {

bool is_unbounded(const Distribution& d)
{
  return d.kind == DistributionKind::normal || d.kind == DistributionKind::lognormal;
}

/// A normal distribution whose halves have deviations of their own, of a value or of its logarithm.
struct Halves {
  Real best, below, above;

  explicit Halves(const Distribution& d)
  {
    const Real low = along(d, d.low), high = along(d, d.high), z = standard_normal_quantile(high_share);
    best = d.best ? along(d, *d.best) : (low + high) / 2;
    below = (best - low) / z;
    above = (high - best) / z;
  }
  static Real along(const Distribution& d, Real value) { return d.kind == DistributionKind::lognormal ? std::log(value) : value; }
  static Real back(const Distribution& d, Real y) { return d.kind == DistributionKind::lognormal ? std::exp(y) : y; }

  Real at(Real p) const
  {
    const Real z = standard_normal_quantile(p);
    return best + z * (z < 0 ? below : above);
  }
  /// The share of values below y.
  Real share(Real y) const { return standard_normal_share((y - best) / (y < best ? below : above)); }
};

Real triangular_quantile(Real min, Real peak, Real max, Real p)
{
  const Real rising = (peak - min) / (max - min);  // the share below the peak
  return p < rising ? min + std::sqrt(p * (max - min) * (peak - min)) : max - std::sqrt((1 - p) * (max - min) * (max - peak));
}

}  // namespace

void describe(Describe& d, Distribution& distribution)
{
  const auto number = [&](const char* key, auto& value, const char* meaning, bool required) {
    d.value(key, value, {.meaning = meaning, .required = required, .any_unit = &distribution.unit});
  };
  d.choice("distribution", distribution.kind, distribution_words, {.meaning = "how the values are distributed"});
  number("low", distribution.low, "least value of a uniform or triangular one, 5 % value of the others", true);
  number("best", distribution.best, "most likely value of a triangular one, 50 % value of a normal or lognormal one; absent: the middle",
         false);
  number("high", distribution.high, "greatest value of a uniform or triangular one, 95 % value of the others", true);
  number("min", distribution.min, "lower bound of a normal or lognormal one", false);
  number("max", distribution.max, "upper bound of a normal or lognormal one", false);
}

void check(Describe& d, const std::string& path, const Distribution& c)
{
  d.check(c.low < c.high, path + ".low", "must be less than high");
  const bool triangular = c.kind == DistributionKind::triangular;
  if (c.kind == DistributionKind::uniform) d.check(!c.best, path + ".best", "a uniform distribution has only low and high");
  if (triangular) d.check(c.best.has_value(), path, "a triangular distribution needs best, its most likely value");
  if (c.best && triangular) d.check(c.low <= *c.best && *c.best <= c.high, path + ".best", "must lie from low to high");
  if (c.best && is_unbounded(c)) d.check(c.low < *c.best && *c.best < c.high, path + ".best", "must lie between low and high");
  if (c.kind == DistributionKind::lognormal) d.check(c.low > 0, path + ".low", "must be more than 0 where the logarithm is distributed");
  for (const auto& [bound, key] : {std::pair(c.min, ".min"), std::pair(c.max, ".max")})
    if (bound) d.check(is_unbounded(c), path + key, "is only for normal and lognormal distributions; the others end at low and high");
  if (c.min) d.check(*c.min <= c.low, path + ".min", "must be at most low");
  if (c.max) d.check(*c.max >= c.high, path + ".max", "must be at least high");
}

Real quantile(const Distribution& d, Real p)
{
  if (d.kind == DistributionKind::uniform) return d.low + p * (d.high - d.low);
  if (d.kind == DistributionKind::triangular) return triangular_quantile(d.low, *d.best, d.high, p);
  const Halves halves(d);
  const bool logarithm_ends = d.kind == DistributionKind::lognormal && d.min && *d.min <= 0;  // it has no value there
  const Real from = d.min && !logarithm_ends ? halves.share(Halves::along(d, *d.min)) : 0,
             to = d.max ? halves.share(Halves::along(d, *d.max)) : 1;
  return Halves::back(d, halves.at(from + p * (to - from)));
}

Real standard_normal_share(Real z)
{
  return 0.5 * std::erfc(-z / std::sqrt(2.));
}

Real standard_normal_quantile(Real p)
{
  if (p > 0.5) return -standard_normal_quantile(1 - p);
  Real low = -9, high = 0;
  while (high - low > 1e-15 * std::max<Real>(1, -low)) {
    const Real middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (standard_normal_share(middle) < p ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace berm::study
