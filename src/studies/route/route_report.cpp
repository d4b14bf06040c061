// SPDX-License-Identifier: BSD-3-Clause
#include "route/route_report.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "run_folder/build.hpp"
#include "run_folder/csv_line.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::route {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

std::string number(Real value)
{
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

std::string short_number(Real value)
{
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : "–";
}

std::string name_of(const RouteResults& results, std::size_t k)
{
  const std::string& name = results.settings.section[k].name;
  return name.empty() ? fmt::format("section_{}", k + 1) : name;
}

/// A number of a section.
struct Quantity {
  const char* name;
  std::string meaning, unit;
  Real value;
};

void add(std::vector<Quantity>& list, const char* low, const char* best, const char* high, const std::string& meaning, const char* unit,
         const Bounds& bounds)
{
  list.push_back({low, "low estimate of the " + meaning, unit, bounds.low});
  list.push_back({best, meaning, unit, bounds.best});
  list.push_back({high, "high estimate of the " + meaning, unit, bounds.high});
}

std::vector<Quantity> quantities(const SectionAnswer& answer)
{
  const Resistances& soil = answer.soil;
  const Screening& screening = answer.screening;
  std::vector<Quantity> list = {{"V", "vertical force in operation", "N/m", soil.V}};
  add(list, "embedment_LE", "embedment", "embedment_HE", "embedment", "m", soil.embedment);
  add(list, "vertical_stiffness_LE", "vertical_stiffness", "vertical_stiffness_HE", "vertical force divided by the embedment", "N/m^2",
      soil.stiffness);
  add(list, "lateral_breakout_LE", "lateral_breakout", "lateral_breakout_HE", "lateral breakout resistance", "N/m", soil.lateral_breakout);
  add(list, "lateral_residual_LE", "lateral_residual", "lateral_residual_HE", "lateral residual resistance", "N/m", soil.lateral_residual);
  add(list, "hydrotest_breakout_LE", "hydrotest_breakout", "hydrotest_breakout_HE", "lateral breakout resistance, flooded", "N/m",
      soil.hydrotest_breakout);
  add(list, "axial_breakout_LE", "axial_breakout", "axial_breakout_HE", "axial breakout resistance", "N/m", soil.axial_breakout);
  add(list, "axial_residual_LE", "axial_residual", "axial_residual_HE", "axial residual resistance", "N/m", soil.axial_residual);
  add(list, "uplift_LE", "uplift", "uplift_HE", "uplift resistance", "N/m", soil.uplift);
  list.push_back({"constrained_force", "largest effective compression of the fully restrained line", "N", screening.constrained_force});
  list.push_back({"compression", "largest effective compression with the axial resistance to the ends", "N", screening.compression});
  list.push_back({"hobbs_force", "smallest compression for a lateral buckle, low resistances [Hobbs 1984]", "N", screening.hobbs});
  list.push_back({"curve_force", "compression at which the line leaves its curve, low lateral resistance", "N", screening.curve});
  list.push_back({"lateral_utilisation", "compression divided by the smaller of the two", "1", screening.lateral});
  list.push_back({"buckle_amplitude", "amplitude of a buckle at that compression, best residual resistances [Hobbs 1984]", "m",
                  screening.buckle.amplitude});
  list.push_back({"buckle_moment", "its largest moment", "N m", screening.buckle.moment});
  list.push_back({"feed_in", "feed-in from both sides", "m", screening.feed_in});
  add(list, "anchor_spacing_LE", "anchor_spacing", "anchor_spacing_HE", "distance between its virtual anchors", "m",
      screening.anchor_spacing);
  list.push_back(
      {"required_download", "download that holds the line on the imperfection [Palmer and others 1990]", "N/m", screening.download});
  list.push_back(
      {"upheaval_utilisation", "that divided by the weight in operation plus the low uplift resistance", "1", screening.upheaval});
  std::erase_if(list, [](const Quantity& q) { return !std::isfinite(q.value); });
  return list;
}

std::string title_of(const RouteResults& results)
{
  return results.settings.title.empty() ? "Pipeline along a route" : results.settings.title;
}

/// What is as bad as anywhere, in words; "" where it is known nowhere.
std::string worst_words(const RouteResults& results, Real Screening::*utilisation, const char* yes, const char* no)
{
  std::size_t worst = results.answer.size();
  for (std::size_t k = 0; k < results.answer.size(); ++k)
    if (const Real here = results.answer[k].screening.*utilisation;
        std::isfinite(here) && (worst == results.answer.size() || here > results.answer[worst].screening.*utilisation))
      worst = k;
  if (worst == results.answer.size()) return "";
  const Real largest = results.answer[worst].screening.*utilisation;
  return fmt::format("{}: utilisation {:.3g} at most, in {} (KP {:.3f} to {:.3f}).", largest > 1 ? yes : no, largest,
                     name_of(results, worst), results.settings.section[worst].from / 1000, results.settings.section[worst].to / 1000);
}

Words answer_in_words(const RouteResults& results)
{
  Words words;
  const Real length = results.settings.section.back().to - results.settings.section.front().from;
  for (std::string line : {worst_words(results, &Screening::lateral, "Lateral buckling is possible", "No lateral buckling"),
                           worst_words(results, &Screening::upheaval, "Upheaval buckling is possible", "No upheaval buckling")})
    if (!line.empty()) words.push_back(line);
  for (std::size_t k = 0; k < results.answer.size(); ++k) {
    const Screening& s = results.answer[k].screening;
    if (!(s.lateral > 1)) continue;
    std::string line = fmt::format("{}: {:.4g} MN ({:.4g} MN fully restrained), {:.4g} MN needed for a buckle of {} lobes{}",
                                   name_of(results, k), s.compression / 1e6, s.constrained_force / 1e6, s.hobbs / 1e6, s.lobes,
                                   std::isnan(s.curve) ? "" : fmt::format(", {:.4g} MN in the curve", s.curve / 1e6));
    if (const Bounds& apart = s.anchor_spacing; apart.best > length)
      line += fmt::format(
          ". Its virtual anchors would be {:.4g} m apart, more than the length of the route: the whole line feeds in, and Hobbs's "
          "amplitude is an upper bound",
          apart.best);
    else if (std::isfinite(apart.best))
      line += fmt::format("; its virtual anchors are {:.4g} m apart ({:.4g} to {:.4g} m with the high and the low axial residual), and "
                          "the feed-in is {:.3g} m",
                          apart.best, apart.low, apart.high, s.feed_in);
    words.push_back(line + ".");
  }
  for (std::size_t k = 0; k < results.answer.size(); ++k)
    for (const std::string& doubt : results.answer[k].soil.doubts) words.push_back(name_of(results, k) + ": " + doubt + ".");
  words.emplace_back("A screening: a straight or evenly curved line on a level bed, formulas of an exposed pipe where there is no cover.");
  return words;
}

std::string line_of(const Words& fields)
{
  std::string line;
  for (const std::string& field : fields) line += run_folder::csv_field(field) + ",";
  line.back() = '\n';
  return line;
}

/// A row for each section; all quantities that any of them has.
std::string springs_csv(const RouteResults& results)
{
  std::vector<Quantity> columns;
  for (const SectionAnswer& answer : results.answer)
    for (const Quantity& q : quantities(answer))
      if (std::ranges::none_of(columns, [&](const Quantity& known) { return std::string(known.name) == q.name; })) columns.push_back(q);
  Words head = {"kp_from_km", "kp_to_km", "section"};
  for (const Quantity& q : columns) head.push_back(fmt::format("{} ({})", q.name, q.unit));
  head.emplace_back("source");
  std::string text = line_of(head);
  for (std::size_t k = 0; k < results.answer.size(); ++k) {
    const Section& s = results.settings.section[k];
    Words row = {fmt::format("{:.6g}", s.from / 1000), fmt::format("{:.6g}", s.to / 1000), name_of(results, k)};
    const std::vector<Quantity> known = quantities(results.answer[k]);
    for (const Quantity& column : columns) {
      const auto found = std::ranges::find_if(known, [&](const Quantity& q) { return std::string(q.name) == column.name; });
      row.push_back(found == known.end() ? "" : number(found->value));
    }
    row.push_back(results.answer[k].soil.source);
    text += line_of(row);
  }
  return text;
}

std::string buckpy_csv(const RouteResults& results)
{
  std::string text = line_of(buckpy_columns());
  const auto add_bounds = [](Words& row, const Bounds& bounds, Real V) {
    for (const Real F : {bounds.low, bounds.best, bounds.high}) row.push_back(number(F / V));
    row.emplace_back(std::isfinite(bounds.low + bounds.best + bounds.high) ? "LE_BE_HE" : "");
  };
  for (std::size_t k = 0; k < results.answer.size(); ++k) {
    const Resistances& soil = results.answer[k].soil;
    if (std::isnan(soil.lateral_breakout.best)) continue;
    Words row = {"", name_of(results, k)};
    add_bounds(row, soil.axial_breakout, soil.V);
    add_bounds(row, soil.hydrotest_breakout, results.settings.pipe.flooded.value_or(nan));
    add_bounds(row, soil.lateral_breakout, soil.V);
    row.push_back(fmt::format("KP {:.3f} to {:.3f}: breakout / V; axial residual {} / V; {}", results.settings.section[k].from / 1000,
                              results.settings.section[k].to / 1000, number(soil.axial_residual.best / soil.V), soil.source));
    text += line_of(row);
  }
  return text;
}

std::string summary_json(const RouteResults& results)
{
  Json all = {{"quantities", Json::object()},
              {"timing", {{"wall_s", results.wall_s}, {"steps", results.answer.size()}}},
              {"checks", {{"finished", true}}},
              {"text",
               {{"title", results.settings.title},
                {"version", BERM_VERSION},
                {"answer", fmt::format("{}", fmt::join(answer_in_words(results), " "))}}}};
  for (std::size_t k = 0; k < results.answer.size(); ++k)
    for (const Quantity& q : quantities(results.answer[k]))
      all["quantities"][name_of(results, k) + "." + q.name] = {
          {"value", q.value}, {"unit", q.unit}, {"meaning", q.meaning}, {"source", results.answer[k].soil.source}};
  for (const auto& [name, words] : run_folder::this_build()) all["text"][name] = words;
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// One line of a figure: level in each section.
struct Course {
  const char* title;
  std::size_t color, dash;
  std::function<Real(const SectionAnswer&)> value;
};

bool draw(const RouteResults& results, const fs::path& folder, const char* name, const char* title, const char* unit, Real scale,
          const std::vector<Course>& courses, const std::vector<plot::FigureCurve>& more = {})
{
  plot::Figure figure;
  figure.title = title;
  figure.x_label = "KP (km)";
  figure.y_label = unit;
  figure.more = plot::from_zero;
  figure.width = 900, figure.height = 380;
  figure.curves = more;
  for (const Course& course : courses) {
    plot::FigureCurve curve{course.title, plot::curve_style(course.color, course.dash), {}, {}};
    bool known = false;
    for (std::size_t k = 0; k < results.answer.size(); ++k) {
      const Real value = course.value(results.answer[k]) / scale;
      known = known || std::isfinite(value);
      for (const Real kp : {results.settings.section[k].from, results.settings.section[k].to})
        curve.x.push_back(kp / 1000), curve.y.push_back(value);
      curve.x.push_back(results.settings.section[k].to / 1000), curve.y.push_back(nan);
    }
    if (known) figure.curves.push_back(curve);
  }
  return plot::draw_figure(folder, name, figure);
}

/// The names of what was drawn.
Words draw_all(const RouteResults& results, const fs::path& folder)
{
  const auto bounds = [](Bounds Resistances::*of, Real Bounds::*end) {
    return [of, end](const SectionAnswer& a) { return a.soil.*of.*end; };
  };
  const auto both = [&](Bounds Resistances::*breakout, Bounds Resistances::*residual) {
    return std::vector<Course>{
        {"breakout LE", 0, 1, bounds(breakout, &Bounds::low)},  {"breakout", 0, 0, bounds(breakout, &Bounds::best)},
        {"breakout HE", 0, 2, bounds(breakout, &Bounds::high)}, {"residual LE", 1, 1, bounds(residual, &Bounds::low)},
        {"residual", 1, 0, bounds(residual, &Bounds::best)},    {"residual HE", 1, 2, bounds(residual, &Bounds::high)}};
  };
  Words drawn;
  if (draw(results, folder, "lateral", "Lateral resistance", "kN/m", 1000,
           both(&Resistances::lateral_breakout, &Resistances::lateral_residual)))
    drawn.emplace_back("lateral");
  if (draw(results, folder, "axial", "Axial resistance", "kN/m", 1000, both(&Resistances::axial_breakout, &Resistances::axial_residual)))
    drawn.emplace_back("axial");
  plot::FigureCurve compression{"with the axial resistance to the ends", plot::curve_style(3, 0), {}, {}};
  for (const SectionAnswer& a : results.answer)
    for (const ForceAt& at : a.compression) compression.x.push_back(at.kp / 1000), compression.y.push_back(at.force / 1e6);
  if (draw(results, folder, "buckling", "Effective compression", "MN", 1e6,
           {{"needed for a lateral buckle", 1, 0, [](const SectionAnswer& a) { return a.screening.hobbs; }},
            {"that leaves the curve", 2, 0, [](const SectionAnswer& a) { return a.screening.curve; }}},
           {compression}))
    drawn.emplace_back("buckling");
  return drawn;
}

std::string page_html(const RouteResults& results, const Words& pictures, const fs::path& folder)
{
  std::string html = fmt::format("<h1>{}</h1>\n", text::html_text(title_of(results)));
  for (const std::string& sentence : answer_in_words(results)) html += text::html_paragraph(sentence);
  for (const std::string& name : pictures) html += "<div class=\"pictures\">" + plot::html_image(folder, name, name) + "</div>\n";
  for (std::size_t k = 0; k < results.answer.size(); ++k) {
    html += fmt::format("<h2>{}, KP {:.3f} to {:.3f}</h2>\n{}<table>\n", text::html_text(name_of(results, k)),
                        results.settings.section[k].from / 1000, results.settings.section[k].to / 1000,
                        text::html_paragraph(results.answer[k].soil.source, "quiet"));
    html += text::plain_row({"", "value", "unit"}, 1, 1, "th");
    for (const Quantity& q : quantities(results.answer[k]))
      html += text::plain_row({text::html_text(q.meaning), short_number(q.value), q.unit}, 1, 1, "td");
    html += "</table>\n";
  }
  html += fmt::format("<h2>Input</h2>\n<pre>{}</pre>\n", text::html_text(results.input));
  html += fmt::format("<p class=\"quiet\">berm {}; by KP in <a href=\"springs.csv\">springs.csv</a>, all digits in <a "
                      "href=\"summary.json\">summary.json</a>.</p>\n",
                      BERM_VERSION);
  return text::plain_page("berm: " + title_of(results), html);
}

}  // namespace

std::vector<std::string> buckpy_columns()
{
  Words head = {"Pipeline", "Friction Set"};
  for (const char* what : {"Axial", "Lateral Hydrotest", "Lateral Operation"})
    for (const char* column : {"LE", "BE", "HE", "Fit Bounds"}) head.push_back(fmt::format("{} {}", what, column));
  head.emplace_back("Soil Description");
  return head;
}

void write_results(const RouteResults& results, const fs::path& folder)
{
  io::make_folder(folder);
  std::error_code ignored;
  for (const char* old : {"lateral.png", "axial.png", "buckling.png"}) fs::remove(folder / old, ignored);
  io::write_atomically(folder / "case.toml", results.input);
  io::write_atomically(folder / "springs.csv", springs_csv(results));
  io::write_atomically(folder / "soils.csv", buckpy_csv(results));
  const Words pictures = draw_all(results, folder);
  io::write_atomically(folder / page_file, page_html(results, pictures, folder));
  io::write_atomically(folder / "summary.json", summary_json(results));
}

std::string words_of_results(const RouteResults& results)
{
  std::string words;
  for (std::size_t k = 0; k < results.answer.size(); ++k) {
    words += fmt::format("{}, KP {:.3f} to {:.3f}\n", name_of(results, k), results.settings.section[k].from / 1000,
                         results.settings.section[k].to / 1000);
    for (const Quantity& q : quantities(results.answer[k]))
      words += fmt::format("  {:<24} {:>10.4g} {:<5} {}\n", q.name, q.value, q.unit, q.meaning);
  }
  for (const std::string& sentence : answer_in_words(results)) words += sentence + "\n";
  return words;
}

}  // namespace berm::route
