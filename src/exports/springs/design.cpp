// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/design_test.cpp
#include "springs/design.hpp"
#include "io/log.hpp"
#include "os/text_of_list.hpp"
#include "springs/written_springs.hpp"

#include "io/revision.hpp"
#include "os/error.hpp"
#include "structures/base/invalid_answer.hpp"
#include "structures/structures.hpp"
#include "study/estimates.hpp"
#include "study/sample.hpp"
#include "study/study_rows.hpp"
#include "uncertainty/find_bands.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace berm::springs {
namespace {

namespace fs = std::filesystem;

/// Which spring a number is of, and where it is from.
struct Place {
  std::string spring, travel, source;
};

/// Those along the axis; `formula` gives their places.
template <class A, class Formula, class Visit>
void for_each_axial_number(A& axial, const Formula& formula, const Visit& visit)
{
  const bool undrained = !std::isnan(axial.undrained);
  const std::string& source = undrained ? axial.undrained_source : axial.drained_source;
  visit(formula("axial", axial.wedging_source), "wedging", Kind::ratio, "normal force around the contact divided by V", axial.wedging);
  visit(formula("axial", axial.drained_source), "drained", Kind::force, "drained resistance under the V of the state", axial.drained);
  visit(formula("axial", axial.undrained_source), axial.strength == "undisturbed clay" ? "undrained_undisturbed" : "undrained", Kind::force,
        axial.strength.empty() ? "undrained resistance" : "undrained resistance, " + axial.strength, axial.undrained);
  visit(formula("axial", axial.settled_source), "consolidated", Kind::force, "drained resistance once no excess pore pressure is left",
        axial.settled);
  visit(formula("axial", source), "residual", Kind::force,
        axial.sensitivity > 1 ? "residual resistance: the undrained one, remoulded, divided by the sensitivity"
                              : "residual resistance: that of breakout",
        axial.residual);
  for (auto& rest : axial.set_up) {
    const Place computed{"axial", rest.stage, "computed effective normal force"};
    visit(computed, rest.stage + ".U", Kind::ratio, "degree of consolidation at the end of the dwell", rest.degree);
    visit(computed, rest.stage + ".before", Kind::force, "friction of the interface before the dwell", rest.before);
    visit(computed, rest.stage + ".after", Kind::force, "friction of the interface after the dwell: set-up", rest.after);
  }
  const Place displacement = formula("axial", axial_displacement_source());
  for (const auto& [name, of, words] : {std::tuple("u_breakout", &axial.u_breakout, "at axial breakout"),
                                        {"u_residual", &axial.u_residual, "from which the axial resistance is residual"}})
    for (const auto& [end, number, estimate] : {std::tuple("_LE", &of->low, "low"), {"", &of->best, "best"}, {"_HE", &of->high, "high"}})
      visit(displacement, std::string(name) + end, Kind::displacement, std::string(estimate) + " estimate of the displacement " + words,
            *number);
}

/// The one list of the numbers of springs: visit(place, name, kind, meaning, number).
template <class S, class Visit>
void for_each_number(S& springs, const Visit& visit)
{
  for (auto& l : springs.lateral) {
    const Place drag{"lateral " + l.stage, l.stage, "computed"};
    visit(drag, "V", Kind::force, "mean vertical reaction in the drag", l.V);
    visit(drag, "peak", Kind::force, std::string(peak_words(l)) + (l.breaks ? ", its first peak" : ": it has no peak"), l.peak);
    for (std::size_t k = 0; k < mobilised_parts.size(); ++k)
      visit(drag, fmt::format("u_{:.0f}", 100 * mobilised_parts[k]), Kind::displacement,
            "displacement at which H first reaches this percentage of the peak", l.mobilised[k]);
    visit(drag, "u_peak", Kind::displacement, "displacement at the peak", l.u_peak);
    visit(drag, "largest", Kind::force, "largest H, where it comes after the first peak and exceeds it", l.largest);
    visit(drag, "u_largest", Kind::displacement, "displacement at that largest H", l.u_largest);
    visit(drag, "residual", Kind::force, "residual H, its plateau: at the end of the drag, or before H increases against a berm",
          l.residual);
    visit(drag, "berm_resistance", Kind::force, "H against a berm at the end of the drag, which is not a residual", l.berm);
    visit(drag, "end", Kind::force,
          std::isnan(l.berm) ? "mean H over the end of the drag, steady or not" : "mean H over the end of the drag, against a berm", l.end);
    visit(drag, "u_residual", Kind::displacement, "displacement from which H is within 5 % of the residual", l.u_residual);
    visit(drag, "travel", Kind::displacement, "travel of the drag: no data beyond it", l.travel);
  }
  for (auto& point : springs.vertical.curve)
    visit(Place{"vertical", "push", "computed"}, fmt::format("V_at_w_{:.3g}D", point.x / springs.diameter), Kind::force,
          "V in the push at an embedment", point.F);
  for (auto& u : springs.vertical.unloading)
    visit(Place{"vertical", u.stage, "computed"}, u.stage + ".stiffness", Kind::stiffness,
          u.V_end < u.V_begin ? "stiffness of unloading, from the line fitted to w against V"
                              : "stiffness of loading in the bed, from the line fitted to w against V",
          u.stiffness);
  const auto formula = [](const std::string& spring, const std::string& source) {
    return Place{spring, "", source.empty() ? "formula" : source};
  };
  visit(formula("vertical", springs.vertical.rebound_source), "rebound", Kind::stiffness,
        "stiffness of unloading and reloading by a formula: the spring has it where no stage gives one", springs.vertical.rebound);
  const Place state{"vertical", "", springs.state_origin.empty() ? "computed" : "computed, " + springs.state_origin};
  visit(state, "embedment", Kind::displacement, "embedment in the state", springs.embedment);
  visit(state, "V", Kind::force, "vertical force in the state", springs.V);
  visit(state, "preload", Kind::force, "largest V before this state (preload): penetration resumes above it", springs.vertical.preload);
  for_each_axial_number(springs.axial, formula, visit);
}

/// A number that may be written.
bool is_usable(Kind kind, Real number)
{
  return kind == Kind::stiffness ? is_stiffness(number) : !std::isnan(number);
}

using Key = std::pair<std::string, std::string>;

std::map<Key, std::vector<Real>> numbers_of(const std::vector<Springs>& draws)
{
  std::map<Key, std::vector<Real>> all;
  for (const Springs& springs : draws)
    for_each_number(springs, [&](const Place& place, const std::string& name, Kind kind, const std::string&, Real number) {
      if (is_usable(kind, number)) all[{place.spring, name}].push_back(number);
    });
  return all;
}

std::vector<Estimate> estimates_of(const Springs& best, const std::vector<Springs>& draws)
{
  const std::map<Key, std::vector<Real>> numbers = numbers_of(draws);
  std::vector<Estimate> estimates;
  for_each_number(best, [&](const Place& place, const std::string& name, Kind kind, const std::string& meaning, Real number) {
    Estimate e{.spring = place.spring,
               .name = name,
               .kind = kind,
               .meaning = meaning,
               .travel = place.travel,
               .source = place.source,
               .best = is_usable(kind, number) ? number : nan,
               .fit = {}};
    if (const auto found = numbers.find({place.spring, name}); found != numbers.end()) {
      const std::vector<Real>& values = found->second;
      e.size = values.size();
      e.low = study::sample_quantile(values, study::low_share);
      e.middle = study::sample_quantile(values, 0.5);
      e.high = study::sample_quantile(values, study::high_share);
      e.fit = fit_lognormal(values);
    }
    if (!std::isnan(e.best) || e.size > 0) estimates.push_back(e);
  });
  return estimates;
}

/// Whether low and high have a number of their own: displacements are those of the best run, and V, too, with which the friction of low and high would be a quotient of
/// quantiles.
bool is_carried(Kind kind, const std::string& name)
{
  return kind != Kind::displacement && kind != Kind::ratio && name != "V";
}

/// `like`, with its forces and stiffnesses from the estimates; displacements are those of the best run, else the middle ones.
Springs at(Real Estimate::*which, Springs like, const std::vector<Estimate>& estimates)
{
  std::map<Key, const Estimate*> by_key;
  for (const Estimate& e : estimates) by_key[{e.spring, e.name}] = &e;
  for_each_number(like, [&](const Place& place, const std::string& name, Kind kind, const std::string&, Real& number) {
    const auto found = by_key.find({place.spring, name});
    if (found == by_key.end()) return;
    if (is_carried(kind, name))
      number = found->second->*which;
    else
      number = std::isnan(found->second->best) ? found->second->middle : found->second->best;
  });
  for (Lateral& l : like.lateral) l.curve.clear();
  std::erase_if(like.vertical.curve, [](const Point& point) { return std::isnan(point.F); });
  return like;
}

/// Why the numbers of a run are not to be used.
std::vector<std::string> invalid_lines(const record::RunRecord& run)
{
  return run.summary ? base::invalid_lines(run.name, run.summary->invalid) : std::vector<std::string>{};
}

std::vector<std::string> provenance_of(const record::RunRecord& run)
{
  std::vector<std::string> lines = {fmt::format("written by berm {}", io::version_words())};
  if (!run.settings.title.empty()) lines.push_back(run.settings.title);
  if (run.origin)
    for (const auto& [file, hash] : run.origin->input)
      if (file == "resolved.toml") lines.push_back("SHA-256 of the case when the run began, " + file + ": " + hash);
  for (const std::string& file : run.changed) lines.push_back(record::words_of_change(file));
  if (run.summary)
    for (const char* entry : {"version", "build", "date"})
      if (const auto found = run.summary->text.find(entry); found != run.summary->text.end())
        lines.push_back(fmt::format("{} of the run: {}", entry, found->second));
  for (const std::string& line : invalid_lines(run)) lines.push_back(line);
  return lines;
}

/// Takes the springs of a run with bands to zero cell size: forces and stiffnesses of `best` are the extrapolated ones, those of `low` and `high` the ends of their
/// bands, at the displacements of the run. What has no band stays as computed, and has no low and high.
void take_bands(Design& design, const record::RunRecord& run, const Selection& selection)
{
  const std::vector<uncertainty::VariantRecord> variants = uncertainty::variants_of(run);
  // A peak at breakout is another number than the largest H.
  const auto name_of = [](const std::string& spring, const std::string& name, const std::string& meaning) {
    return fmt::format("{} {} ({})", spring, name, meaning);
  };
  const std::map<std::string, run_folder::Band> bands = uncertainty::bands_of(run, variants, [&](const record::RunRecord& one) {
    std::map<std::string, uncertainty::RunNumber> numbers;
    const Springs springs = springs_of(one, selection);
    for_each_number(springs, [&](const Place& place, const std::string& name, Kind kind, const std::string& meaning, Real number) {
      if (is_carried(kind, name) && is_usable(kind, number))
        numbers[name_of(place.spring, name, meaning)] = {number, place.spring.starts_with("lateral") ? uncertainty::Scatters::as_in_drags
                                                                                                     : uncertainty::Scatters::as_in_pushes};
    });
    return numbers;
  });
  std::vector<std::string> without;
  for (Estimate& e : design.estimates) {
    const auto found = bands.find(name_of(e.spring, e.name, e.meaning));
    if (found == bands.end()) continue;
    const run_folder::Band& band = found->second;
    if (!std::isfinite(band.half_width)) {
      without.push_back(e.spring + " " + e.name);
      continue;
    }
    e.best = band.converged, e.low = band.converged - band.half_width, e.high = band.converged + band.half_width;
    e.size = variants.size() + 1;
  }
  const auto is_point = [](const Estimate& e) { return e.spring == "vertical" && e.name.starts_with("V_at_w_"); };
  const auto has_band = [](const Estimate& e) { return !std::isnan(e.low); };
  if (std::ranges::none_of(design.estimates, has_band)) return;
  // One curve is not of two kinds of points.
  if (std::ranges::any_of(design.estimates, [&](const Estimate& e) { return is_point(e) && has_band(e); }))
    for (Estimate& e : design.estimates)
      if (is_point(e) && !has_band(e)) e.best = nan;
  const Springs computed = design.best;
  for (auto [set, which, words] : {std::tuple(&design.best, &Estimate::best, "extrapolated to zero cell size"),
                                   std::tuple(&design.low.emplace(), &Estimate::low, "lower end of the 95 % band of discretisation"),
                                   std::tuple(&design.high.emplace(), &Estimate::high, "upper end of the 95 % band of discretisation")}) {
    *set = at(which, computed, design.estimates);
    set->run = fmt::format("{} ({})", computed.run, words);
  }
  for (std::size_t k = 0; k < computed.lateral.size(); ++k) design.best.lateral[k].curve = computed.lateral[k].curve;
  design.provenance.push_back(fmt::format(
      "best: forces extrapolated to zero cell size from {} runs; low and high: 95 % band of discretisation (berm run --uncertainty)",
      variants.size() + 1));
  if (!without.empty()) design.provenance.push_back("without a band, as computed: " + text_of_list(without, ", "));
}

Design design_of_run(const fs::path& folder, const Selection& selection)
{
  const record::RunRecord run = structures::read_run(folder);
  Design design{
      .name = run.name, .provenance = {}, .best = springs_of(run, selection), .low = {}, .high = {}, .estimates = {}, .draws = {}};
  design.provenance = head_of(run);
  design.estimates = estimates_of(design.best, {});
  if (run.summary && run.summary->uncertainty && run.summary->uncertainty->missing.empty()) try {
      take_bands(design, run, selection);
    } catch (const RunError& error) {
      io::warn("{}: the springs are as computed, without bands: {}", run.name, error.what());
    }
  return design;
}

/// Rows of one combination.
Design design_of_rows(const std::vector<const study::SavedRow*>& rows, const Selection& selection)
{
  std::optional<Springs> best;
  std::vector<Springs> draws;
  std::vector<std::string> provenance, invalid;
  std::size_t failed = 0;
  for (const study::SavedRow* row : rows) {
    const bool draw = row->kind == study::RowKind::draw;
    if (!draw && row->kind != study::RowKind::best) continue;
    if (!row->finished) {
      failed += draw;
      continue;
    }
    try {
      const record::RunRecord run = structures::read_run(row->run);
      Springs springs = springs_of(run, selection);
      for (const std::string& line : invalid_lines(run)) invalid.push_back(line);
      if (provenance.empty() || !draw) provenance = provenance_of(run);
      if (draw)
        draws.push_back(std::move(springs));
      else
        best = std::move(springs);
    } catch (const InputError&) {
      throw;
    } catch (const std::runtime_error& error) {
      io::warn("{}", error.what());
      failed += draw;
    }
  }
  const std::string name = text_of_list(rows[0]->names, ".");
  if (draws.empty()) throw RunError(fmt::format("no run of the sample of {} is finished; the same berm study again continues it", name));
  Design design = design_of_sample(name, best, std::move(draws));
  design.failed = failed;
  design.provenance = std::move(provenance);
  for (const std::string& line : invalid) {
    if (std::find(design.provenance.begin(), design.provenance.end(), line) == design.provenance.end()) design.provenance.push_back(line);
    io::warn("{}", line);
  }
  if (design.low) design.provenance.push_back(fmt::format("low and high: 5 and 95 % of a sample of {} runs", design.draws.size()));
  if (failed > 0) {
    design.provenance.push_back(fmt::format("{} more runs have no result and do not count", failed));
    io::warn("{}: {} runs of the sample have no result, and are left out", name, failed);
  }
  return design;
}

}  // namespace

std::vector<std::string> head_of(const record::RunRecord& run)
{
  std::vector<std::string> lines = provenance_of(run);
  for (const std::string& fault : run.faults) io::warn("{}", fault);
  for (const std::string& line : invalid_lines(run)) io::warn("{}", line);
  if (run.end != record::RunEnd::finished) {
    io::warn("{}: the run has not finished; unknown values are left out", run.folder.string());
    lines.emplace_back("the run has not finished");
  }
  return lines;
}

const char* unit_of(Kind kind)
{
  switch (kind) {
  case Kind::force:
    return "N/m";
  case Kind::displacement:
    return "m";
  case Kind::stiffness:
    return "N/m^2";
  default:
    return "1";
  }
}

bool is_stiffness(Real slope)
{
  return std::isfinite(slope) && slope > 0;
}

std::vector<std::string> refused_stiffnesses(const Springs& springs)
{
  std::vector<std::string> lines;
  for (const Unloading& u : springs.vertical.unloading) {
    if (is_stiffness(u.stiffness)) continue;
    const bool fell = u.V_end < u.V_begin;
    std::string why = "w does not follow V in it";
    if (u.stiffness < 0)
      why = fmt::format("V {} from {:.6g} to {:.6g} N/m while the pipe {}, so that the slope is negative and no stiffness",
                        fell ? "fell" : "rose", u.V_begin, u.V_end, fell ? "sank" : "rose");
    lines.push_back(fmt::format("stiffness dV/dw in stage {} is not written: {}", u.stage, why));
  }
  return lines;
}

Design design_of_sample(const std::string& name, const std::optional<Springs>& best, std::vector<Springs> draws)
{
  Design design;
  design.name = name;
  design.best = best ? *best : draws.front();
  design.estimates = estimates_of(design.best, draws);
  if (!best) {
    for (Estimate& e : design.estimates) e.best = nan;
    design.best = at(&Estimate::middle, draws.front(), design.estimates);
    design.best.run = fmt::format("middle of {} runs of {}", draws.size(), name);
  }
  constexpr std::size_t least = 10;  // for 5 and 95 %
  if (draws.size() >= least) {
    design.low = at(&Estimate::low, design.best, design.estimates);
    design.high = at(&Estimate::high, design.best, design.estimates);
    for (const auto& [set, percent] : {std::pair(&*design.low, 5), std::pair(&*design.high, 95)})
      set->run = fmt::format("{} (forces at {} % of {} runs)", design.best.run.empty() ? name : design.best.run, percent, draws.size());
  } else {
    io::warn("{}: {} runs of a sample are too few for 5 and 95 %: there is no low and no high; take {} at least", name, draws.size(),
             least);
  }
  for (const Estimate& e : design.estimates)
    if (e.size > 0 && e.size < draws.size())
      io::warn("{}: {}, {}: {} of {} runs have it, so it may not be consistent with the others", name, e.spring, e.name, e.size,
               draws.size());
  design.draws = std::move(draws);
  return design;
}

std::vector<Design> designs_in(const fs::path& folder, const Selection& selection)
{
  if (record::is_run_folder(folder)) return {design_of_run(folder, selection)};
  const auto rows = study::read_rows(folder);
  if (!rows)
    throw RunError(fmt::format("{} is neither a run folder nor the output of berm study (it has no resolved.toml and no study.json)",
                               folder.string()));
  if (rows->empty()) throw RunError(fmt::format("{}: the study has no rows", folder.string()));
  std::vector<std::vector<const study::SavedRow*>> groups;
  for (const study::SavedRow& row : *rows) {
    if (row.kind == study::RowKind::row)
      throw RunError(fmt::format("{}: the study has no sample, for low, best and high; export its runs one by one: {}", folder.string(),
                                 row.run.string()));
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group[0]->names == row.names; });
    if (same == groups.end())
      groups.push_back({&row});
    else
      same->push_back(&row);
  }
  std::vector<Design> designs;
  for (const auto& group : groups) designs.push_back(design_of_rows(group, selection));
  return designs;
}

}  // namespace berm::springs
