// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/two_methods_test.cpp
#include "report/results/results_section.hpp"

#include "input/write_case.hpp"
#include "material/clay.hpp"
#include "os/text_of_list.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/base/errors_of_methods.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace berm::report {
namespace {

using Runs = std::vector<record::RunRecord>;
using Words = std::vector<std::string>;
using run_folder::Quantity;

constexpr Real large_difference = 0.1;  // of the finite element value
constexpr std::size_t max_named = 5;    // results in a sentence

/// A run by each method of one case, and what is said of their quality.
struct Pair {
  const record::RunRecord *mpm, *fem;
  const Judgement *of_mpm, *of_fem;

  bool has(const record::RunRecord& run) const { return mpm == &run || fem == &run; }
};

/// The case without what belongs to a method alone: the method and its parameters, sizes of cells, particles per cell, and what is written.
settings::Case without_method(settings::Case c)
{
  c.title.clear();
  c.method = settings::Method::mpm;
  c.mpm = {}, c.fem = {}, c.output = {}, c.report = {};
  c.watch.clear();
  if (auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) {
    bed->near_size = bed->near_left = bed->near_right = bed->near_depth = bed->near_height = bed->growth = bed->layer = 0;
    bed->pattern = {};
    bed->far_size.reset(), bed->near_back.reset(), bed->near_front.reset();
  }
  for (auto& [name, body] : c.body) body.particles_per_cell = 0, body.region_particles_per_cell.clear();
  return c;
}

Real nodes_of(const record::RunRecord& run)
{
  const Real nodes = run.timing("nodes");
  return std::isnan(nodes) ? 0 : nodes;
}

/// The finest runs of each case that there are by both methods. Of the material point method the finest come first on a page.
std::vector<Pair> pairs_of(const Runs& runs, const std::vector<Judgement>& judgements)
{
  std::map<std::string, Pair> by_case;
  Words order;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].settings.small_strain()) continue;
    const std::string same = input::resolved_toml(without_method(runs[k].settings));
    const auto [found, is_new] = by_case.try_emplace(same);
    if (is_new) order.push_back(same);
    Pair& pair = found->second;
    if (runs[k].settings.method == settings::Method::mpm) {
      if (pair.mpm == nullptr) pair.mpm = &runs[k], pair.of_mpm = &judgements[k];
    } else if (pair.fem == nullptr || nodes_of(runs[k]) > nodes_of(*pair.fem)) {
      pair.fem = &runs[k], pair.of_fem = &judgements[k];
    }
  }
  std::vector<Pair> pairs;
  for (const std::string& same : order)
    if (const Pair& pair = by_case.at(same); pair.mpm != nullptr && pair.fem != nullptr) pairs.push_back(pair);
  return pairs;
}

/// A result of a run: extrapolated to zero cell size where the run has bands, else as it is.
struct Value {
  Real value;
  Real half_width = nan;  ///< of its band; NaN without one

  Value(const record::RunRecord& run, const Quantity& q) : value(q.value)
  {
    const run_folder::Band* band = run.summary && run.summary->uncertainty ? run.summary->uncertainty->find(q.name) : nullptr;
    if (band != nullptr) value = band->converged, half_width = band->half_width;
  }
  bool has_band() const { return !std::isnan(half_width); }
  std::string words(Real unit) const
  {
    return has_band() ? text::with_half_width(value / unit, half_width / unit) : text::table_number(value / unit);
  }
};

/// A key result of both.
struct Both {
  const Quantity* name;  ///< that of the material point run
  Value mpm, fem;

  /// Over the finite element value; NaN where that is 0.
  Real difference() const { return fem.value == 0 ? nan : (mpm.value - fem.value) / std::abs(fem.value); }
  bool has_band() const { return mpm.has_band() || fem.has_band(); }
  /// Whether the bands of both meet, or the value of one is within the band of the other.
  bool agree() const
  {
    const auto half = [](const Value& value) { return value.has_band() ? value.half_width : 0; };
    return std::abs(mpm.value - fem.value) <= half(mpm) + half(fem);
  }
};

std::vector<Both> key_results_of(const Pair& pair)
{
  const auto is_key = [](const Quantity& q) {
    const bool is_ratio = q.name.find("_over_") != std::string::npos;  // H over V, whose both are in the table
    return q.kind == run_folder::QuantityKind::answer && !is_ratio && std::isfinite(q.value);
  };
  const bool both_ended = pair.mpm->end == record::RunEnd::finished && pair.fem->end == record::RunEnd::finished;
  // A run that stopped has its largest values and those of its end elsewhere.
  const auto is_of_same_place = [&](const std::string& name) {
    return both_ended || name.find("_at_w_") != std::string::npos || (name.find("_at_u_") != std::string::npos && !name.starts_with("u_"));
  };
  std::vector<Both> both;
  for (const Quantity& q : pair.mpm->quantities)
    if (const Quantity* other = pair.fem->quantity(q.name);
        is_key(q) && is_of_same_place(q.name) && other != nullptr && is_key(*other) && other->unit == q.unit)
      both.push_back({&q, {*pair.mpm, q}, {*pair.fem, *other}});
  return both;
}

/// The unit in which results up to `largest` are shown: SI, but for forces, lengths, stresses and angles.
std::pair<Real, std::string> shown_unit(const std::string& unit, Real largest)
{
  constexpr Real largest_in_mm = 0.5;
  if (unit == "N/m" || unit == "N") {
    const text::NamedUnit force = text::unit_of_forces(largest, unit == "N" ? 3 : 2);
    return {force.size, force.name};
  }
  if (unit == "m" && largest < largest_in_mm) return {1e-3, "mm"};
  if (unit == "Pa") return {1e3, "kPa"};
  if (unit == "rad") return {degree, "°"};
  return {1, unit == "1" ? "" : unit};
}

std::string name_html(const Quantity& q)
{
  return fmt::format("<code>{}</code>", text::html_text(q.name));
}

/// With one decimal and its sign, which zero has not.
std::string signed_percent(Real part)
{
  const Real percent = std::round(1000 * part) / 10;
  return percent == 0 ? "0.0" : fmt::format("{:+.1f}", percent);
}

std::string table_of(const Pair& pair, const std::vector<Both>& results, const std::string& id)
{
  std::map<std::string, Real> largest;
  for (const Both& result : results)
    largest[result.name->unit] = std::max({largest[result.name->unit], std::abs(result.mpm.value), std::abs(result.fem.value)});
  const bool bands = std::ranges::any_of(results, &Both::has_band);
  text::HtmlTable table(id, fmt::format("Key results by both methods{}; difference in per cent of the finite element value",
                                        bands ? ", extrapolated to zero cell size where there is a band" : ""));
  std::vector<text::HtmlCell> columns = {{"result"},
                                         {"unit"},
                                         {fmt::format("material point method ({})", text::html_text(pair.mpm->name)), true},
                                         {fmt::format("finite elements ({})", text::html_text(pair.fem->name)), true},
                                         {"difference, %", true}};
  if (bands) columns.push_back({"within the bands"});
  table.columns(std::move(columns));
  for (const Both& result : results) {
    const auto [size, unit] = shown_unit(result.name->unit, largest.at(result.name->unit));
    const Real difference = result.difference();
    std::vector<text::HtmlCell> row = {
        {fmt::format("{} <span class=\"quiet\">{}</span>", name_html(*result.name), text::html_text(result.name->meaning))},
        {text::html_text(unit)},
        {result.mpm.words(size), true},
        {result.fem.words(size), true},
        {std::isnan(difference) ? text::no_number : signed_percent(difference), true}};
    if (bands) row.push_back({!result.has_band() ? "" : result.agree() ? "yes" : "no"});
    const bool differs = result.has_band() ? !result.agree() : std::abs(difference) > large_difference;
    table.row(std::move(row), differs ? "differs" : "");
  }
  return table.html();
}

/// Why the numbers of a run are not to be relied on, HTML, and how much that counts.
struct Faults {
  enum Weight { none, bad_measure, no_answer } weight = none;
  Words words;
};

Faults faults_of(const record::RunRecord& run, const Judgement& judgement)
{
  Faults faults;
  if (run.end != record::RunEnd::finished) faults.words.emplace_back("it has not finished");
  if (run.summary && !run.summary->invalid.empty()) faults.words.emplace_back("its answer is invalid");
  if (!faults.words.empty()) faults.weight = Faults::no_answer;
  for (const auto& [measure, value, standing] : judgement.measures)
    if (standing == text::Standing::bad) {
      faults.words.push_back(text::html_text(fmt::format("bad measure of trust: {}, {}", measure.what, measure.words(run, value))));
      faults.weight = std::max(faults.weight, Faults::bad_measure);
    }
  return faults;
}

/// A soil in which remeshed elements do worse than cells, or are compared with less, with the reason; "" where they do not.
std::string weakness_in(const material::Material& soil, bool dragged)
{
  const std::optional<material::Strength> strength = strength_at_rest(soil);
  if (!strength) return fmt::format("remeshed elements have not been compared with independent results for the law {}", law_name(soil));
  if (strength->friction_angle > 0)
    return "in soil with friction the material point method has been compared with measurements, and remeshed elements with it alone "
           "(examples/probe_test). Halve the cells: in sand with psi &lt; phi V on cells of D/20 is 14 % above D/40 (examples/mesh_study)";
  const auto* clay = soil.get_if<material::Clay>();
  return dragged && clay != nullptr && clay->sensitivity > 1
             ? "in softening clay H of remeshed elements jumps by up to a fifth where soil folds onto soil (docs/decisions/0113)"
             : "";
}

/// Why material points suit a case better than remeshed elements; none where elements do as well.
Words weaknesses_in(const settings::Case& c)
{
  const bool dragged =
      std::ranges::any_of(c.stage, [](const settings::StageSettings& stage) { return stage.kind == settings::StageKind::drag; });
  Words list;
  if (const std::optional<settings::BodySoil> soil = base::touched_soil(c))
    for (const material::Material& one : soil->materials)
      if (const std::string what = weakness_in(one, dragged); !what.empty() && std::ranges::find(list, what) == list.end())
        list.push_back(what);
  const auto by_recorded_forces = [](const settings::StageSettings& stage) {
    return has_load_history(stage) && (stage.force || stage.loads.has_force());
  };
  if (std::ranges::any_of(c.stage, by_recorded_forces))
    list.emplace_back("recorded forces accelerate the body, and remeshed elements leave out the mass of the soil that moves with it");
  return list;
}

/// What of a case remeshed elements have not been compared in with independent results (docs/decisions/0111 to 0114).
Words not_compared(const settings::Case& c)
{
  using enum settings::StageKind;
  Words list;
  const std::optional<settings::BodySoil> soil = base::touched_soil(c);
  const auto softens = [](const material::Material& one) {
    const auto* clay = one.get_if<material::Clay>();
    return clay != nullptr && clay->sensitivity > 1;
  };
  if (soil && std::ranges::any_of(soil->materials, softens)) list.emplace_back("softening clay");
  if (soil && (!soil->layers.empty() || !soil->of_region.empty())) list.emplace_back("layered soil");
  bool forth = false, back = false, lifted = false;
  for (const settings::StageSettings& stage : c.stage) {
    const Real velocity = stage.velocity.value_or(stage.force.value_or(0));
    if (stage.kind == drag) (velocity < 0 ? back : forth) = true;
    if (stage.kind == push && stage.velocity && velocity < 0 && !(stage.until.force && *stage.until.force > 0)) lifted = true;
  }
  if (forth && back) list.emplace_back("drags to and fro");
  if (lifted) list.emplace_back("uplift");
  return list;
}

/// " (here D/10)"; "" where that is not known.
std::string size_here(const record::RunRecord& run)
{
  const Real over_D = base::body_scale(run.settings).width / base::near_cells(run).first;
  return std::isfinite(over_D) && over_D > 0 ? fmt::format(" (here D/{:.3g})", over_D) : "";
}

std::string why_elements(const Pair& pair)
{
  const Words open = not_compared(pair.fem->settings);
  return fmt::format(
      " Their contact acts on the exact surface of the body, without inertia or noise: V of a smooth pipe pushed 0.5 D into clay is {} "
      "above "
      "an independent program on elements of {}{} (examples/two_methods). Material points ({}) have an error of first order in the size "
      "of the cells at contacts and edges: {} on {}{}. They are for soil that breaks up, fast motion and three dimensions.{}",
      errors_words(base::errors_of_remeshed_elements), sizes_words(base::errors_of_remeshed_elements), size_here(*pair.fem),
      text::html_text(pair.mpm->name), errors_words(base::errors_of_cells), sizes_words(base::errors_of_cells), size_here(*pair.mpm),
      open.empty() ? ""
                   : fmt::format(" For {} remeshed elements have not been compared with independent results.", text_of_list(open, ", ")));
}

/// Which of both results to rely on, and why.
struct Verdict {
  enum Of { neither, mpm, fem } reliable;
  std::string html;
};

Verdict verdict_on(const Pair& pair)
{
  const Faults of_mpm = faults_of(*pair.mpm, *pair.of_mpm), of_fem = faults_of(*pair.fem, *pair.of_fem);
  const std::string mpm = text::html_text(pair.mpm->name), fem = text::html_text(pair.fem->name);
  const auto because = [](const std::string& name, const Faults& faults) {
    return faults.words.empty() ? "" : fmt::format(" {}: {}.", name, text_of_list(faults.words, "; "));
  };
  const std::string faults = because(mpm, of_mpm) + because(fem, of_fem),
                    by_mpm = fmt::format("<strong>Rely on the material point method ({}).</strong>", mpm),
                    by_fem = fmt::format("<strong>Rely on the remeshed finite elements ({}).</strong>", fem);
  if (of_mpm.weight < of_fem.weight) return {Verdict::mpm, by_mpm + faults};
  const Words weaknesses = weaknesses_in(pair.fem->settings);
  if (of_fem.weight < of_mpm.weight) return {Verdict::fem, by_fem + faults + (weaknesses.empty() ? why_elements(pair) : "")};
  if (of_fem.weight != Faults::none) return {Verdict::neither, "<strong>Neither run is reliable.</strong>" + faults};
  if (!weaknesses.empty()) return {Verdict::mpm, by_mpm + fmt::format(" The reason: {}.", text_of_list(weaknesses, "; "))};
  return {Verdict::fem, by_fem + why_elements(pair)};
}

/// What the size of the differences says.
std::string words_on_differences(const std::vector<Both>& results)
{
  const auto with_band = std::ranges::count_if(results, &Both::has_band);
  const auto agree = std::ranges::count_if(results, [](const Both& result) { return result.has_band() && result.agree(); });
  const std::string in_bands =
      with_band == 0 ? ""
                     : fmt::format("{} of {} results with a band agree within {}. ", agree, with_band, with_band == 1 ? "it" : "theirs");
  Words large;
  for (const Both& result : results)
    if (std::abs(result.difference()) > large_difference) large.push_back(name_html(*result.name));
  if (large.empty()) return in_bands + "No difference exceeds 10 %.";
  const std::size_t more = large.size() > max_named ? large.size() - max_named : 0;
  large.resize(large.size() - more);
  return in_bands +
         fmt::format(
             "The difference exceeds 10 % for {}{}. The usual causes: cells or elements too coarse at the body; the contact gap of the "
             "material point method, which makes the body larger by a part of a cell; a drive so fast that inertia adds to its resistance; "
             "noise "
             "of its forces; softening, whose shear bands are as wide as a cell or an element. Halve the size of the cells and the speed, "
             "and "
             "compare again.",
             text_of_list(large, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace

std::string two_methods(const Runs& runs, const std::vector<Judgement>& judgements)
{
  std::string html;
  int count = 0;
  for (const Pair& pair : pairs_of(runs, judgements)) {
    const std::vector<Both> results = key_results_of(pair);
    if (results.empty()) continue;
    const std::string id = ++count == 1 ? "two-methods" : fmt::format("two-methods-{}", count);
    const std::string verdict =
        pair.has(runs.front()) ? "" : verdict_on(pair).html + " ";  // of the first pair it stands on top of the page
    html += table_of(pair, results, id) + fmt::format("<p>{}{}</p>\n", verdict, words_on_differences(results));
  }
  return html.empty() ? "" : "<h3>Two methods</h3>\n" + html;
}

std::string reliable_method(const Runs& runs, const std::vector<Judgement>& judgements)
{
  for (const Pair& pair : pairs_of(runs, judgements))
    if (pair.has(runs.front()))
      return fmt::format("<p id=\"reliable-method\">{}{}</p>\n", verdict_on(pair).html,
                         key_results_of(pair).empty() ? "" : " <a href=\"#two-methods\">Results of both and their differences</a>.");
  return "";
}

void lead_with_reliable_method(Runs& runs)
{
  const auto is_mpm = [](const record::RunRecord& run) { return run.settings.method == settings::Method::mpm; };
  if (std::ranges::all_of(runs, is_mpm) || std::ranges::none_of(runs, is_mpm)) return;
  const std::vector<Judgement> judgements = judgements_of(runs);
  for (const Pair& pair : pairs_of(runs, judgements))
    if (pair.has(runs.front()) && verdict_on(pair).reliable == Verdict::fem) {
      const auto reliable = runs.begin() + (pair.fem - runs.data());
      std::rotate(runs.begin(), reliable, reliable + 1);
      return;
    }
}

}  // namespace berm::report
