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

Estimate estimate_of(const Group& group, std::size_t along, const StudyAxis& axis, std::size_t measure)
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
      if (is_wanted(plan.study.measure[m], *group[0])) estimates.push_back(estimate_of(group, along, *axis, m));
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

namespace {

/// The place of each value in order, from 0; equal ones have the mean of theirs.
std::vector<Real> places_of(const std::vector<Real>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<Real> places(values.size());
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    while (end < order.size() && values[order[end]] == values[order[first]]) ++end;
    for (std::size_t k = first; k < end; ++k) places[order[k]] = static_cast<Real>(first + end - 1) / 2;
  }
  return places;
}

}  // namespace

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

Real rank_correlation(const std::vector<Real>& x, const std::vector<Real>& y)
{
  if (x.size() < 3) return nan;
  const std::vector<Real> of_x = places_of(x), of_y = places_of(y);
  const Real middle = static_cast<Real>(x.size() - 1) / 2;
  Real xy = 0, xx = 0, yy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    xy += (of_x[k] - middle) * (of_y[k] - middle);
    xx += (of_x[k] - middle) * (of_x[k] - middle);
    yy += (of_y[k] - middle) * (of_y[k] - middle);
  }
  return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : nan;
}

}  // namespace berm::study
