// SPDX-License-Identifier: BSD-3-Clause
#include "soil_fit/passages.hpp"

#include "material/clay.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace berm::soil_fit {
namespace {

constexpr std::size_t least_passages = 6;

/// From one turning point of the depth to the next.
struct Stroke {
  std::size_t first, last;  ///< rows
  bool down;
};

/// Turning points are those from which the depth goes back by half a diameter: less is the noise of a sensor, or a change of rods.
std::vector<Stroke> strokes_of(const std::vector<Real>& depth, Real diameter)
{
  const Real least = diameter / 2;
  std::vector<Stroke> all;
  std::size_t begin = 0, extreme = 0;
  int way = 0;
  for (std::size_t row = 1; row < depth.size(); ++row) {
    const Real gone = depth[row] - depth[extreme];
    if (way == 0) {
      if (std::abs(gone) >= least) way = gone > 0 ? 1 : -1, extreme = row;
    } else if (way * gone >= 0) {
      extreme = row;
    } else if (-way * gone >= least) {
      all.push_back({begin, extreme, way > 0});
      begin = extreme, extreme = row, way = -way;
    }
  }
  if (way != 0) all.push_back({begin, extreme, way > 0});
  return all;
}

/// Strokes over one interval: from a penetration on to the one that goes on to greater depths, which begins the next interval, too.
std::vector<std::vector<Stroke>> intervals_of(const std::vector<Stroke>& strokes, const std::vector<Real>& depth, Real diameter)
{
  std::vector<std::vector<Stroke>> all;
  for (const Stroke& stroke : strokes) {
    if (all.empty()) {
      all.push_back({stroke});
      continue;
    }
    all.back().push_back(stroke);
    if (stroke.down && depth[stroke.last] > depth[all.back().front().last] + diameter) all.push_back({stroke});
  }
  return all;
}

Real median(std::vector<Real> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Depth and resistance of the rows that have both, SI.
struct Soundings {
  std::vector<std::size_t> rows;
  std::vector<Real> depth, resistance;
};

Soundings soundings_of(const MeasuredFile& file, const LaboratoryTable& table, const std::vector<std::size_t>& rows)
{
  constexpr Real most_depth = 300, least_resistance = 100,
                 most_resistance = 2e7;  // m below the seabed, Pa, Pa: beyond, the unit is another
  const Penetrometer& tool = *penetrometer_of(file.kind);
  Real area = 1;
  if (!table.has(Reading::resistance)) {
    const bool is_ball = std::holds_alternative<Ball>(file.kind);
    if (!tool.area && !is_ball)
      table.refuse(rows.front(), fmt::format("{} is a force, and needs an area, diameter times length of the bar: measured.{}.area",
                                             table.words_of(Reading::force), file.name));
    area = tool.area.value_or(pi / 4 * tool.diameter * tool.diameter);
  }
  const Reading reading = table.has(Reading::resistance) ? Reading::resistance : Reading::force;
  Soundings all;
  for (const std::size_t row : rows) {
    const Real depth = table.value(Reading::depth, row), resistance = table.value(reading, row) / area;
    if (!std::isfinite(depth) || !std::isfinite(resistance)) continue;
    if (depth < -tool.diameter)
      table.refuse(row, fmt::format("{} is {:.4g} m: it is positive below the seabed", table.words_of(Reading::depth), depth));
    if (depth > most_depth)
      table.refuse(row, fmt::format("{} is {:.4g} m, deeper below the seabed than any such test: is its unit right?",
                                    table.words_of(Reading::depth), depth));
    all.rows.push_back(row), all.depth.push_back(depth), all.resistance.push_back(resistance);
  }
  if (all.rows.size() < 2) table.refuse(rows.front(), "no two rows have a depth and a resistance");
  const auto most =
      std::max_element(all.resistance.begin(), all.resistance.end(), [](Real a, Real b) { return std::abs(a) < std::abs(b); });
  if (std::abs(*most) < least_resistance || std::abs(*most) > most_resistance)
    table.refuse(all.rows[static_cast<std::size_t>(most - all.resistance.begin())],
                 fmt::format("{} is {:.4g} Pa at most, which is not the resistance of clay: is its unit right?", table.words_of(reading),
                             std::abs(*most)));
  return all;
}

/// Mean of a stroke over the middle third of an interval; rows that are fewer tell no mean.
Real mean_of(const Soundings& soundings, const Stroke& stroke, Real top, Real bottom, const LaboratoryTable& table)
{
  constexpr int least_rows = 3;
  const Real third = (bottom - top) / 3;
  Real sum = 0;
  int count = 0;
  for (std::size_t k = stroke.first; k <= stroke.last; ++k)
    if (soundings.depth[k] >= top + third && soundings.depth[k] <= bottom - third) sum += soundings.resistance[k], ++count;
  if (count < least_rows)
    table.refuse(soundings.rows[stroke.first],
                 fmt::format("the passage that begins here has {} rows from {:.4g} to {:.4g} m, the middle third of its interval: {} are "
                             "needed for a mean",
                             count, top + third, bottom - third, least_rows));
  return sum / count;
}

/// Down positive, up negative.
void check_signs(const std::vector<Real>& signed_means, const std::vector<Stroke>& strokes, const Soundings& soundings,
                 const LaboratoryTable& table)
{
  for (std::size_t k = 0; k < 2; ++k) {
    const bool wrong = strokes[k].down ? signed_means[k] < 0 : signed_means[k] > 0;
    if (!wrong) continue;
    table.refuse(soundings.rows[strokes[k].first],
                 fmt::format("the resistance of the first {} is {:.4g} kPa on average: it is positive down, and negative where the tool is "
                             "pulled up",
                             strokes[k].down ? "penetration" : "extraction", signed_means[k] / 1e3));
  }
}

/// How far the resistance of remoulded clay is higher down than up, halved: over the last half of the passages, each against the mean of its neighbours, so that what clay loses from
/// passage to passage cancels; down positive.
Real asymmetry(const std::vector<Real>& sizes)
{
  Real sum = 0;
  int count = 0;
  for (std::size_t k = sizes.size() / 2; k + 1 < sizes.size(); ++k, ++count) {
    const Real sense = k % 2 == 0 ? 1 : -1;  // the first passage goes down
    sum += sense * (sizes[k] / 2 - (sizes[k - 1] + sizes[k + 1]) / 4);
  }
  return count > 0 ? sum / count : 0;
}

}  // namespace

std::vector<std::vector<Reading>> columns_of_passages()
{
  return {{Reading::depth}, {Reading::resistance, Reading::force}};
}

std::vector<MeasuredTest> passages_of(const MeasuredFile& file, const LaboratoryTable& table, const std::string& name,
                                      const std::vector<std::size_t>& rows)
{
  const Penetrometer& tool = *penetrometer_of(file.kind);
  const Soundings soundings = soundings_of(file, table, rows);
  const std::vector<Stroke> strokes = strokes_of(soundings.depth, tool.diameter);
  if (!strokes.empty() && !strokes.front().down)
    table.refuse(soundings.rows.front(), "the tool moves up first: the first penetration, through intact clay, is needed");
  std::vector<std::vector<Stroke>> intervals = intervals_of(strokes, soundings.depth, tool.diameter);
  std::size_t most = 0;
  for (const std::vector<Stroke>& interval : intervals) most = std::max(most, interval.size());
  std::erase_if(intervals, [](const std::vector<Stroke>& interval) { return interval.size() < least_passages; });
  if (intervals.empty()) {
    const auto [least, deepest] = std::minmax_element(soundings.depth.begin(), soundings.depth.end());
    table.refuse(soundings.rows.front(),
                 fmt::format("from {:.4g} to {:.4g} m the tool passes no depth more often than {}: remoulding takes {} passages, three "
                             "cycles down and up, or more",
                             *least, *deepest, most < 2 ? "once" : fmt::format("{} times", most), least_passages));
  }
  std::vector<MeasuredTest> tests;
  for (const std::vector<Stroke>& interval : intervals) {
    std::vector<Real> tops, bottoms;
    for (std::size_t k = 0; k + 1 < interval.size(); ++k) (interval[k].down ? bottoms : tops).push_back(soundings.depth[interval[k].last]);
    MeasuredTest& test = tests.emplace_back();
    Passages passages{word_of(file.kind), tool, 0, median(tops), median(bottoms)};
    passages.depth = (passages.top + passages.bottom) / 2;
    test.settings.strain_rate = file.strain_rate;
    test.name = intervals.size() == 1 ? name : fmt::format("{} {:.4g} m", name, passages.depth);
    std::vector<Real> means;
    for (const Stroke& stroke : interval)
      means.push_back(mean_of(soundings, stroke, passages.top, passages.bottom, table) - tool.zero_shift);
    check_signs(means, interval, soundings, table);
    for (std::size_t k = 0; k < means.size(); ++k) {
      test.driven.push_back(static_cast<Real>(k + 1));
      if (!interval[k].down) means[k] = -means[k];
    }
    test.curves.push_back({Compared::resistance, means});
    test.passages = passages;
  }
  return tests;
}

std::vector<Real> resistances(const MeasuredTest& test, const material::Material& clay)
{
  constexpr Real gravity = 9.80665;
  const Passages& passages = *test.passages;
  const material::Material there = material::at_depth(clay, passages.depth, gravity * material::density(clay) * passages.depth);
  const auto& law = there.get<material::Clay>();
  const material::PreparedClay prepared = prepare(law);
  const Real rate = test.settings.strain_rate.value_or(0) * prepared.per_reference;
  std::vector<Real> all;
  for (const Real k : test.driven) {
    const Real xi = (k - 0.5) * passages.settings.passage_strain;
    all.push_back(passages.settings.resistance_factor * law.undrained_strength *
                  material::ClayStrength<Real>(prepared, xi, rate, 0, 1, 1).relative);
  }
  return all;
}

std::vector<std::string> doubts_of_passages(const MeasuredTest& test, const std::vector<Real>& computed)
{
  constexpr Real asymmetric = 0.05, unfinished = 0.1, shallow = 5, narrow = 4;  // the last two: diameters
  const Passages& passages = *test.passages;
  const std::vector<Real>& sizes = test.curves[0].values;
  const Real off = asymmetry(sizes), last = (sizes.back() + sizes[sizes.size() - 2]) / 2, diameter = passages.settings.diameter;
  std::vector<std::string> all;
  if (std::abs(off) > asymmetric * std::abs(last))
    all.push_back(fmt::format("{}: in the last passages the resistance down is {:.0f} % {} than that up, and remoulded clay resists both "
                              "alike: a zero shift or a ground pressure that was not subtracted, zero_shift = \"{:.3g} kPa\"",
                              test.name, 200 * std::abs(off / last), off > 0 ? "higher" : "lower",
                              (passages.settings.zero_shift + off) / 1e3));
  const Real law_last = computed.back(), lost = computed.front() - law_last;
  if (const Real per_passage = computed[computed.size() - 2] - law_last; lost > 0 && per_passage > 0) {
    const Real ratio = per_passage / (computed[computed.size() - 3] - computed[computed.size() - 2]);
    const Real left = per_passage * ratio / (1 - ratio);  // of a geometric series
    if (ratio < 1 && left > unfinished * (law_last - left))
      all.push_back(fmt::format("{}: after the last passage the clay would lose another {:.0f} % of its resistance: the sensitivity is an "
                                "extrapolation, and more cycles would show it",
                                test.name, 100 * left / law_last));
  }
  if (passages.depth < shallow * diameter)
    all.push_back(fmt::format("{}: {:.1f} diameters below the seabed clay does not flow around the tool as it does at depth, above all in "
                              "the first penetration",
                              test.name, passages.depth / diameter));
  if (passages.bottom - passages.top < narrow * diameter)
    all.push_back(fmt::format("{}: the interval is {:.1f} diameters, so that the turning points are felt in its middle", test.name,
                              (passages.bottom - passages.top) / diameter));
  return all;
}

std::string passages_html(const MeasuredTest& test, const std::vector<Real>& computed)
{
  const std::vector<Real>& measured = test.curves[0].values;
  std::string html = fmt::format("<p>{}, {:.4g} to {:.4g} m, each passage over the middle third:</p>\n<table>\n",
                                 text::html_text(test.name), test.passages->top, test.passages->bottom);
  html += text::plain_row({"passage", "", "resistance (kPa)", "computed", "q_k / q_1", "computed"}, 2, 6, "th");
  for (std::size_t k = 0; k < measured.size(); ++k)
    html += text::plain_row({std::to_string(k + 1), k % 2 == 0 ? "down" : "up", fmt::format("{:.2f}", measured[k] / 1e3),
                             fmt::format("{:.2f}", computed[k] / 1e3), fmt::format("{:.3f}", measured[k] / measured[0]),
                             fmt::format("{:.3f}", computed[k] / computed[0])},
                            2, 6, "td");
  return html + "</table>\n";
}

}  // namespace berm::soil_fit
