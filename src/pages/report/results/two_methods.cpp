// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/report/results/two_methods_test.cpp
#include "report/results/results_section.hpp"

#include "input/write_case.hpp"
#include "material/clay.hpp"
#include "os/text_of_list.hpp"
#include "structures/base/driven_body.hpp"
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
constexpr const char* friction = "soil with friction";

/// A run by each method of one case, and what is said of their quality.
struct Pair {
  const record::RunRecord *mpm, *fem;
  const Judgement *of_mpm, *of_fem;
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

/// A key result of both.
struct Both {
  const Quantity* name;  ///< that of the material point run
  Real mpm, fem;

  /// Over the finite element value; NaN where that is 0.
  Real difference() const { return fem == 0 ? nan : (mpm - fem) / std::abs(fem); }
};

std::vector<Both> key_results_of(const Pair& pair)
{
  const auto is_key = [](const Quantity& q) { return q.kind == run_folder::QuantityKind::answer && std::isfinite(q.value); };
  const bool both_ended = pair.mpm->end == record::RunEnd::finished && pair.fem->end == record::RunEnd::finished;
  // A run that stopped has its largest values and those of its end elsewhere.
  const auto is_of_same_place = [&](const std::string& name) {
    return both_ended || name.find("_at_w_") != std::string::npos || (name.find("_at_u_") != std::string::npos && !name.starts_with("u_"));
  };
  std::vector<Both> both;
  for (const Quantity& q : pair.mpm->quantities)
    if (const Quantity* other = pair.fem->quantity(q.name);
        is_key(q) && is_of_same_place(q.name) && other != nullptr && is_key(*other) && other->unit == q.unit)
      both.push_back({&q, q.value, other->value});
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
    largest[result.name->unit] = std::max({largest[result.name->unit], std::abs(result.mpm), std::abs(result.fem)});
  text::HtmlTable table(id, "Key results by both methods; difference in per cent of the finite element value");
  table.columns({{"result"},
                 {"unit"},
                 {fmt::format("material point method ({})", text::html_text(pair.mpm->name)), true},
                 {fmt::format("finite elements ({})", text::html_text(pair.fem->name)), true},
                 {"difference, %", true}});
  for (const Both& result : results) {
    const auto [size, unit] = shown_unit(result.name->unit, largest.at(result.name->unit));
    const Real difference = result.difference();
    table.row({{fmt::format("{} <span class=\"quiet\">{}</span>", name_html(*result.name), text::html_text(result.name->meaning))},
               {text::html_text(unit)},
               {text::table_number(result.mpm / size), true},
               {text::table_number(result.fem / size), true},
               {std::isnan(difference) ? text::no_number : signed_percent(difference), true}},
              std::abs(difference) > large_difference ? "differs" : "");
  }
  return table.html();
}

/// Why the numbers of a run are not to be relied on, HTML; none where nothing bad is known of it.
Words faults_of(const record::RunRecord& run, const Judgement& judgement)
{
  Words faults;
  if (run.end != record::RunEnd::finished) faults.emplace_back("it has not finished");
  if (run.summary && !run.summary->invalid.empty()) faults.emplace_back("its answer is invalid");
  for (const auto& [measure, value, standing] : judgement.measures)
    if (standing == text::Standing::bad)
      faults.push_back(text::html_text(fmt::format("bad measure of trust: {}, {}", measure.what, measure.words(run, value))));
  return faults;
}

/// What of a soil remeshed finite elements have not been compared in with independent results (docs/decisions/0111, Left); "" of clay without softening.
std::string not_compared(const material::Material& soil)
{
  const std::optional<material::Strength> strength = strength_at_rest(soil);
  if (!strength) return fmt::format("soil of the law {}", law_name(soil));
  if (strength->friction_angle > 0) return friction;
  const auto* clay = soil.get_if<material::Clay>();
  return clay != nullptr && clay->sensitivity > 1 ? "softening clay" : "";
}

/// The same of a case.
Words not_compared(const settings::Case& c)
{
  using enum settings::StageKind;
  Words list;
  const std::optional<settings::BodySoil> soil = base::touched_soil(c);
  if (soil)
    for (const material::Material& one : soil->materials)
      if (const std::string what = not_compared(one); !what.empty() && std::ranges::find(list, what) == list.end()) list.push_back(what);
  if (soil && std::ranges::any_of(soil->materials, [](const material::Material& one) { return hydraulics(one).has_value(); }))
    list.emplace_back("consolidation");
  if (std::ranges::none_of(c.rigid, [](const auto& rigid) { return std::holds_alternative<bodies::CircleSettings>(rigid.second.shape); }))
    list.emplace_back("bodies other than a pipe or a ball");
  if (soil && (!soil->layers.empty() || !soil->of_region.empty())) list.emplace_back("layered soil");
  bool forth = false, back = false, lifted = false, recorded = false;
  for (const settings::StageSettings& stage : c.stage) {
    const Real velocity = stage.velocity.value_or(stage.force.value_or(0));
    if (stage.kind == drag) (velocity < 0 ? back : forth) = true;
    if (stage.kind == push && stage.velocity && velocity < 0 && !(stage.until.force && *stage.until.force > 0)) lifted = true;
    if (!stage.load_times.empty() || !stage.loads.empty()) recorded = true;
  }
  if (forth && back) list.emplace_back("drags to and fro");
  if (lifted) list.emplace_back("uplift");
  if (recorded) list.emplace_back("load histories");
  return list;
}

/// " Elements at the pipe in this run: D/10."; "" where that is not known.
std::string elements_here(const record::RunRecord& run)
{
  const settings::Case& c = run.settings;
  const Real over_D = base::body_scale(c).width / base::near_cells(run).first;
  return std::isfinite(over_D) && over_D > 0 ? fmt::format(" Elements at the {} in this run: D/{:.3g}.", base::body_word(c), over_D) : "";
}

/// Which of both results is more reliable, and why.
std::string verdict_on(const Pair& pair)
{
  const std::string mpm = text::html_text(pair.mpm->name), fem = text::html_text(pair.fem->name);
  const Words of_mpm = faults_of(*pair.mpm, *pair.of_mpm), of_fem = faults_of(*pair.fem, *pair.of_fem);
  const auto because = [](const std::string& name, const Words& faults) {
    return fmt::format("{}: {}.", name, text_of_list(faults, "; "));
  };
  const std::string by_mpm = fmt::format("More reliable: the material point method ({}).", mpm),
                    by_fem = fmt::format("More reliable: finite elements ({}).", fem);
  if (!of_mpm.empty() && !of_fem.empty()) return fmt::format("Neither run is reliable. {} {}", because(mpm, of_mpm), because(fem, of_fem));
  if (!of_mpm.empty()) return by_fem + " " + because(mpm, of_mpm);
  if (!of_fem.empty()) return by_mpm + " " + because(fem, of_fem);
  if (const Words open = not_compared(pair.fem->settings); !open.empty()) {
    const bool has_friction = std::ranges::find(open, friction) != open.end();
    return by_mpm +
           fmt::format(" Remeshed finite elements have not been compared with independent results for {}.{}", text_of_list(open, ", "),
                       has_friction
                           ? " The error of the cell size remains: in sand with psi &lt; phi V on cells of D/20 is 14 % above D/40 "
                             "(examples/mesh_study)."
                           : "");
  }
  return by_fem +
         " Contact acts on the exact surface of the body, and the error of the element size is known: in examples/remeshed_pipe (smooth "
         "pipe "
         "pushed 0.5 D into clay) elements of D/5, D/10 and D/20 give V 0.9, 0.3 and 0.3 % above an independent program with D/40. The "
         "material point method converges at first order: cells of D/10, D/20 and D/40 give V 3.6, 2.5 and 1.5 % above it." +
         elements_here(*pair.fem);
}

/// What the size of the differences says.
std::string words_on_differences(const std::vector<Both>& results)
{
  Words large;
  for (const Both& result : results)
    if (std::abs(result.difference()) > large_difference) large.push_back(name_html(*result.name));
  if (large.empty()) return "No difference exceeds 10 %.";
  const std::size_t more = large.size() > max_named ? large.size() - max_named : 0;
  large.resize(large.size() - more);
  return fmt::format(
      "The difference exceeds 10 % for {}{}. The usual causes: cells or elements too coarse at the body; the contact gap of the "
      "material point method, which makes the body larger by a part of a cell; a drive so fast that inertia adds to its resistance; noise "
      "of its forces; softening, whose shear bands are as wide as a cell or an element. Halve the size of the cells and the speed, and "
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
    html += table_of(pair, results, id) + fmt::format("<p>{} {}</p>\n", verdict_on(pair), words_on_differences(results));
  }
  return html.empty() ? "" : "<h3>Two methods</h3>\n" + html;
}

}  // namespace berm::report
