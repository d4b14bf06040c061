// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/study/study_sample_test.cpp
#include "study/estimates.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "io/log.hpp"

namespace berm::study {
namespace {

/// The rows that differ only along the sample.
using Group = std::vector<const StudyRow*>;

/// The measure of the value at this place of the axis.
Real number_at(const Group& group, std::size_t along, std::size_t place, std::size_t measure)
{
  for (const StudyRow* row : group)
    if (row->choice[along] == place) return row->numbers[measure];
  return nan;
}

Swing swing_of(const Group& group, std::size_t along, const StudyAxis& axis, std::size_t parameter, std::size_t measure)
{
  Swing swing{parameter, nan, nan, nan};
  if (*axis.sample_from > 0) {
    swing.low = number_at(group, along, 1 + 2 * parameter, measure);
    swing.high = number_at(group, along, 2 + 2 * parameter, measure);
  }
  std::vector<Real> x, y;
  for (const StudyRow* row : group) {
    const StudyValue& value = axis.value[row->choice[along]];
    if (row->choice[along] < *axis.sample_from || std::isnan(row->numbers[measure]) || std::isnan(value.number[parameter])) continue;
    x.push_back(value.number[parameter]);
    y.push_back(row->numbers[measure]);
  }
  swing.correlation = rank_correlation(x, y);
  return swing;
}

Estimate estimate_of(const Group& group, std::size_t along, const StudyAxis& axis, std::size_t measure, const std::optional<Real>& limit)
{
  Estimate estimate{};
  estimate.names = group[0]->names;
  estimate.names.erase(estimate.names.begin() + static_cast<std::ptrdiff_t>(along));
  estimate.measure = measure;
  estimate.best = *axis.sample_from > 0 ? number_at(group, along, 0, measure) : nan;
  std::vector<Real> numbers;
  for (const StudyRow* row : group) {
    if (row->choice[along] < *axis.sample_from) continue;
    estimate.failed += row->end.kind == jobs::JobEnd::Kind::failed;
    if (!std::isnan(row->numbers[measure])) numbers.push_back(row->numbers[measure]);
  }
  estimate.numbers = numbers.size();
  estimate.low = sample_quantile(numbers, 0.05);
  estimate.middle = sample_quantile(numbers, 0.5);
  estimate.high = sample_quantile(numbers, 0.95);
  estimate.mean = mean_of(numbers);
  estimate.spread = spread_of(numbers, limit);
  for (std::size_t j = 0; j < axis.parameter.size(); ++j) estimate.swing.push_back(swing_of(group, along, axis, j, measure));
  const auto size = [](Real value) { return std::isnan(value) ? -1 : std::abs(value); };
  std::stable_sort(estimate.swing.begin(), estimate.swing.end(), [&](const Swing& a, const Swing& b) {
    return std::pair(size(a.width()), size(a.correlation)) > std::pair(size(b.width()), size(b.correlation));
  });
  return estimate;
}

}  // namespace

bool is_wanted(const StudyMeasure& measure, const StudyRow& row)
{
  return measure.cases.empty() || std::find(measure.cases.begin(), measure.cases.end(), row.names[0]) != measure.cases.end();
}

std::vector<Estimate> estimates_of(const StudyPlan& plan)
{
  const StudyAxis* axis = sample_of(plan.study);
  if (axis == nullptr) return {};
  const auto along = static_cast<std::size_t>(axis - plan.study.axis.data()) + 1;
  std::vector<Group> groups;
  std::map<std::vector<std::size_t>, std::size_t> group_of;
  for (const StudyRow& row : plan.rows) {
    std::vector<std::size_t> others = row.choice;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(along));
    const auto [group, is_new] = group_of.try_emplace(others, groups.size());
    if (is_new) groups.emplace_back();
    groups[group->second].push_back(&row);
  }
  std::vector<Estimate> estimates;
  for (const Group& group : groups)
    for (std::size_t m = 0; m < plan.study.measure.size(); ++m)
      if (is_wanted(plan.study.measure[m], *group[0]))
        estimates.push_back(estimate_of(group, along, *axis, m, plan.study.measure[m].limit));
  return estimates;
}

void warn_of_small_sample(const std::filesystem::path& file, const Study& study)
{
  constexpr std::size_t least = 20;
  const StudyAxis* axis = sample_of(study);
  const std::size_t rows = axis == nullptr ? least : axis->value.size() - *axis->sample_from;
  if (rows < least)
    io::warn("{}: a sample of {} rows is too small for 5 and 95 %{}: take {} at least, 50 to 100 for a reliable number", file.string(),
             rows, rows < 10 ? ", which stay empty" : "", least);
}

Real sample_quantile(std::vector<Real> values, Real p)
{
  std::sort(values.begin(), values.end());
  const auto count = static_cast<Real>(values.size());
  const Real place = p * count - 0.5, rounding = 1e-9;
  if (values.empty() || place < -rounding || place > count - 1 + rounding) return nan;
  const Real first = std::clamp<Real>(std::floor(place + rounding), 0, count - 1);
  const auto k = static_cast<std::size_t>(first);
  return k + 1 < values.size() ? values[k] + std::max<Real>(0, place - first) * (values[k + 1] - values[k]) : values[k];
}

Real mean_of(const std::vector<Real>& values)
{
  return values.empty() ? nan : std::accumulate(values.begin(), values.end(), Real(0)) / static_cast<Real>(values.size());
}

Spread spread_of(const std::vector<Real>& numbers, const std::optional<Real>& limit)
{
  Spread spread;
  const auto count = static_cast<Real>(numbers.size());
  const auto deviation = [&](Real mean, const auto& of) {
    Real squares = 0;
    for (const Real number : numbers) squares += std::pow(of(number) - mean, 2);
    return numbers.size() > 1 ? std::sqrt(squares / (count - 1)) : nan;
  };
  spread.deviation = deviation(mean_of(numbers), [](Real number) { return number; });
  if (!numbers.empty() && *std::min_element(numbers.begin(), numbers.end()) > 0) {
    Real sum = 0;
    for (const Real number : numbers) sum += std::log(number);
    spread.log_mean = sum / count;
    spread.log_deviation = deviation(spread.log_mean, [](Real number) { return std::log(number); });
  }
  if (!limit || numbers.empty()) return spread;
  const auto below = static_cast<Real>(std::count_if(numbers.begin(), numbers.end(), [&](Real number) { return number < *limit; }));
  const Real likely = (below + 1) / (count + 2);
  spread.below = below / count;
  spread.below_error = std::sqrt(likely * (1 - likely) / count);
  if (*limit > 0 && spread.log_deviation > 0)
    spread.below_by_lognormal = standard_normal_share((std::log(*limit) - spread.log_mean) / spread.log_deviation);
  return spread;
}

}  // namespace berm::study
