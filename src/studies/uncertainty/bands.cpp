// SPDX-License-Identifier: BSD-3-Clause
#include "uncertainty/bands.hpp"

#include "record/travel_curve.hpp"
#include "structures/driven/path.hpp"
#include "structures/other_bodies.hpp"
#include "structures/structures.hpp"
#include "uncertainty/bands_estimate.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::uncertainty {
namespace {

constexpr int sets_of_rows = 5;
constexpr int curve_points = 40;      // intervals of a curve's band
constexpr Real part_of_travel = 0.2;  // to either side at most, over which differences of runs are taken
constexpr int shared_points = 4;      // to either side, whose scatter about their lines is one

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

/// Standard deviations of ten meshes of D/8 (examples/mesh_patterns), as parts of the number.
struct MeshScatter {
  Real in_pushes;  ///< of V
  Real in_drags;   ///< root mean square of H and w
};

MeshScatter scatter_at_eighth(const settings::Case& c)
{
  const bool clay = base::body_scale(c).strength > 0;
  if (c.method == settings::Method::fem) return clay ? MeshScatter{0.003, 0.003} : MeshScatter{0.02, 0.02};
  const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh);
  if (bed != nullptr && bed->pattern == mesh::SeabedPattern::lattice) return clay ? MeshScatter{0.011, 0.018} : MeshScatter{0.055, 0.014};
  return clay ? MeshScatter{0.02, 0.026} : MeshScatter{0.057, 0.03};
}

/// The same of the finest of these runs, as a part of the number: it is in proportion to the cells.
Real scatter_of_finest(const record::RunRecord& run, const std::vector<VariantRecord>& variants, Scatters scatters)
{
  if (scatters == Scatters::not_at_all) return 0;
  Real finest = 1;
  for (const VariantRecord& variant : variants) finest = std::min(finest, variant.size);
  const Real across = base::body_scale(run).width / (finest * base::near_cell_size(run.settings));
  const MeshScatter scatter = scatter_at_eighth(run.settings);
  return (scatters == Scatters::as_in_pushes ? scatter.in_pushes : scatter.in_drags) * 8 / across;
}

Real value_in(const std::vector<run_folder::Quantity>& quantities, const std::string& name)
{
  const auto found = std::find_if(quantities.begin(), quantities.end(), [&](const run_folder::Quantity& q) { return q.name == name; });
  return found == quantities.end() ? nan : found->value;
}

/// Numbers of the run and of its variants, one each; NaN where one has none.
struct Numbers {
  std::vector<SizedNumber> by_size;             ///< the run's first, at the run's speed
  std::optional<std::pair<Real, Real>> speeds;  ///< of one size: at the run's speed, and at the other

  const SizedNumber& of_run() const { return by_size.front(); }
  const SizedNumber& finest() const { return *std::ranges::min_element(by_size, {}, &SizedNumber::size); }
};

Numbers numbers_of(Real of_run, const std::vector<VariantRecord>& variants, const std::vector<Real>& of_variants)
{
  Numbers numbers{{{1, of_run}}, {}};
  for (std::size_t k = 0; k < variants.size(); ++k)
    if (variants[k].speed == 1) numbers.by_size.push_back({variants[k].size, of_variants[k]});
  for (std::size_t k = 0; k < variants.size(); ++k) {
    if (variants[k].speed == 1) continue;
    const auto same = std::ranges::find(numbers.by_size, variants[k].size, &SizedNumber::size);
    if (same != numbers.by_size.end()) numbers.speeds = {same->number, of_variants[k]};
  }
  return numbers;
}

/// The band of numbers, whose differences are taken where they have little noise: `smooth` are the same over the travel of a cell.
run_folder::Band band_of(const Numbers& numbers, const Numbers& smooth, const Estimate& estimate, Real noise)
{
  run_folder::Band band;
  band.value = numbers.of_run().number;
  band.converged = estimate.converged + numbers.finest().number - smooth.finest().number;
  band.order = estimate.order;
  band.extrapolation = estimate.extrapolation;
  band.mesh = estimate.mesh;
  band.noise = noise;
  band.speed = smooth.speeds ? std::abs(smooth.speeds->second - smooth.speeds->first) : 0;
  band.half_width = half_width(band.extrapolation, band.mesh, band.noise, band.speed);
  return band;
}

/// Whether all runs have one number: it is of the input, as where a body lies at the start, and cells do not make it scatter.
bool is_shared(const Numbers& numbers)
{
  constexpr Real rounding = 1e-5;
  const auto [least, largest] = std::ranges::minmax(numbers.by_size, {}, &SizedNumber::number);
  return largest.number - least.number <= rounding * std::abs(largest.number);
}

bool is_whole(const Numbers& numbers)
{
  return std::ranges::all_of(numbers.by_size, [](const SizedNumber& each) { return std::isfinite(each.number); }) &&
         (!numbers.speeds || std::isfinite(numbers.speeds->first + numbers.speeds->second));
}

/// The same with numbers that have a known scatter, as part of the finest; the smooth ones only where all runs have them. NaN where a run has no such number.
run_folder::Band band_of(const Numbers& numbers, const Numbers& smooth, Real known_scatter, Real noise)
{
  if (!is_whole(numbers)) return {.value = numbers.of_run().number, .converged = nan, .half_width = nan, .noise = noise};
  const Numbers& compared = is_whole(smooth) ? smooth : numbers;
  const Real known = is_shared(numbers) ? 0 : known_scatter * std::abs(numbers.finest().number);
  return band_of(numbers, compared, extrapolate(compared.by_size, known), noise);
}

/// The travel over which differences of runs are taken, to either side: V of a push goes up in steps, about where the chord of a pipe comes to the next nodes, H and w
/// of a drag waver as cells go by.
struct Smoothing {
  Real push, drag;  ///< m
};

/// A quarter of the largest cell in a push, which its steps are less apart than, and half of it in a drag.
Smoothing smoothing_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants)
{
  Real largest = 1;
  for (const VariantRecord& variant : variants) largest = std::max(largest, variant.size);
  const Real cell = largest * base::near_cell_size(run.settings);
  return {cell / 4, cell / 2};
}

/// The numbers of a stage along its travel, averaged over `half` to either side and less near its ends; as they are where the travel goes back.
std::vector<Real> smoothed(const std::vector<Real>& travel, const std::vector<Real>& values, Real half)
{
  Real farthest = 0;
  for (const Real s : travel) {
    farthest = std::max(farthest, s);
    if (!(s >= farthest - half)) return values;
  }
  const record::TravelCurve curve(travel, values);
  if (curve.travel().size() < 3) return values;
  half = std::min(half, part_of_travel * (curve.end() - curve.begin()));
  std::vector<Real> smooth = values;
  for (std::size_t k = 0; k < travel.size(); ++k) {
    const Real room = std::min(travel[k] - curve.begin(), curve.end() - travel[k]);
    if (const Real value = curve.at(travel[k], std::min(half, room)); std::isfinite(value)) smooth[k] = value;
  }
  return smooth;
}

/// The run with V of its pushes, and H, V and w of its drags, freed from what cells make on the way; its quantities are those of that, without what is seen in frames.
record::RunRecord smoothed(record::RunRecord run, const Smoothing& smoothing)
{
  run.folder.clear();
  run_folder::History& history = run.history;
  const auto values_of = [&](const char* label) -> std::vector<Real>& {
    const auto column = std::ranges::find(history.columns, label, &run_folder::Column::label);
    return history.values[static_cast<std::size_t>(column - history.columns.begin())];
  };
  const Index main = settings::main_rigid(run.settings);
  for (Index first = 0, last = 0; first < history.rows(); first = last) {
    while (last < history.rows() && history.stage[last] == history.stage[first]) ++last;
    const auto stage = std::ranges::find(run.settings.stage, history.stage[first], &settings::StageSettings::name);
    if (stage == run.settings.stage.end()) continue;
    const bool push = stage->kind == settings::StageKind::push, drag = stage->kind == settings::StageKind::drag;
    const bool of_main = stage->rigid.empty() || (main != none && stage->rigid == run.settings.rigid[main].first);
    const char* along = push ? "w" : "u";
    if ((!push && !drag) || !of_main || !history.has_label(along)) continue;
    std::vector<Real> travel;
    for (Index k = first; k < last; ++k) travel.push_back(std::abs(values_of(along)[k] - values_of(along)[first]));
    for (const char* label : {"H", "V", "w"}) {
      if (!history.has_label(label) || (push && label == std::string("w"))) continue;
      std::vector<Real>& values = values_of(label);
      const std::vector<Real> rows(values.begin() + first, values.begin() + last);
      std::ranges::copy(smoothed(travel, rows, push ? smoothing.push : smoothing.drag), values.begin() + first);
    }
  }
  run.quantities = structures::quantities_of(run, {});
  return run;
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

/// Root of the mean square of the scatter around point k; NaN has no part in it.
Real shared_scatter(const std::vector<Estimate>& along, std::size_t k)
{
  Real squares = 0;
  int found = 0;
  for (std::size_t other = k - std::min<std::size_t>(k, shared_points); other < along.size() && other <= k + shared_points; ++other) {
    if (std::isnan(along[other].scatter)) continue;
    squares += along[other].scatter * along[other].scatter;
    ++found;
  }
  return found == 0 ? nan : std::sqrt(squares / found);
}

/// What the runs have at travel s of a curve, averaged over `half` to either side.
Numbers numbers_at(const BandedCurve& curve, const std::vector<VariantRecord>& variants, const std::vector<const BandedCurve*>& of_variants,
                   Real s, Real half, Real step)
{
  std::vector<Real> numbers;
  // A run ends at the limit of its stage but for a step of its own.
  for (const BandedCurve* variant : of_variants) {
    const record::TravelCurve& values = variant->values;
    numbers.push_back(values.at(s > values.end() && s < values.end() + 0.1 * step ? values.end() : s, half));
  }
  return numbers_of(curve.values.at(s, half), variants, numbers);
}

/// The band of a curve of the run, which each variant has at the same place; it ends where one of them does.
run_folder::CurveBand band_of(const BandedCurve& curve, const std::vector<VariantRecord>& variants,
                              const std::vector<const BandedCurve*>& of_variants, Real averaging, const Smoothing& smoothing,
                              Real known_scatter)
{
  run_folder::CurveBand band{curve.chart, {}, {}, {}};
  const Real begin = curve.values.begin(), end = curve.values.end(), step = (end - begin) / curve_points;
  const Real half = std::max(averaging, step), wide = std::max(half, curve.chart == "V_w" ? smoothing.push : smoothing.drag);
  std::vector<Numbers> along, smooth;
  std::vector<Estimate> estimates;
  for (int k = 0; k <= curve_points; ++k) {
    const Real s = k == curve_points ? end : begin + k * step;
    along.push_back(numbers_at(curve, variants, of_variants, s, half, step));
    smooth.push_back(numbers_at(curve, variants, of_variants, s, std::max(half, std::min({wide, s - begin, end - s})), step));
    estimates.push_back(extrapolate(smooth.back().by_size, 0));
    band.x.push_back(curve.begin + curve.direction * s);
  }
  for (std::size_t k = 0; k < along.size(); ++k) {
    const Real known = std::max(known_scatter * std::abs(along[k].finest().number), shared_scatter(estimates, k));
    // The rows' noise is in the scatter from mesh to mesh.
    const run_folder::Band at = band_of(along[k], smooth[k], extrapolate(smooth[k].by_size, known), 0);
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

void add_curve_bands(run_folder::Uncertainty& found, const record::RunRecord& run, const std::vector<VariantRecord>& variants)
{
  const base::Structure& structure = structures::structure_of(run.settings);
  const Smoothing smoothing = smoothing_of(run, variants);
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
      found.curves.push_back(
          band_of(of_run[k], variants, same, averaging_half(base::body_scale(run)), smoothing,
                  scatter_of_finest(run, variants, of_run[k].chart == "V_w" ? Scatters::as_in_pushes : Scatters::as_in_drags)));
    else
      found.without.emplace_back(name_of(of_run, k), fmt::format("{} has no such curve", variants[same.size()].run.name));
  }
}

/// Why a number has no band.
std::string reason_without(const std::vector<VariantRecord>& variants, const std::string& name, Real noise)
{
  for (const VariantRecord& variant : variants)
    if (!std::isfinite(value_in(variant.run.quantities, name))) return fmt::format("{} has no such number", variant.run.name);
  return std::isnan(noise) ? "noise: no value without every fifth row of the history" : "too few runs of different cells to fit a line";
}

}  // namespace

std::map<std::string, Real> noise_of(const record::RunRecord& run, const NumbersOfRun& numbers_of_run)
{
  std::map<std::string, Real> noise;
  if (!base::body_scale(run).noisy) return noise;
  std::vector<std::map<std::string, RunNumber>> without;
  for (int set = 0; set < sets_of_rows; ++set) {
    record::RunRecord part = run;
    part.history = thinned(run.history, set);
    part.folder.clear();  // what is seen in frames has no noise of rows
    part.quantities = structures::quantities_of(part, {});
    without.push_back(numbers_of_run(part));
  }
  for (const auto& [name, number] : numbers_of_run(run)) {
    Real sum = 0, squares = 0;
    int found_in = 0;
    for (const auto& numbers : without) {
      const auto found = numbers.find(name);
      if (found == numbers.end()) continue;
      ++found_in;
      sum += found->second.value;
      squares += found->second.value * found->second.value;
    }
    if (found_in == 0) continue;  // not of the rows
    const Real spread = std::max(Real(0), squares - sum * sum / sets_of_rows);
    noise[name] = found_in < sets_of_rows ? nan : 2 * std::sqrt(spread * (sets_of_rows - 1) / sets_of_rows);
  }
  return noise;
}

std::map<std::string, run_folder::Band> bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants,
                                                 const NumbersOfRun& numbers_of_run)
{
  const Smoothing smoothing = smoothing_of(run, variants);
  using Numbered = std::map<std::string, RunNumber>;
  std::vector<Numbered> as_they_are, smooth;
  for (const VariantRecord& variant : variants) {
    as_they_are.push_back(numbers_of_run(variant.run));
    smooth.push_back(numbers_of_run(smoothed(variant.run, smoothing)));
  }
  const auto value = [](const Numbered& numbers, const std::string& name) {
    const auto found = numbers.find(name);
    return found == numbers.end() ? nan : found->second.value;
  };
  const auto all_of = [&](const std::string& name, const Numbered& of_run, const std::vector<Numbered>& of_variants) {
    std::vector<Real> numbers;
    for (const Numbered& of_variant : of_variants) numbers.push_back(value(of_variant, name));
    return numbers_of(value(of_run, name), variants, numbers);
  };
  const Numbered of_run = numbers_of_run(run), smooth_of_run = numbers_of_run(smoothed(run, smoothing));
  const VariantRecord* finest = nullptr;
  for (const VariantRecord& variant : variants)
    if (variant.size < (finest == nullptr ? 1 : finest->size)) finest = &variant;
  const std::map<std::string, Real> noise = noise_of(finest == nullptr ? run : finest->run, numbers_of_run);
  std::map<std::string, run_folder::Band> bands;
  for (const auto& [name, number] : of_run) {
    const auto found = noise.find(name);
    const Real of_rows = found == noise.end() ? 0 : found->second;
    bands[name] = band_of(all_of(name, of_run, as_they_are), all_of(name, smooth_of_run, smooth),
                          scatter_of_finest(run, variants, number.scatters), of_rows);
  }
  return bands;
}

run_folder::Uncertainty bands_of(const record::RunRecord& run, const std::vector<VariantRecord>& variants)
{
  const driven::Stages stages = driven::stages_of(run.settings);
  const auto scatters = [&](const run_folder::Quantity& q) {
    const auto stage = std::ranges::find(stages, q.of, &driven::Stage::name);
    const bool drag = stage != stages.end() && stage->kind == settings::StageKind::drag;
    const bool held = drag && stage->holds_V && (q.name.ends_with("V_in_drag") || q.name.ends_with("V_end_of_drag"));
    return held ? Scatters::not_at_all : drag || q.unit == "m" ? Scatters::as_in_drags : Scatters::as_in_pushes;
  };
  const auto numbers_of_run = [&](const record::RunRecord& one) {
    std::map<std::string, RunNumber> numbers;
    for (const run_folder::Quantity& q : one.quantities)
      if (q.kind == run_folder::QuantityKind::answer && std::isfinite(q.value)) numbers[q.name] = {q.value, scatters(q)};
    return numbers;
  };
  const std::map<std::string, run_folder::Band> bands = bands_of(run, variants, numbers_of_run);
  run_folder::Uncertainty found;
  for (const run_folder::Quantity& q : run.quantities) {
    const auto band = bands.find(q.name);
    if (band == bands.end()) continue;
    if (std::isfinite(band->second.half_width))
      found.quantities.push_back({q.name, q.unit, band->second});
    else
      found.without.emplace_back(q.name, reason_without(variants, q.name, band->second.noise));
  }
  add_curve_bands(found, run, variants);
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
  const record::RunRecord& reference = without == variants.end() ? run : without->run;
  for (const run_folder::Quantity& q : run.quantities) {
    const Real number = value_in(reference.quantities, q.name);
    if (q.kind != run_folder::QuantityKind::answer || !std::isfinite(q.value) || !std::isfinite(number)) continue;
    grains.numbers.push_back({q.name, q.unit, number, {}});
    for (const VariantRecord* variant : with) grains.numbers.back().with.push_back(value_in(variant->run.quantities, q.name));
  }
  return grains;
}

}  // namespace berm::uncertainty
