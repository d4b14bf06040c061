// SPDX-License-Identifier: BSD-3-Clause
#include "cpt/cpt_report.hpp"

#include "formulas/cone.hpp"
#include "io/atomic_file.hpp"
#include "os/control_characters.hpp"
#include "plot/figure.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::cpt {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A quantity of a row, in the unit in which it is written.
struct Quantity {
  const char* name;
  const char* symbol;
  Real Reading::*of;
  Real unit;  ///< SI
  const char* unit_name;
  const char* source;
};

constexpr Quantity quantities[] = {
    {"q_t", "q_t", &Reading::q_t, 1e6, "MPa", ""},
    {"f_s", "f_s", &Reading::f_s, 1e3, "kPa", ""},
    {"u_2", "u_2", &Reading::u_2, 1e3, "kPa", ""},
    {"B_q", "B_q", &Reading::B_q, 1, "1", ""},
    {"Q_tn", "Q_tn", &Reading::Q_tn, 1, "1", "Robertson 2009"},
    {"F_r", "F_r", &Reading::F_r, 0.01, "%", ""},
    {"I_c", "I_c", &Reading::I_c, 1, "1", "Robertson 2009"},
    {"unit_weight", "gamma", &Reading::gamma, 1e3, "kN/m3", "Robertson and Cabal 2010"},
    {"relative_density", "D_r", &Reading::D_r, 1, "1", "Jamiolkowski and others 2001"},
    {"undrained_strength", "s_u", &Reading::s_u, 1e3, "kPa", "(q_t - sigma_v0)/N_kt"},
    {"friction_angle", "phi", &Reading::phi, degree, "deg", "as of berm new --cpt, 45 deg at most"},
    {"young_modulus", "E", &Reading::E, 1e6, "MPa", "Robertson 2009"},
};

/// A number in a table: "" where there is none.
std::string number(Real value, Real unit)
{
  return std::isnan(value) ? "" : fmt::format("{:.4g}", value / unit);
}

std::string column(const Quantity& q)
{
  const std::string unit = q.unit_name;
  return unit == "1" ? q.name : fmt::format("{}_{}", q.name, unit == "%" ? "percent" : unit == "kN/m3" ? "kN_m3" : unit);
}

std::string profile_csv(const Profile& profile)
{
  std::string csv = "depth_m";
  for (const Quantity& q : quantities) csv += "," + column(q);
  csv += ",zone\n";
  for (const Reading& row : profile.rows) {
    csv += fmt::format("{:.6g}", row.depth);
    for (const Quantity& q : quantities) csv += "," + number(row.*q.of, q.unit);
    csv += fmt::format(",{}\n", row.zone);
  }
  return csv;
}

std::string layers_csv(const Profile& profile)
{
  std::string csv = "top_m,base_m,zone,soil";
  for (const Quantity& q : quantities) csv += fmt::format(",{0},{0}_deviation", column(q));
  csv += "\n";
  for (const Layer& layer : profile.layers) {
    csv += fmt::format("{:.4g},{:.4g},{},{}", layer.top, layer.base, layer.zone, formulas::name_of_zone(layer.zone));
    for (const Quantity& q : quantities) {
      const Mean mean = mean_of(profile, layer, q.of);
      csv += fmt::format(",{},{}", number(mean.value, q.unit), number(mean.deviation, q.unit));
    }
    csv += "\n";
  }
  return csv;
}

std::string summary_json(const CptResults& results)
{
  Json layers = Json::array();
  for (const Layer& layer : results.profile.layers) {
    Json of = {{"top_m", layer.top}, {"base_m", layer.base}, {"zone", layer.zone}, {"soil", formulas::name_of_zone(layer.zone)}};
    for (const Quantity& q : quantities) {
      const Mean mean = mean_of(results.profile, layer, q.of);
      of[column(q)] = {{"mean", mean.value / q.unit}, {"deviation", mean.deviation / q.unit}};
    }
    layers.push_back(of);
  }
  return Json{{"layers", layers},
              {"doubts", results.profile.doubts},
              {"text", {{"sounding", site::rows_of(results.sounding)}, {"version", BERM_VERSION}}}}
             .dump(2, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

/// A quantity over depth; the limits of the layers across it.
bool draw(const CptResults& results, const Quantity& q, const fs::path& folder)
{
  plot::Figure figure;
  figure.title = q.symbol;
  figure.x_label = std::string(q.unit_name) == "1" ? " " : q.unit_name;  // panels of one height
  figure.y_label = "depth (m)";
  figure.more = "set nokey\nset termoption noenhanced\nset yrange [0:*] reverse\n";
  figure.width = 330, figure.height = 620;
  plot::FigureCurve curve{"", plot::curve_style(0, 0, 1.5), {}, {}};
  Real least = 0, most = 0;
  for (const Reading& row : results.profile.rows) {
    curve.x.push_back(row.*q.of / q.unit);
    curve.y.push_back(row.depth);
    if (!std::isnan(curve.x.back())) least = std::min(least, curve.x.back()), most = std::max(most, curve.x.back());
  }
  const bool index = std::string(q.name) == "I_c";
  if (index) most = std::max(most, Real(4)), figure.more += "set xrange [0:*]\n";
  plot::FigureCurve limits{"", "lines dt 2 lc rgb '#808080'", {}, {}}, zones{"", "lines lc rgb '#c0c0c0'", {}, {}};
  for (const Layer& layer : results.profile.layers) {
    for (const Real x : {least, most, nan}) limits.x.push_back(x), limits.y.push_back(layer.base);
    if (index)
      figure.more +=
          fmt::format("set label \"{}\" at 0.1,{:.4g} left front\n", formulas::name_of_zone(layer.zone), (layer.top + layer.base) / 2);
  }
  if (index)
    for (const Real end : formulas::zone_ends)
      for (const Real z : {Real(0), results.profile.layers.back().base, nan}) zones.x.push_back(end), zones.y.push_back(z);
  figure.curves = {limits, curve};
  if (index) figure.curves.insert(figure.curves.begin(), zones);
  return plot::draw_figure(folder, q.name, figure);
}

std::string page_html(const CptResults& results, const std::string& pictures)
{
  std::string html =
      "<h1>Layers of a CPT sounding</h1>\n" +
      text::html_paragraph(fmt::format("{}; {}. N_kt = {:.3g}; layers of {:.3g} m and more.", site::rows_of(results.sounding),
                                       results.sounding.corrected, results.choice.N_kt, results.choice.thinnest));
  for (const std::string& doubt : results.profile.doubts) html += text::html_paragraph("Warning: " + doubt + ".");
  html += "<div class=\"pictures\">" + pictures + "</div>\n<h2>Layers</h2>\n<table>\n";
  std::vector<std::string> head = {"from (m)", "to (m)", "soil behaviour"};
  for (const Quantity& q : quantities) head.push_back(fmt::format("{} ({})", q.symbol, q.unit_name));
  html += text::plain_row(head, 3, head.size() - 1, "th");
  for (const Layer& layer : results.profile.layers) {
    std::vector<std::string> cells = {fmt::format("{:.2f}", layer.top), fmt::format("{:.2f}", layer.base),
                                      fmt::format("{}: {}", layer.zone, formulas::name_of_zone(layer.zone))};
    for (const Quantity& q : quantities) cells.push_back(number(mean_of(results.profile, layer, q.of).value, q.unit));
    html += text::plain_row(cells, 3, cells.size() - 1, "td");
  }
  html += "</table>\n<p>Means over the rows; their scatter is in layers.csv.</p>\n<h2>Correlations</h2>\n<table>\n";
  for (const Quantity& q : quantities)
    if (*q.source != '\0') html += text::plain_row({q.symbol, q.source}, 2, 2, "td");
  html += "</table>\n<p>Within the first half metre the effective stress is very low: I_c, D_r and phi there depend on the zero reading "
          "of the cone as much as on the soil.</p>\n<h2>To paste into a case</h2>\n<pre>" +
          text::html_text(layers_toml(results)) + "</pre>\n";
  return text::plain_page("berm: layers of a CPT sounding", html);
}

}  // namespace

std::string layers_toml(const CptResults& results)
{
  std::string text = fmt::format("# From {}: layers of soil behaviour type (Robertson 2009), means of each. E of clay is 500 s_u: <-\n",
                                 one_line(site::rows_of(results.sounding))),
              more;
  int n = 0;
  for (const Layer& layer : results.profile.layers) {
    const auto mean = [&](Real Reading::*of) { return mean_of(results.profile, layer, of).value; };
    const std::string name = fmt::format("layer_{}", ++n);
    if (n > 1) more += fmt::format("{}{{ top = \"{:.2f} m\", material = \"{}\" }}", more.empty() ? "" : ", ", layer.top, name);
    text +=
        fmt::format("\n[material.{}]\n# {:.2f} to {:.2f} m: {}, I_c = {:.2f}, q_t = {:.3g} MPa, F_r = {:.2g} %{}\nlaw = \"mohr_coulomb\"\n"
                    "submerged_unit_weight = \"{:.2f} kN/m^3\"\n",
                    name, layer.top, layer.base, formulas::name_of_zone(layer.zone), mean(&Reading::I_c), mean(&Reading::q_t) / 1e6,
                    100 * mean(&Reading::F_r), layer.sand() ? fmt::format(", D_r = {:.2f}", mean(&Reading::D_r)) : "",
                    (mean(&Reading::gamma) - site::gamma_w) / 1000);
    if (layer.sand())
      text += fmt::format("young_modulus = \"{:.3g} MPa\"\npoisson_ratio = 0.3\nfriction_angle = \"{:.1f} deg\"\ncohesion = \"0 Pa\"\n",
                          mean(&Reading::E) / 1e6, mean(&Reading::phi) / degree);
    else
      text += fmt::format("young_modulus = \"{:.3g} MPa\"\npoisson_ratio = 0.49\nfriction_angle = \"0 deg\"\ncohesion = \"{:.3g} kPa\"\n",
                          500 * mean(&Reading::s_u) / 1e6, mean(&Reading::s_u) / 1000);
  }
  return text + "\n# In the body:\n# material = \"layer_1\"\n" + (more.empty() ? "" : fmt::format("# soil_layer = [{}]\n", more));
}

void write_results(const CptResults& results, const fs::path& folder)
{
  io::make_folder(folder);
  io::write_atomically(folder / "profile.csv", profile_csv(results.profile));
  io::write_atomically(folder / "layers.csv", layers_csv(results.profile));
  io::write_atomically(folder / "layers.toml", layers_toml(results));
  std::string pictures;
  for (const Quantity& q : quantities) {
    const std::string name = q.name;
    std::error_code ignored;
    fs::remove(folder / (name + ".png"), ignored);
    const bool shown = name == "q_t" || name == "F_r" || name == "I_c" || (name == "B_q" && !results.sounding.u_2.empty());
    if (shown && draw(results, q, folder)) pictures += plot::html_image(folder, name, fmt::format("{} against depth", q.symbol));
  }
  io::write_atomically(folder / page_file, page_html(results, pictures));
  io::write_atomically(folder / "summary.json", summary_json(results));
}

std::string words_of_results(const CptResults& results)
{
  std::string words = fmt::format("{}; {}\n  from (m)  to (m)  I_c   gamma (kN/m3)  s_u (kPa)  phi (deg)  soil behaviour\n",
                                  site::rows_of(results.sounding), results.sounding.corrected);
  for (const Layer& layer : results.profile.layers) {
    const auto of = [&](Real Reading::*quantity, Real unit) {
      const Real value = mean_of(results.profile, layer, quantity).value;
      return std::isnan(value) ? std::string("-") : fmt::format("{:.3g}", value / unit);
    };
    words += fmt::format("  {:>8.2f}  {:>6.2f}  {:<4}  {:>13}  {:>9}  {:>9}  {}: {}\n", layer.top, layer.base, of(&Reading::I_c, 1),
                         of(&Reading::gamma, 1e3), layer.sand() ? "-" : of(&Reading::s_u, 1e3),
                         layer.sand() ? of(&Reading::phi, degree) : "-", layer.zone, formulas::name_of_zone(layer.zone));
  }
  return words;
}

}  // namespace berm::cpt
