// SPDX-License-Identifier: BSD-3-Clause
#include "sea/sea_report.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "run_folder/build.hpp"
#include "sea/displacement_report.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::sea {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A number of the answer. Source: whose formula it is; "" a definition.
struct Quantity {
  const char* name;
  std::string symbol, meaning;
  Real value;
  const char* unit;
  std::string source;
  bool in_range = true;
};

template <class Get>
MeanAndScatter over_seeds(const SeaAnswer& a, const Get& get)
{
  std::vector<Real> values;
  for (const Extremes& extremes : a.extremes) values.push_back(get(extremes));
  return mean_and_scatter(values);
}

std::vector<Quantity> quantities(const SeaResults& results)
{
  const SeaCase& c = results.settings;
  const SeaAnswer& a = results.answer;
  const Dimensionless n = dimensionless(c, a);
  const Utilisation used = absolute_stability(c, a);
  const std::string waves = "linear waves", code = "DNV-RP-F109", morison = "Morison";
  const MeanAndScatter H = over_seeds(a, [](const Extremes&e) { return e.H; }),
                       V = over_seeds(a, [](const Extremes&e) { return e.least_V; }),
                       u = over_seeds(a, [](const Extremes&e) { return e.velocity; });
  std::vector<Quantity> all = {
      {"significant_height", "H_s", "significant wave height, of the spectrum", a.height, "m", ""},
      {"direction_factor", "R_D", "factor of the directions on the velocity", a.direction_factor, "1", waves},
      {"significant_velocity", "U_s", "significant velocity at the seabed, normal to the pipe", a.waves.velocity, "m/s", waves},
      {"mean_period", "T_u", "mean period of the velocity at the seabed", a.waves.period, "s", waves},
      {"current", "V_c", "mean current over the height of the pipe, normal to it", a.current, "m/s", code},
      {"design_velocity", "U*", "amplitude of the largest oscillation in the sea state", a.design.velocity.value, "m/s", code,
       a.design.velocity.valid},
      {"design_period", "T*", "its period", a.design.period.value, "s", code, a.design.period.valid},
      {"keulegan_carpenter", "K", "U_s T_u / D", n.K, "1", ""},
      {"current_ratio", "M", "V_c / U_s", n.M, "1", ""},
      {"acceleration_ratio", "N", "U_s / (g T_u)", n.N, "1", ""},
      {"weight_parameter", "L", "w_s / (rho D/2 U_s^2)", n.L, "1", ""},
      {"embedment", "w", "embedment of the pipe", a.embedment, "m",
       c.pipe.embedment || !c.bed.unit_weight ? "" : "Verley and Sotberg 1994"},
      {"horizontal_reduction", "r_y", "reduction factor of the horizontal load", a.left.horizontal.value, "1", code,
       a.left.horizontal.valid},
      {"vertical_reduction", "r_z", "reduction factor of the vertical load", a.left.vertical.value, "1", code, a.left.vertical.valid},
      {"peak_horizontal_coefficient", "C_Y*", "peak horizontal load coefficient", a.peak.horizontal.value, "1", code,
       a.peak.horizontal.valid},
      {"peak_vertical_coefficient", "C_Z*", "peak vertical load coefficient", a.peak.vertical.value, "1", code, a.peak.vertical.valid},
      {"peak_horizontal_load", "F_Y*", "peak horizontal load", a.horizontal, "N/m", code},
      {"peak_vertical_load", "F_Z*", "peak lift", a.vertical, "N/m", code},
      {"passive_resistance", "F_R", "passive resistance of sand at the peak lift", a.passive, "N/m", code},
      {"lateral_utilisation", "", "gamma_SC (F_Y* + mu F_Z*) / (mu w_s + F_R)", used.lateral, "1", code},
      {"vertical_utilisation", "", "gamma_SC F_Z* / w_s", used.vertical, "1", code},
      {"weight_for_half_diameter", "", "submerged weight with which it moves half a diameter at most, on sand", a.stable_weight.value,
       "N/m", code, a.stable_weight.valid},
      {"largest_velocity", "", "largest velocity of a realisation, mean", u.mean, "m/s", waves},
      {"largest_H", "", "largest |H| of a realisation, mean", H.mean, "N/m", morison},
      {"largest_H_deviation", "", "its standard deviation", H.deviation, "N/m", morison},
      {"least_V", "", "least V of a realisation, mean", V.mean, "N/m", morison},
  };
  if (a.shields) {
    all.push_back({"shields", "theta", "Shields parameter of the bed in a significant wave", a.shields->value, "1", "Soulsby 1997",
                   a.shields->valid});
    all.push_back({"critical_shields", "theta_cr", "threshold of motion of the sand", a.critical_shields->value, "1",
                   "Soulsby and Whitehouse 1997", a.critical_shields->valid});
  }
  if (results.moved) {
    const MovedPipe moved = moved_pipe(c, *results.moved);
    const std::string soil = "macro-element";
    all.insert(all.end(), {{"displacement", "", "largest displacement in a realisation, mean", moved.largest.mean, "m", soil},
                           {"displacement_deviation", "", "its standard deviation", moved.largest.deviation, "m", soil},
                           {"displacement_largest", "", "the largest of all realisations", moved.largest_of_all, "m", soil},
                           {"displacement_end", "", "displacement at the end of a realisation, mean", moved.end.mean, "m", soil},
                           {"half_cycle", "", "largest half-cycle displacement, mean", moved.half_cycle.mean, "m", soil},
                           {"largest_embedment", "", "largest embedment in a realisation, mean", moved.embedment.mean, "m", soil},
                           {"displacement_of_largest_waves", "", "largest displacement in the largest waves of seed 1",
                            moved.waves_of_first.largest, "m", soil}});
  }
  return all;
}

std::string title_of(const SeaResults& results)
{
  return results.settings.title.empty() ? "A sea state on a pipe" : results.settings.title;
}

std::vector<std::string> answer_in_words(const SeaResults& results)
{
  const SeaCase& c = results.settings;
  const SeaAnswer& a = results.answer;
  const Utilisation used = absolute_stability(c, a);
  std::vector<std::string> words = {
      fmt::format("In {:.3g} h of H_s = {:.3g} m in {:.3g} m of water the velocity at the seabed, normal to the pipe, is U_s = {:.3g} m/s "
                  "with a mean "
                  "period of {:.3g} s; the amplitude of the largest oscillation is {:.3g} m/s, the current {:.3g} m/s.",
                  c.sea.duration / 3600, a.height, c.sea.depth, a.waves.velocity, a.waves.period, a.design.velocity.value, a.current),
      fmt::format("By DNV-RP-F109 its peak loads are {:.3g} N/m across and {:.3g} N/m up, at a submerged weight of {:.4g} N/m: the pipe {} "
                  "(utilisation "
                  "{:.3g} lateral, {:.3g} vertical, at most 1).",
                  a.horizontal, a.vertical, c.pipe.weight,
                  used.lateral <= 1 && used.vertical <= 1 ? "has absolute lateral stability: it does not move"
                                                          : "has no absolute lateral stability: its displacement has to be computed",
                  used.lateral, used.vertical)};
  if (c.bed.unit_weight)
    words.push_back(fmt::format(
        "With {:.4g} N/m it would move half a diameter at most by the generalised method of DNV-RP-F109{}: {:.3g} of its weight.",
        a.stable_weight.value, a.stable_weight.valid ? "" : " (outside its range)", a.stable_weight.value / c.pipe.weight));
  const MeanAndScatter H = over_seeds(a, [](const Extremes& e) { return e.H; });
  words.push_back(fmt::format("By Morison's equation the largest |H| is {:.3g} N/m, {:.2g} N/m standard deviation over {} seeds.", H.mean,
                              H.deviation, a.extremes.size()));
  if (a.shields)
    words.push_back(
        fmt::format("In a significant wave the Shields parameter of the bed is {:.2g}, and sand of {:.3g} mm moves from {:.2g} on: {}.",
                    a.shields->value, 1e3 * *c.bed.grain_size, a.critical_shields->value,
                    a.shields->value > a.critical_shields->value
                        ? "the sediment is mobile, and scour, self-burial and backfill change the embedment, which berm does not compute"
                        : "the sediment is not mobile except at the pipe, where the flow is faster"));
  const auto lifted = std::count_if(a.extremes.begin(), a.extremes.end(), [](const Extremes& e) { return e.least_V <= 0; });
  if (lifted > 0)
    words.push_back(
        fmt::format("Lift is more than the weight in {} of {} realisations: the pipe leaves the seabed.", lifted, a.extremes.size()));
  words.emplace_back("Loads are those of a pipe at rest, with its embedment at the start: they decrease as it moves with the water.");
  if (results.moved)
    for (std::string& sentence : words_of(c, *results.moved)) words.push_back(std::move(sentence));
  return words;
}

std::string csv_of(const std::vector<WaveRow>& rows)
{
  std::string csv = "time_s,water_m_s\n";
  for (const WaveRow& row : rows) csv += fmt::format("{:.7g},{:.6g}\n", row.time, row.velocity);
  return csv;
}

std::string csv_of(const LoadRecord& record)
{
  std::string csv = "time_s,H_N_m,V_N_m\n";
  for (std::size_t row = 0; row < record.H.size(); ++row)
    csv += fmt::format("{:.7g},{:.6g},{:.6g}\n", record.time(row), record.H[row], record.V[row]);
  return csv;
}

std::string stage_toml(const SeaResults& results)
{
  const settings::WaterSettings water = water_of(results.settings);
  const std::string trench = water.trench_depth > 0 ? fmt::format("trench_depth = \"{:.6g} m\"\ntrench_angle = \"{:.6g} deg\"\n",
                                                                  water.trench_depth, water.trench_angle / degree)
                                                    : "";
  return fmt::format(
      "# The velocity of the water in the {} largest waves of seed 1, one after the other. The mass of the pipe is {:.4g} kg/m, with "
      "displaced water and added mass.\n[[stage]]\nname = \"storm\"\nkind = \"drag\"\nload_history = \"waves_1.csv\"\n\n[stage.water]\n"
      "density = \"{:.6g} kg/m^3\"\ndrag = {:.6g}\ninertia = {:.6g}\nlift = {:.6g}\nweight = \"{:.6g} N/m\"\npermeable = {}\n{}",
      results.settings.record.waves, mass_of(results.settings), water.density, water.drag, water.inertia, water.lift, water.weight,
      water.permeable, trench);
}

std::string storm_toml(const SeaResults& results)
{
  std::vector<std::string> cycles, loads;
  for (const LoadClass& of : load_classes(results.answer)) {
    cycles.push_back(fmt::format("{:.4g}", std::max(of.cycles, Real(1))));
    loads.push_back(fmt::format("\"{:.4g} N/m\"", of.load));
  }
  Real mean = 0, rows = 0;
  for (const LoadRecord& record : results.answer.records)
    for (const Real H : record.H) mean += H, ++rows;
  return fmt::format("# Parcels of berm cyclic: half the heights of the waves of H, mean over {} seeds; a class with less "
                     "than one cycle has 1.\n"
                     "[storm]\ncycles = [{}]\nload = [{}]\naverage_load = \"{:.4g} N/m\"\n",
                     results.answer.records.size(), fmt::join(cycles, ", "), fmt::join(loads, ", "), std::abs(mean / rows));
}

std::string summary_json(const SeaResults& results)
{
  Json all = {{"quantities", Json::object()},
              {"timing", {{"wall_s", results.wall_s}, {"steps", results.answer.records.size()}}},
              {"checks", {{"finished", true}}},
              {"text",
               {{"title", results.settings.title},
                {"version", BERM_VERSION},
                {"answer", fmt::format("{}", fmt::join(answer_in_words(results), " "))}}}};
  for (const Quantity& q : quantities(results))
    all["quantities"][q.name] = {
        {"value", q.value}, {"unit", q.unit}, {"meaning", q.meaning}, {"source", q.source}, {"in_range", q.in_range}};
  for (const auto& [name, words] : run_folder::this_build()) all["text"][name] = words;
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool draw_spectra(const SeaResults& results, const fs::path& folder)
{
  const formulas::WaveSpectrum& spectrum = *results.settings.spectrum;
  plot::Figure figure;
  figure.title = "Spectra of the elevation (m2/Hz) and of the velocity at the seabed (m2/s)";
  figure.x_label = "frequency (Hz)";
  figure.more = plot::from_zero;
  figure.width = 900, figure.height = 420;
  figure.curves = {{"elevation", plot::curve_style(0, 0), {}, {}}, {"velocity at the seabed", plot::curve_style(1, 0), {}, {}}};
  constexpr int points = 300;
  const Real last = std::min(spectrum.last(), 4 * spectrum.peak());
  for (int k = 0; k <= points; ++k) {
    const Real w = spectrum.first() + (last - spectrum.first()) * k / points, density = 2 * pi * spectrum.density(w);
    const Real velocity = results.answer.direction_factor * formulas::velocity_at_seabed(w, results.settings.sea.depth);
    for (plot::FigureCurve& curve : figure.curves) curve.x.push_back(w / (2 * pi));
    figure.curves[0].y.push_back(density);
    figure.curves[1].y.push_back(density * velocity * velocity);
  }
  return plot::draw_figure(folder, "spectrum", figure);
}

bool draw_waves(const std::vector<WaveRow>& rows, const fs::path& folder)
{
  plot::Figure figure;
  figure.title = "Loads on a pipe at rest in the largest waves of seed 1 (waves_1.csv)";
  figure.x_label = "time (s)";
  figure.y_label = "N/m";
  figure.more = "set key below\n";
  figure.width = 900, figure.height = 420;
  figure.curves = {{"H, across", plot::curve_style(0, 0), {}, {}}, {"V, submerged weight less lift", plot::curve_style(1, 0), {}, {}}};
  for (const WaveRow& row : rows) {
    for (plot::FigureCurve& curve : figure.curves) curve.x.push_back(row.time);
    figure.curves[0].y.push_back(row.H);
    figure.curves[1].y.push_back(row.V);
  }
  return plot::draw_figure(folder, "waves", figure);
}

std::string page_html(const SeaResults& results, bool spectra, bool waves, const fs::path& folder)
{
  std::string html = fmt::format("<h1>{}</h1>\n", text::html_text(title_of(results)));
  for (const std::string& sentence : answer_in_words(results)) html += text::html_paragraph(sentence);
  if (spectra) html += picture(folder, "spectrum", "spectra");
  if (waves) html += picture(folder, "waves", "loads over time");
  if (results.moved) html += displacement_section(results.settings, *results.moved, folder);
  html += "<h2>Numbers</h2>\n<table>\n" + text::plain_row({"", "", "value", "unit", "by"}, 2, 2, "th");
  for (const Quantity& q : quantities(results))
    html += text::plain_row({text::html_text(q.symbol), text::html_text(q.meaning), fmt::format("{:.4g}", q.value), q.unit,
                             q.source + (q.in_range ? "" : ", outside its range")},
                            2, 2, "td");
  html += "</table>\n<h2>Realisations</h2>\n<table>\n" +
          text::plain_row({"seed", "waves", "largest velocity (m/s)", "largest |H| (N/m)", "least V (N/m)"}, 0, 4, "th");
  for (std::size_t k = 0; k < results.answer.extremes.size(); ++k) {
    const Extremes& e = results.answer.extremes[k];
    html += text::plain_row({std::to_string(k + 1), std::to_string(e.waves), fmt::format("{:.3g}", e.velocity), fmt::format("{:.4g}", e.H),
                             fmt::format("{:.4g}", e.least_V)},
                            0, 4, "td");
  }
  html += "</table>\n<h2>Stage, to paste into a case</h2>\n<pre>" + text::html_text(stage_toml(results)) + "</pre>\n";
  html += "<h2>Parcels, for berm cyclic</h2>\n<pre>" + text::html_text(storm_toml(results)) + "</pre>\n";
  html += fmt::format("<h2>Input</h2>\n<pre>{}</pre>\n", text::html_text(results.input));
  html += fmt::format("<p class=\"quiet\">berm {}; all digits are in <a href=\"summary.json\">summary.json</a>.</p>\n", BERM_VERSION);
  return text::plain_page("berm: " + title_of(results), html);
}

}  // namespace

void write_results(const SeaResults& results, const fs::path& folder)
{
  const SeaAnswer& a = results.answer;
  io::make_folder(folder);
  constexpr int most_seeds = 100;
  std::error_code ignored;
  for (const char* old : {"spectrum.png", "waves.png", "track.png", "distribution.png"}) fs::remove(folder / old, ignored);
  for (int seed = 1; seed <= most_seeds; ++seed)
    for (const char* of : {"record", "waves", "track"}) fs::remove(folder / fmt::format("{}_{}.csv", of, seed), ignored);
  io::write_atomically(folder / "case.toml", results.input);
  io::write_atomically(folder / "stage.toml", stage_toml(results));
  io::write_atomically(folder / "storm.toml", storm_toml(results));
  std::vector<WaveRow> first;
  for (std::size_t k = a.records.size(); k-- > 0;) {
    const auto largest = largest_waves(a.waves_of_record[k], static_cast<std::size_t>(results.settings.record.waves));
    first = load_history_of(results.settings, a.records[k], largest);
    io::write_atomically(folder / fmt::format("record_{}.csv", k + 1), csv_of(a.records[k]));
    io::write_atomically(folder / fmt::format("waves_{}.csv", k + 1), csv_of(first));
  }
  if (results.moved)
    for (std::size_t k = 0; k < results.moved->seeds.size(); ++k)
      io::write_atomically(folder / fmt::format("track_{}.csv", k + 1), csv_of(results.moved->seeds[k]));
  const bool spectra = draw_spectra(results, folder), waves = draw_waves(first, folder);
  io::write_atomically(folder / page_file, page_html(results, spectra, waves, folder));
  io::write_atomically(folder / "summary.json", summary_json(results));
}

std::string words_of_results(const SeaResults& results)
{
  std::string words;
  for (const Quantity& q : quantities(results))
    words += fmt::format("  {:<5} {:>9.4g} {:<4} {}{}\n", q.symbol, q.value, q.unit, q.meaning,
                         q.source.empty() ? "" : fmt::format(" ({}{})", q.source, q.in_range ? "" : ", outside its range"));
  for (const std::string& sentence : answer_in_words(results)) words += sentence + "\n";
  return words;
}

}  // namespace berm::sea
