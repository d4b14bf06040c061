// SPDX-License-Identifier: BSD-3-Clause
#include "cyclic/cyclic_report.hpp"

#include "input/write_case.hpp"
#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "run_folder/build.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::cyclic {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string title_of(const CyclicResults& results)
{
  return results.settings.title.empty() ? "Cyclic strength for a storm" : results.settings.title;
}

std::string measure_of(const CyclicResults& results, Real value)
{
  return results.settings.contours.of == Measure::shear_strain ? fmt::format("{:.3g} % shear strain", 100 * value)
                                                               : fmt::format("a pore pressure ratio of {:.3g}", value);
}

std::vector<std::string> answer(const CyclicResults& results)
{
  const CyclicCase& c = results.settings;
  const StormStrength& s = results.strength;
  const Real failure = c.diagram.strains()[c.failure];
  std::vector<std::string> words = {
      s.given.fails ? fmt::format("Under the storm as given the clay fails in parcel {}.", s.given.parcels.size())
                    : fmt::format("The storm as given ends at {}, equivalent to {:.3g} cycles of its largest load.",
                                  measure_of(results, s.given.parcels.back().strain), s.given_cycles),
      fmt::format("With its cyclic loads times {:.4g} it just reaches {}, equivalent to N_eq = {:.3g} cycles of its largest load.",
                  s.multiplier, measure_of(results, failure), s.equivalent_cycles),
      fmt::format("Cyclic strength: tau_f,cy = ({:.3g} + {:.3g}) s_u = {:.4g} s_u, average and cyclic. Multiply the undrained strength by "
                  "{:.4g}, and load with "
                  "the average and the largest cyclic load together.",
                  c.storm.average(), s.stress, results.factor(), results.factor())};
  if (c.diagram.strains().size() == 1)
    words.emplace_back("The table has one contour: what happens below it is taken from lines of the same form through lower stresses.");
  return words;
}

/// Of each storm, name and path.
std::vector<std::pair<std::string, const StormPath*>> storms(const CyclicResults& results)
{
  return {{"as given", &results.strength.given}, {"to failure", &results.strength.failing}};
}

std::vector<std::string> cells(const ParcelPath& p, std::size_t k)
{
  std::vector<std::string> all = {std::to_string(k + 1)};
  for (const Real value : {p.parcel.cycles, p.parcel.stress, p.begin, p.end, p.strain}) all.push_back(fmt::format("{:.4g}", value));
  return all;
}

std::vector<std::string> headings(const CyclicResults& results)
{
  return {"parcel", "cycles", "tau_cy/s_u", "from N", "to N", measure_words[static_cast<std::size_t>(results.settings.contours.of)]};
}

std::string parcels_csv(const CyclicResults& results)
{
  std::string csv = fmt::format("storm,parcel,cycles,cyclic_stress_ratio,N_begin,N_end,{}\n", headings(results).back());
  for (const auto& [name, path] : storms(results))
    for (std::size_t k = 0; k < path->parcels.size(); ++k) csv += fmt::format("{},{}\n", name, fmt::join(cells(path->parcels[k], k), ","));
  return csv;
}

std::string summary_json(const CyclicResults& results)
{
  const StormStrength& s = results.strength;
  Json quantities = Json::object();
  const auto add = [&](const char* name, Real value, const char* meaning) {
    quantities[name] = {{"value", value}, {"unit", "1"}, {"meaning", meaning}};
  };
  add("strength_factor", results.factor(), "average and cyclic shear stress at failure divided by the undrained strength");
  add("cyclic_strength_ratio", s.stress, "cyclic shear stress of the largest parcel at failure divided by the undrained strength");
  add("average_stress_ratio", results.settings.storm.average(), "average shear stress divided by the undrained strength");
  add("equivalent_cycles", s.equivalent_cycles, "cycles of the largest load to failure that are equivalent to the storm, N_eq");
  add("load_multiplier", s.multiplier, "factor on the cyclic loads with which the storm just reaches failure");
  add("equivalent_cycles_as_given", s.given_cycles, "cycles of the largest load that are equivalent to the storm as it is given");
  add("accumulated_as_given", s.given.parcels.back().strain, "quantity of the contours at the end of the storm as given");
  Json all = {
      {"quantities", quantities},
      {"timing", {{"wall_s", results.wall_s}, {"steps", s.failing.parcels.size()}}},
      {"checks", {{"finished", true}, {"fails_as_given", s.given.fails}}},
      {"text",
       {{"title", results.settings.title}, {"version", BERM_VERSION}, {"answer", fmt::format("{}", fmt::join(answer(results), " "))}}}};
  for (const auto& [name, words] : run_folder::this_build()) all["text"][name] = words;
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// A storm on the contours: along each parcel, and from its end along its strain to the stress of the next one.
void add_path(const Contours& contours, const StormPath& path, plot::FigureCurve& curve)
{
  constexpr int steps = 20;
  const auto add = [&](Real cycles, Real stress) { curve.x.push_back(std::max(cycles, contours.first())), curve.y.push_back(stress); };
  for (std::size_t k = 0; k < path.parcels.size(); ++k) {
    const ParcelPath& here = path.parcels[k];
    if (k > 0) {
      const ParcelPath& before = path.parcels[k - 1];
      for (int step = 1; step < steps; ++step) {
        const Real stress = before.parcel.stress + (here.parcel.stress - before.parcel.stress) * step / steps;
        add(contours.cycles(stress, before.strain), stress);
      }
    }
    add(here.begin, here.parcel.stress);
    add(here.end, here.parcel.stress);
  }
}

bool draw(const CyclicResults& results, const fs::path& folder)
{
  const CyclicCase& c = results.settings;
  plot::Figure figure;
  figure.title = fmt::format("Contours at tau_a = {:.3g} s_u, and the storm on them", c.storm.average());
  figure.x_label = "number of cycles N";
  figure.y_label = "tau_cy / s_u";
  figure.more = "set logscale x\nset yrange [0:*]\n";
  figure.width = 900, figure.height = 520;
  for (std::size_t k = 0; k < c.diagram.strains().size(); ++k) {
    plot::FigureCurve curve{
        measure_of(results, c.diagram.strains()[k]), plot::curve_style(5, k == c.failure ? 0 : 1, k == c.failure ? 2.5 : 1), {}, {}};
    constexpr int points = 100;
    for (int p = 0; p <= points; ++p) {
      curve.x.push_back(c.diagram.first() * std::pow(c.diagram.last() / c.diagram.first(), Real(p) / points));
      curve.y.push_back(c.diagram.stress(k, std::clamp(curve.x.back(), c.diagram.first(), c.diagram.last())));
    }
    figure.curves.push_back(curve);
  }
  std::size_t color = 0;
  for (const auto& [name, path] : storms(results)) {
    figure.curves.push_back({"the storm " + name, plot::curve_style(color++, 0), {}, {}});
    add_path(c.diagram, *path, figure.curves.back());
  }
  return plot::draw_figure(folder, "contours", figure);
}

std::string page_html(const CyclicResults& results, bool drawn, const fs::path& folder)
{
  std::string html = fmt::format("<h1>{}</h1>\n", text::html_text(title_of(results)));
  for (const std::string& sentence : answer(results)) html += text::html_paragraph(sentence);
  if (drawn) html += "<div class=\"pictures\">" + plot::html_image(folder, "contours", "contours") + "</div>\n";
  for (const auto& [name, path] : storms(results)) {
    html += fmt::format("<h2>The storm {}</h2>\n<table>\n{}", name, text::plain_row(headings(results), 1, 5, "th"));
    for (std::size_t k = 0; k < path->parcels.size(); ++k) html += text::plain_row(cells(path->parcels[k], k), 1, 5, "td");
    html += "</table>\n";
  }
  if (!results.settings.material.empty())
    html += "<h2>Clay, to paste into a case</h2>\n<pre>" + text::html_text(material_toml(results)) + "</pre>\n";
  html += fmt::format("<h2>Input</h2>\n<pre>{}</pre>\n", text::html_text(results.input));
  html += fmt::format("<p class=\"quiet\">berm {}; all digits are in <a href=\"summary.json\">summary.json</a> and <a "
                      "href=\"parcels.csv\">parcels.csv</a>.</p>\n",
                      BERM_VERSION);
  return text::plain_page("berm: " + title_of(results), html);
}

}  // namespace

void write_results(const CyclicResults& results, const fs::path& folder)
{
  io::make_folder(folder);
  std::error_code ignored;
  for (const char* old : {"contours.png", "material.toml"}) fs::remove(folder / old, ignored);
  io::write_atomically(folder / "case.toml", results.input);
  io::write_atomically(folder / "parcels.csv", parcels_csv(results));
  if (!results.settings.material.empty()) io::write_atomically(folder / "material.toml", material_toml(results));
  const bool drawn = draw(results, folder);
  io::write_atomically(folder / page_file, page_html(results, drawn, folder));
  io::write_atomically(folder / "summary.json", summary_json(results));
}

std::string words_of_results(const CyclicResults& results)
{
  std::string words;
  const auto line = [&](const std::vector<std::string>& row) {
    for (const std::string& cell : row) words += fmt::format("  {:>12}", cell);
    words += "\n";
  };
  for (const auto& [name, path] : storms(results)) {
    words += fmt::format("the storm {}\n", name);
    line(headings(results));
    for (std::size_t k = 0; k < path->parcels.size(); ++k) line(cells(path->parcels[k], k));
  }
  for (const std::string& sentence : answer(results)) words += sentence + "\n";
  return words;
}

std::string material_toml(const CyclicResults& results)
{
  auto scaled = results.settings.material;
  for (auto& [name, material] : scaled) material = *material::with_strength_over(material, 1 / results.factor());
  input::SettingVisitor visitor;
  visitor.named_tables("material", scaled, {.meaning = ""});
  const auto by_rate = [](const auto& one) { return is_rate_dependent(one.second); };
  const bool has_rate = std::any_of(results.settings.material.begin(), results.settings.material.end(), by_rate);
  return fmt::format("# Undrained strength times {:.4g}: the cyclic strength for the storm.{}\n{}", results.factor(),
                     has_rate ? " It includes the rate effect of cyclic tests, so rate_parameter is 0." : "",
                     input::toml_of(visitor.root()));
}

}  // namespace berm::cyclic
