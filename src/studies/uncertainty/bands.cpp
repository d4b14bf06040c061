// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/bands.hpp"

#include "record/travel_curve.hpp"
#include "structures/other_bodies.hpp"
#include "structures/structures.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::uncertainty {
namespace {

constexpr int sets_of_rows = 5;
constexpr int curve_points = 40;  // intervals of a curve's band

/// The history without every fifth row, beginning with row `first`; the ends of stages stay, which tell where they end.
run_folder::History thinned(const run_folder::History& history, int first)
{
  run_folder::History kept;
  kept.columns = history.columns;
  kept.values.resize(history.values.size());
  const Index rows = history.rows();
  for (Index k = 0; k < rows; ++k) {
    const bool end = k == 0 || k + 1 == rows || history.stage[k] != history.stage[k - 1] || history.stage[k] != history.stage[k + 1];
    if (!end && k % sets_of_rows == first) continue;
    kept.stage.push_back(history.stage[k]);
    for (std::size_t c = 0; c < history.values.size(); ++c) kept.values[c].push_back(history.values[c][k]);
  }
  return kept;
}

Real value_in(const std::vector<run_folder::Quantity>& quantities, const std::string& name)
{
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const run_folder::Quantity& q) { return q.name == name; });
  return found == quantities.end() ? nan : found->value;
}

/// Numbers of the run and of its variants, one each; NaN where one has none.
struct Numbers {
  std::vector<SizedNumber> by_size;             ///< the run's first, at the run's speed
  std::optional<std::pair<Real, Real>> speeds;  ///< of the coarsest cells: at the run's speed, and at the other
};

Numbers numbers_of(Real of_run, const std::vector<VariantRecord>& variants, const std::vector<Real>& of_variants)
{
  Numbers numbers{{{1, of_run}}, {}};
  for (std::size_t k = 0; k < variants.size(); ++k) {
    if (variants[k].speed == 1)
      numbers.by_size.push_back({variants[k].size, of_variants[k]});
    else
      numbers.speeds = {numbers.by_size.back().number, of_variants[k]};
  }
  return numbers;
}

run_folder::Band band_of(const Numbers& numbers, Real noise)
{
  const Estimate estimate = extrapolate(numbers.by_size);
  run_folder::Band band;
  band.value = numbers.by_size.front().number;
  band.converged = estimate.converged;
  band.extrapolation = estimate.extrapolation;
  band.mesh = estimate.mesh;
  band.noise = noise;
  band.speed = numbers.speeds ? std::abs(numbers.speeds->second - numbers.speeds->first) : 0;
  band.half_width = half_width(band.extrapolation, band.mesh, band.noise, band.speed);
  return band;
}

/// A curve that has a band: at travel s it stands at x = begin + direction s.
struct BandedCurve {
  std::string chart;
  Real begin, direction;
  record::TravelCurve values;
};
using BandedCurves = std::vector<BandedCurve>;

/// Those of pushes and drags: of the way down, then H and w of each drag. None of a body that is loaded where it stands.
BandedCurves banded(const base::Charts& charts)
{
  BandedCurves curves;
  if (curves_in(charts, "V_w").empty()) return curves;
  const auto add = [&](const char* chart, const base::Curve& curve) {
    curves.push_back({chart, curve.begin, curve.direction, {curve.travel, curve.y}});
  };
  for (const base::Curve& push : curves_in(charts, "V_w")) add("V_w", push);
  const std::vector<base::Curve>& w = curves_in(charts, "w_u");
  for (std::size_t k = 0; k < w.size(); ++k) add("H_u", curves_in(charts, "H_u")[k]), add("w_u", w[k]);
  return curves;
}

/// The band of a curve of the run, which each variant has at the same place; it ends where one of them does.
run_folder::CurveBand band_of(const BandedCurve& curve, const std::vector<VariantRecord>& variants,
                              const std::vector<const BandedCurve*>& of_variants, Real averaging)
{
  run_folder::CurveBand band{curve.chart, {}, {}, {}};
  const Real begin = curve.values.begin(), end = curve.values.end(), step = (end - begin) / curve_points;
  const Real half = std::max(averaging, step);
  for (int k = 0; k <= curve_points; ++k) {
    const Real s = k == curve_points ? end : begin + k * step;
    std::vector<Real> numbers;
    // A run ends at the limit of its stage but for a step of its own.
    for (const BandedCurve* variant : of_variants) {
      const record::TravelCurve& values = variant->values;
      numbers.push_back(values.at(s > values.end() && s < values.end() + 0.1 * step ? values.end() : s, half));
    }
    // The rows' noise is in the scatter from mesh to mesh.
    const run_folder::Band at = band_of(numbers_of(curve.values.at(s, half), variants, numbers), 0);
    band.x.push_back(curve.begin + curve.direction * s);
    band.low.push_back(at.converged - at.half_width);
    band.high.push_back(at.converged + at.half_width);
  }
  return band;
}

/// Names a curve by its chart, and by the drag it is of where that has one of each.
std::string name_of(const BandedCurves& curves, std::size_t which)
{
  const std::string& chart = curves[which].chart;
  const auto in_chart = [&](const BandedCurve& curve) { return curve.chart == chart; };
  const auto first = curves.begin(), here = first + static_cast<std::ptrdiff_t>(which);
  const auto before = std::count_if(first, here, in_chart);
  return before == 0 ? "curve " + chart : fmt::format("curve {} of drag {}", chart, before + 1);
}

void add_curve_bands(run_folder::Uncertainty& found, const record::RunRecord& run, const std::vector<VariantRecord>& variants,
                     const base::Structure& structure)
{
  std::vector<BandedCurves> of_variants;
  for (const VariantRecord& variant : variants) of_variants.push_back(banded(structure.charts(variant.run)));
  const BandedCurves of_run = banded(structure.charts(run));
  for (std::size_t k = 0; k < of_run.size(); ++k) {
    if (of_run[k].values.empty()) continue;
    std::vector<const BandedCurve*> same;
    for (const BandedCurves& curves : of_variants)
      if (k < curves.size() && curves[k].chart == of_run[k].chart && !curves[k].values.empty())
        same.push_back(&curves[k]);
      else
        break;
    if (same.size() == variants.size())
      found.curves.push_back(band_of(of_run[k], variants, same, averaging_half(base::body_scale(run))));
    else
      found.without.emplace_back(name_of(of_run, k), fmt::format("{} has no such curve", variants[same.size()].run.name));
  }
}

/// Why a number has no band: `of_variants` are those of the runs with coarser cells.
std::string reason_without(const std::vector<VariantRecord>& variants, const std::vector<Real>& of_variants, Real noise)
{
  for (std::size_t k = 0; k < of_variants.size(); ++k)
    if (!std::isfinite(of_variants[k])) return fmt::format("{} has no such number", variants[k].run.name);
  return std::isnan(noise) ? "noise: no value without every fifth row of the history" : "too few runs of different cells to fit a line";
}

}  // namespace

std::vector<Real> noise_of(const record::RunRecord& run)
{
  std::vector<Real> noise(run.quantities.size(), 0);
  if (!base::body_scale(run).noisy) return noise;
  std::vector<std::vector<run_folder::Quantity>> without;
  for (int set = 0; set < sets_of_rows; ++set) {
    record::RunRecord part = run;
    part.history = thinned(run.history, set);
    part.folder.clear();  // what is seen in frames has no noise of rows
    without.push_back(structures::quantities_of(part, {}));
  }
  for (std::size_t k = 0; k < noise.size(); ++k) {
    Real sum = 0, squares = 0;
    int found_in = 0;
    for (const auto& quantities : without) {
      const Real value = value_in(quantities, run.quantities[k].name);
      found_in += std::isnan(value) ? 0 : 1;
      sum += value;
      squares += value * value;
    }
    if (found_in == 0) continue;  // not of the rows
    const Real spread = squares - sum * sum / sets_of_rows;
    noise[k] = std::isnan(spread) ? nan : 2 * std::sqrt(std::max(Real(0), spread) * (sets_of_rows - 1) / sets_of_rows);
  }
  return noise;
}

run_folder::Uncertainty bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants)
{
  const base::Structure& structure = structures::structure_of(run.settings);
  run_folder::Uncertainty found;
  const std::vector<Real> noise = noise_of(run);
  for (std::size_t k = 0; k < run.quantities.size(); ++k) {
    const run_folder::Quantity& q = run.quantities[k];
    if (q.kind != run_folder::QuantityKind::answer || !std::isfinite(q.value)) continue;
    std::vector<Real> numbers;
    for (const VariantRecord& variant : variants) numbers.push_back(value_in(variant.run.quantities, q.name));
    const run_folder::Band band = band_of(numbers_of(q.value, variants, numbers), noise[k]);
    if (std::isfinite(band.half_width)) {
      found.quantities.push_back({q.name, q.unit, band});
      continue;
    }
    found.without.emplace_back(q.name, reason_without(variants, numbers, noise[k]));
  }
  add_curve_bands(found, run, variants, structure);
  return found;
}

run_folder::Grains grains_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants)
{
  run_folder::Grains grains;
  std::vector<const VariantRecord*> with;
  for (const VariantRecord& variant : variants)
    if (variant.d50) with.push_back(&variant);
  if (with.empty()) return grains;
  grains.size = with.front()->size;
  for (const VariantRecord* variant : with) grains.d50.push_back(*variant->d50);
  const auto without = std::find_if(variants.begin(), variants.end(), [&](const VariantRecord& variant) {
    return !variant.d50 && variant.speed == 1 && variant.size == grains.size;
  });
  for (const run_folder::Quantity& q : run.quantities) {
    const Real number = value_in(without->run.quantities, q.name);
    if (q.kind != run_folder::QuantityKind::answer || !std::isfinite(q.value) || !std::isfinite(number)) continue;
    grains.numbers.push_back({q.name, q.unit, number, {}});
    for (const VariantRecord* variant : with) grains.numbers.back().with.push_back(value_in(variant->run.quantities, q.name));
  }
  return grains;
}

namespace {

/// Forces as they are, lengths in mm.
struct ShownUnit {
  Real per_si;
  std::string name;
};

ShownUnit shown_unit(const std::string& unit)
{
  return unit == "m" ? ShownUnit{1000, "mm"} : ShownUnit{1, unit == "1" ? "" : unit};
}

std::string part(Real number, Real per_si)
{
  return text::short_number(number * per_si);
}

std::string words_of(const run_folder::Grains& grains)
{
  std::string table =
      fmt::format("the sand has no d50, so the width of its shear bands is set by the cells; on cells {:.3g} times as large:\n{:<24}{:>12}",
                  grains.size, "", "no d50");
  for (const Real d50 : grains.d50) table += fmt::format("{:>14}", fmt::format("d50 {:g} mm", 1000 * d50));
  for (const auto& [name, unit, without, with] : grains.numbers) {
    const auto& [per_si, shown] = shown_unit(unit);
    table += fmt::format("\n{:<24}{:>12}", name, part(without, per_si));
    for (const Real number : with) table += fmt::format("{:>14}", part(number, per_si));
    table += " " + shown;
  }
  return table + "\ngive the d50 of the sand, and the band is that of its own result\n";
}

}  // namespace

std::string words_of(const run_folder::Uncertainty& u, settings::Method method)
{
  Real largest = 1, time = 0;
  for (const run_folder::BandRun& run : u.runs) largest = std::max(largest, run.size), time += run.wall_s;
  std::string table = fmt::format("uncertainty: {} runs with cells up to {:.3g} times as large, {:.3g} s of one thread in total\n",
                                  u.runs.size(), largest, time);
  table += fmt::format("{:<24}{:>12}{:>24}{:>6}{:>16}{:>10}{:>10}{:>12}\n", "", "this run", "converged", "", "extrapolation", "mesh",
                       "noise", method == settings::Method::fem ? "increments" : "speed");
  for (const auto& [name, unit, band] : u.quantities) {
    const auto& [per_si, shown] = shown_unit(unit);
    table += fmt::format("{:<24}{:>12}{:>24} {:<5}{:>16}{:>10}{:>10}{:>12}\n", name, part(band.value, per_si),
                         text::with_half_width(band.converged * per_si, band.half_width * per_si, "+-"), shown,
                         part(band.extrapolation, per_si), part(band.mesh, per_si), part(band.noise, per_si), part(band.speed, per_si));
  }
  table += "converged +- half width of the 95 % band: extrapolation + sqrt(mesh^2 + noise^2 + speed^2)\n";
  for (const std::string& why : u.left_out) table += fmt::format("not in the bands: {}\n", why);
  for (const auto& [name, why] : u.without) table += fmt::format("without a band: {}: {}\n", name, why);
  if (!u.grains.numbers.empty()) table += words_of(u.grains);
  return table;
}

namespace {

/// The order of convergence is near 1 and not known well: from about 3/4, for which the way to size 0 is half as long again, to 3/2, for which it is half as long.
constexpr Real uncertain_part = 0.5;

}  // namespace

Real student_95(int degrees_of_freedom)
{
  constexpr std::array quantiles = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  if (degrees_of_freedom < 1) return nan;
  return quantiles[static_cast<std::size_t>(std::min<int>(degrees_of_freedom, quantiles.size())) - 1];
}

Estimate extrapolate(const std::vector<SizedNumber>& numbers)
{
  Real weights = 0, mean_size = 0, mean = 0;
  for (const auto& [size, number] : numbers) {
    const Real weight = 1 / (size * size);
    weights += weight;
    mean_size += weight * size;
    mean += weight * number;
  }
  mean_size /= weights;
  mean /= weights;
  Real along = 0, product = 0;
  for (const auto& [size, number] : numbers) {
    const Real weight = 1 / (size * size);
    along += weight * (size - mean_size) * (size - mean_size);
    product += weight * (size - mean_size) * (number - mean);
  }
  const int more = static_cast<int>(numbers.size()) - 2;
  if (more < 1 || !(along > 0)) return {nan, nan, nan};
  const Real slope = product / along, converged = mean - slope * mean_size;
  Real squares = 0;
  for (const auto& [size, number] : numbers) squares += std::pow((number - converged - slope * size) / size, 2);
  const Real deviation = std::sqrt(squares / more * (1 / weights + mean_size * mean_size / along));
  return {converged, uncertain_part * std::abs(slope), student_95(more) * deviation};
}

Real half_width(Real extrapolation, Real mesh, Real noise, Real speed)
{
  return extrapolation + std::sqrt(mesh * mesh + noise * noise + speed * speed);
}

}  // namespace berm::uncertainty
