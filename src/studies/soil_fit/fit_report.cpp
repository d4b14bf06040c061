// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/soil_fit/fit_report_test.cpp
#include "soil_fit/fit_report.hpp"

#include "input/message_text.hpp"
#include "input/override.hpp"
#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "run_folder/build.hpp"
#include "run_folder/csv_line.hpp"
#include "soil_fit/marks.hpp"
#include "soil_fit/passages.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <set>

namespace berm::soil_fit {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* page_file = "fit.html";
constexpr Real tail = 1.645;  // of a normal distribution, beyond which 5 % lie

std::string title_of(const FitResults& results)
{
  return results.settings.title.empty() ? "Soil fitted to tests" : results.settings.title;
}

std::string unit_of(const FreeKey& free)
{
  return free.unit == "1" ? "" : free.unit;
}

/// A number of a key, and the unit that people write it in.
struct Shown {
  Real number;
  std::string unit;
};
Shown shown(const FreeKey& free, Real value)
{
  const std::string unit = unit_of(free);
  if (unit == "rad") return {value * 180 / pi, "deg"};
  if (unit != "Pa") return {value, unit};
  constexpr Real kilo = 1e3, mega = 1e6;
  const Real size = std::max(std::abs(free.from), std::abs(free.to));
  return size >= mega ? Shown{value / mega, "MPa"} : Shown{value / kilo, "kPa"};
}

std::string quantity_of(const FreeKey& free, Real value, int digits = 4)
{
  const Shown s = shown(free, value);
  return fmt::format("{:.{}g}{}{}", s.number, digits, s.unit.empty() ? "" : " ", s.unit);
}

std::string error_words(const FittedKey& key)
{
  if (key.at_bound) return "at its bound";
  return std::isfinite(key.error) ? quantity_of(key.free, key.error, 2) : "not known";
}

/// A mark in all tests: how the computed one differs from the measured one.
struct MarkKind {
  const char *name, *label, *unit;
  Real Marks::*member;
  bool relative;
  Real shown;
  const char* shown_unit;
};
constexpr std::array<MarkKind, 4> mark_kinds = {
    {{"friction_angle_peak", "phi, peak", "rad", &Marks::friction_angle_peak, false, 180 / pi, "deg"},
     {"dilation_angle_peak", "psi, peak", "rad", &Marks::dilation_angle_peak, false, 180 / pi, "deg"},
     {"E50", "E50", "1", &Marks::E50, true, 100, "%"},
     {"s_u", "s_u", "1", &Marks::s_u, true, 100, "%"}}};

/// Root mean square of a mark's difference over the tests that show it, and their number.
std::pair<Real, int> rms_of(const FittedSoil& soil, const MarkKind& kind, bool held_out)
{
  Real sum = 0;
  int count = 0;
  for (const FittedTest& test : soil.tests) {
    if (test.measured.held_out != held_out) continue;
    const Real measured = marks_measured(test).*kind.member, computed = marks_computed(test).*kind.member;
    if (!std::isfinite(measured) || !std::isfinite(computed)) continue;
    sum += std::pow(kind.relative ? computed / measured - 1 : computed - measured, 2);
    ++count;
  }
  return {count > 0 ? std::sqrt(sum / count) : nan, count};
}

Json quantities_json(const FitResults& results)
{
  Json all = Json::object();
  const auto add = [&](const std::string& name, Real value, const std::string& unit, const std::string& meaning) {
    all[name] = {{"value", value}, {"unit", unit.empty() ? "1" : unit}, {"meaning", meaning}};
  };
  for (const FittedKey& key : results.soil.keys) {
    add(key.free.key, key.value, unit_of(key.free), "value that was found");
    add(key.free.key + ".standard_error", key.error, unit_of(key.free), "its standard error");
  }
  add("misfit", results.soil.misfit, "1", "root of the mean square of computed less measured, divided by the largest of each curve");
  add("misfit_at_start", results.soil.misfit_at_start, "1", "the same of the material in the input");
  for (const bool held_out : {false, true})
    for (const MarkKind& kind : mark_kinds)
      if (const auto [rms, count] = rms_of(results.soil, kind, held_out); count > 0)
        add(fmt::format("{}rms.{}", held_out ? "held_out." : "", kind.name), rms, kind.unit,
            fmt::format("root mean square of the {}difference in {} over {} tests", kind.relative ? "relative " : "", kind.label, count));
  for (const FittedTest& test : results.soil.tests)
    for (std::size_t k = 0; k < test.rms.size(); ++k) {
      const Compared what = test.measured.curves[k].what;
      add(fmt::format("{}.{}_rms", test.measured.name, word_of(what)), test.rms[k], is_strain(what) ? "1" : "Pa",
          "root mean square of computed less measured");
    }
  for (const FittedTest& test : results.soil.tests)
    if (test.measured.passages) {
      const std::vector<Real>& resistance = test.measured.curves[0].values;
      add(test.measured.name + ".depth", test.measured.passages->depth, "m", "middle of the interval below the seabed");
      add(test.measured.name + ".first_resistance", resistance.front(), "Pa", "measured in the first passage");
      add(test.measured.name + ".last_over_first", resistance.back() / resistance.front(), "",
          "measured resistance, last divided by first passage");
    }
  return all;
}

std::string summary_json(const FitResults& results)
{
  Json checks = {{"finished", true}};
  for (const FittedTest& test : results.soil.tests) checks[test.measured.name + ".failed"] = !test.complete;
  Json correlation = Json::object();
  for (std::size_t i = 0; i < results.soil.keys.size(); ++i)
    for (std::size_t j = 0; j < results.soil.keys.size(); ++j)
      correlation[results.soil.keys[i].free.key][results.soil.keys[j].free.key] =
          results.soil.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  Json all = {{"quantities", quantities_json(results)},
              {"timing", {{"wall_s", results.wall_s}, {"steps", results.soil.evaluations}}},
              {"checks", checks},
              {"correlation", correlation},
              {"doubts", doubts(results.soil)}};
  all["text"] = {{"title", results.settings.title}, {"version", BERM_VERSION}};
  for (const auto& [name, words] : run_folder::this_build()) all["text"][name] = words;
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string curves_csv(const FitResults& results)
{
  std::string csv = "test,fitted,quantity,along,measured,computed\n";
  for (const FittedTest& test : results.soil.tests)
    for (std::size_t k = 0; k < test.computed.size(); ++k) {
      const MeasuredTest& of = test.measured;
      const Compared what = of.curves[k].what;
      const auto shown = [&](Real x) { return is_strain(what) ? engineering_strain(x) : x; };
      for (std::size_t row = 0; row < of.rows(); ++row)
        csv += fmt::format("{},{},{},{:.6g},{:.6g},{:.6g}\n", run_folder::csv_field(of.name), of.held_out ? 0 : 1, name_of(what),
                           as_measured(of, of.driven[row]), shown(of.curves[k].values[row]), shown(test.computed[k][row]));
    }
  return csv;
}

/// Writes the material of the input with what was found.
struct MaterialWriter {
  const std::vector<FittedKey>& keys;
  const std::set<std::string>& own;  ///< keys that each specimen had of its own

  const FittedKey* fitted(const std::string& key) const
  {
    const auto found = std::find_if(keys.begin(), keys.end(), [&](const FittedKey& k) { return k.free.key == key; });
    return found == keys.end() ? nullptr : &*found;
  }

  /// A value as TOML; `key` is dotted from the material.
  std::string value(const input::Node& node, const std::string& key) const
  {
    using enum input::Node::Kind;
    if (const FittedKey* found = fitted(key)) {
      const std::string number = quantity_of(found->free, found->value, 6);
      return unit_of(found->free).empty() ? number : "\"" + number + "\"";
    }
    if (node.kind == boolean) return node.truth ? "true" : "false";
    if (node.kind == whole) return std::to_string(node.whole);
    if (node.kind == number) return fmt::format("{:.6g}", node.number);
    if (node.kind == text) return Json(node.text).dump();
    std::string items;
    for (const input::Node& item : node.items) {
      const bool named = node.kind == table;
      items += (items.empty() ? "" : ", ") + (named ? item.key + " = " : "") + value(item, named ? key + "." + item.key : "");
    }
    return node.kind == table ? "{" + items + "}" : "[" + items + "]";
  }

  std::string remark(const std::string& key) const
  {
    std::string remarks;
    for (const FittedKey& found : keys)
      if (found.free.key == key || found.free.key.starts_with(key + "."))
        remarks += (remarks.empty() ? "   # fitted, " : "; ") +
                   (found.at_bound ? std::string("at its bound") : "standard error " + error_words(found));
    return own.count(key) > 0 ? "   # each specimen had its own: give that of the site" : remarks;
  }
};

std::string priors_toml(const FitResults& results)
{
  std::string toml = "# For the [sample] of a study: 5 and 95 % of each key by the standard error of the fit. The variability of the "
                     "ground is not included.\n";
  for (const FittedKey& key : results.soil.keys) {
    if (key.at_bound || !std::isfinite(key.error)) continue;
    const auto at = [&](Real value) { return quantity_of(key.free, std::clamp(value, key.free.from, key.free.to), 7); };
    const std::string quote = unit_of(key.free).empty() ? "" : "\"";
    toml += fmt::format("\n[[sample.parameter]]\nname = \"{0}\"\nkeys = [\"material.{1}.{0}\"]\ndistribution = \"normal\"\nlow = "
                        "{2}{3}{2}\nbest = {2}{4}{2}\nhigh = {2}{5}{2}\n",
                        key.free.key, results.settings.material_name(), quote, at(key.value - tail * key.error), at(key.value),
                        at(key.value + tail * key.error));
  }
  return toml;
}

std::string keys_html(const FitResults& results)
{
  std::string html = "<table>\n" + text::plain_row({"key", "from", "to", "at the start", "found", "standard error"}, 1, 5, "th");
  for (const FittedKey& key : results.soil.keys)
    html += text::plain_row({text::html_text(key.free.key), quantity_of(key.free, key.free.from), quantity_of(key.free, key.free.to),
                             quantity_of(key.free, key.start), "<b>" + quantity_of(key.free, key.value) + "</b>", error_words(key)},
                            1, 5, "td");
  return html + "</table>\n";
}

std::string correlation_html(const FittedSoil& soil)
{
  std::vector<std::string> head = {"correlation"};
  for (const FittedKey& key : soil.keys) head.push_back(text::html_text(key.free.key));
  std::string html = "<table>\n" + text::plain_row(head, 1, head.size(), "th");
  for (Eigen::Index i = 0; i < soil.correlation.rows(); ++i) {
    std::vector<std::string> row = {head[static_cast<std::size_t>(i) + 1]};
    for (Eigen::Index j = 0; j < soil.correlation.cols(); ++j) row.push_back(fmt::format("{:.2f}", soil.correlation(i, j)));
    html += text::plain_row(row, 1, row.size(), "td");
  }
  return html + "</table>\n";
}

std::string tests_html(const FitResults& results)
{
  std::vector<const MarkKind*> kinds;
  std::vector<std::string> head = {"test", "misfit, of the largest of each curve"};
  for (const MarkKind& kind : mark_kinds) {
    if (rms_of(results.soil, kind, false).second + rms_of(results.soil, kind, true).second == 0) continue;
    kinds.push_back(&kind);
    head.insert(head.end(), {kind.label, "computed"});
  }
  std::string html = "<table>\n" + text::plain_row(head, 2, head.size(), "th");
  const auto mark = [](const MarkKind& kind, Real value) {
    if (!std::isfinite(value)) return std::string("-");
    return kind.relative ? text::stress_words(value) : fmt::format("{:.1f} deg", value * kind.shown);
  };
  for (const FittedTest& test : results.soil.tests) {
    std::string misfit;
    for (std::size_t k = 0; k < test.rms.size(); ++k)
      misfit += fmt::format("{}{} {:.1f} %", k == 0 ? "" : ", ", name_of(test.measured.curves[k].what),
                            test.largest[k] > 0 ? 100 * test.rms[k] / test.largest[k] : 0);
    if (!test.complete) misfit += "; the law has no state for a part of it";
    std::vector<std::string> row = {text::html_text(test.measured.name) + (test.measured.held_out ? " (held out)" : ""),
                                    text::html_text(misfit)};
    for (const MarkKind* kind : kinds)
      row.insert(row.end(), {mark(*kind, marks_measured(test).*kind->member), mark(*kind, marks_computed(test).*kind->member)});
    html += text::plain_row(row, 2, row.size(), "td");
  }
  return html + "</table>\n";
}

std::string list_html(const std::vector<std::string>& sentences)
{
  std::string html = "<ul>\n";
  for (const std::string& sentence : sentences) html += "<li>" + text::html_text(sentence) + "</li>\n";
  return html + "</ul>\n";
}

/// How far the tests are met, a sentence each.
std::vector<std::string> words_of_misfit(const FittedSoil& soil)
{
  std::string ends;
  for (const Real misfit : soil.misfits) ends += fmt::format("{}{:.4f}", ends.empty() ? "" : ", ", misfit);
  std::vector<std::string> words = {
      fmt::format("misfit {:.4f} of the largest of each curve (at the start {:.4f}); the searches ended at {}", soil.misfit,
                  soil.misfit_at_start, ends)};
  for (const bool held_out : {false, true}) {
    std::string line;
    for (const MarkKind& kind : mark_kinds)
      if (const auto [rms, count] = rms_of(soil, kind, held_out); count > 0)
        line += fmt::format("{}{} {:.3g} {}", line.empty() ? "" : ", ", kind.label, rms * kind.shown, kind.shown_unit);
    if (!line.empty()) words.push_back(fmt::format("root mean square over {} tests: {}", held_out ? "held-out" : "fitted", line));
  }
  return words;
}

std::string page_html(const FitResults& results, const std::vector<std::string>& figures, const fs::path& folder)
{
  std::string html = fmt::format("<h1>{}</h1>\n", text::html_text(title_of(results)));
  html += "<p>Keys of the soil fitted to the measured tests by least squares. Standard errors are those of the "
          "fit: how much the "
          "ground varies, and the error of the law, are not in them.</p>\n";
  html += keys_html(results) + list_html(words_of_misfit(results.soil));
  if (const std::vector<std::string> what = doubts(results.soil); !what.empty())
    html += "<h2>What the tests do not determine</h2>\n" + list_html(what);
  html += "<h2>Soil, to paste into a case</h2>\n<pre>" + text::html_text(material_toml(results)) + "</pre>\n";
  html += "<h2>Measured and computed</h2>\n<div class=\"pictures\">\n";
  for (const std::string& figure : figures) html += plot::html_image(folder, figure, figure);
  html += "</div>\n<h2>Tests</h2>\n" + tests_html(results);
  for (const FittedTest& test : results.soil.tests)
    if (test.measured.passages) html += passages_html(test.measured, test.computed[0]);
  html += "<h2>Correlations</h2>\n" + correlation_html(results.soil);
  html += fmt::format("<h2>Input</h2>\n<pre>{}</pre>\n", text::html_text(results.input));
  html += fmt::format("<p class=\"quiet\">berm {}; all digits are in <a href=\"summary.json\">summary.json</a> and <a "
                      "href=\"curves.csv\">curves.csv</a>, the sample of a study in "
                      "<a href=\"priors.toml\">priors.toml</a>.</p>\n",
                      BERM_VERSION);
  return text::plain_page("berm: " + title_of(results), html);
}

}  // namespace

bool holds_results(const fs::path& folder)
{
  return io::holds_page(folder, page_file, "berm fit");
}

void write_results(const FitResults& results, const fs::path& folder)
{
  io::make_folder(folder);
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".png") fs::remove(entry.path(), error);
  io::write_atomically(folder / "case.toml", results.input);
  io::write_atomically(folder / "curves.csv", curves_csv(results));
  io::write_atomically(folder / "material.toml", material_toml(results));
  io::write_atomically(folder / "priors.toml", priors_toml(results));
  const std::vector<std::string> figures = draw_figures(results, folder);
  io::write_atomically(folder / page_file, page_html(results, figures, folder));
  io::write_atomically(folder / "summary.json", summary_json(results));
}

std::string material_toml(const FitResults& results)
{
  const input::Found found = input::follow(results.settings.document.root, "material." + results.settings.material_name());
  std::set<std::string> own;
  for (const FittedTest& test : results.soil.tests)
    for (const auto& [key, value] : test.measured.specimen) own.insert(key);
  const MaterialWriter writer{results.soil.keys, own};
  std::string toml = fmt::format("[material.{}]\n", results.settings.material_name());
  for (const input::Node& item : found.node->items)
    toml += fmt::format("{} = {}{}\n", item.key, writer.value(item, item.key), writer.remark(item.key));
  return toml;
}

std::vector<std::string> doubts(const FittedSoil& soil)
{
  std::vector<std::string> all;
  constexpr Real much = 0.95, little_strain = 0.005;
  for (const FittedTest& test : soil.tests) {
    Real most = 0;
    for (const Real driven : test.measured.driven) most = std::max(most, std::abs(driven));
    if (test.measured.passages) {
      const std::vector<std::string> own = doubts_of_passages(test.measured, test.computed[0]);
      all.insert(all.end(), own.begin(), own.end());
    } else if (!test.measured.by_stress() && most < little_strain)
      all.push_back(fmt::format("{} reaches only {:.2g} % of strain: is the unit of its strain right?", test.measured.name, 100 * most));
  }
  for (const FittedKey& key : soil.keys) {
    if (key.at_bound)
      all.push_back(fmt::format("{} ends at its bound, {}: the best fit lies beyond; widen the bound, or question the law", key.free.key,
                                quantity_of(key.free, key.value)));
    else if (!std::isfinite(key.error) || key.error > slope_of(key.free, key.value) / 2)
      all.push_back(
          fmt::format("{} is not determined by these tests: keep it at a value that is known, and leave it out of [[free]]", key.free.key));
  }
  for (std::size_t i = 0; i < soil.keys.size(); ++i)
    for (std::size_t j = i + 1; j < soil.keys.size(); ++j)
      if (const Real r = soil.correlation(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)); std::abs(r) > much)
        all.push_back(fmt::format(
            "only a combination of {} and {} is determined (correlation {:.3f}): fix one of them, or add a test that separates them",
            soil.keys[i].free.key, soil.keys[j].free.key, r));
  for (const FlatDirection& direction : soil.flat) {
    std::string steps;
    Real most = 0;
    for (std::size_t k = 0; k < direction.step.size(); ++k) most = std::max(most, std::abs(direction.step[k]));
    for (std::size_t k = 0; k < direction.step.size(); ++k)
      if (std::abs(direction.step[k]) > most / 4)
        steps +=
            fmt::format("{}{} {}{}", steps.empty() ? "" : ", ", soil.keys[k].free.key, direction.step[k] > 0 ? "+" : "-",
                        quantity_of(soil.keys[k].free, std::abs(direction.step[k]) * slope_of(soil.keys[k].free, soil.keys[k].value), 2));
    all.push_back("a direction that the tests hardly determine, by one standard error: " + steps);
  }
  return all;
}

std::string words_of_results(const FitResults& results)
{
  std::string words = fmt::format("  {:<28} {:>14} {:>14} {:>16}\n", "", "at the start", "found", "standard error");
  for (const FittedKey& key : results.soil.keys)
    words += fmt::format("  {:<28} {:>14} {:>14} {:>16}\n", key.free.key, quantity_of(key.free, key.start),
                         quantity_of(key.free, key.value), error_words(key));
  for (const std::string& sentence : words_of_misfit(results.soil)) words += sentence + "\n";
  for (const std::string& sentence : doubts(results.soil)) words += "doubt: " + sentence + "\n";
  for (const FittedTest& test : results.soil.tests)
    if (!test.complete) words += fmt::format("{}: the law has no state for a part of it\n", test.measured.name);
  return words;
}

}  // namespace berm::soil_fit
