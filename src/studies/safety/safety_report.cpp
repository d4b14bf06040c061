// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/safety/find_safety_test.cpp
#include "safety/safety_report.hpp"

#include "io/atomic_file.hpp"
#include "io/duration_text.hpp"
#include "os/text_of_list.hpp"
#include "text/base64_zlib.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::safety {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string cell(Real value)
{
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

std::string metres(Real value)
{
  return std::isfinite(value) ? fmt::format("{:.3g} m", value) : "";
}

std::string wall_time(Real value)
{
  return std::isfinite(value) ? io::duration_text(value) : "";
}

std::string title_of(const settings::Case& settings)
{
  return settings.title.empty() ? "Factor of safety" : settings.title;
}

/// Whether at least two trials that went on to the end without failing by their displacement, with factors that differ by a fifth or more, moved by the same to a fiftieth.
bool moves_alike(const std::vector<Trial>& trials)
{
  constexpr Real differs = 1.2, same = 0.02;
  Real least_factor = infinity, most_factor = 0, least = infinity, most = 0;
  for (const Trial& trial : trials) {
    if (trial.end == TrialEnd::stands || !(trial.movement < trial.limit)) continue;
    least_factor = std::min(least_factor, trial.factor), most_factor = std::max(most_factor, trial.factor);
    least = std::min(least, trial.movement), most = std::max(most, trial.movement);
  }
  return most_factor >= differs * least_factor && most - least <= same * most;
}

std::string summary_json(const settings::Case& settings, const std::vector<Trial>& trials, bool finished)
{
  const Bracket bracket = bracket_of(trials);
  const auto number = [](const std::optional<Real>& value, const char* meaning) -> Json {
    return {{"value", value ? Json(*value) : Json()}, {"unit", "1"}, {"meaning", meaning}};
  };
  const std::optional<Real> middle =
      bracket.stands && bracket.fails ? std::optional<Real>((*bracket.stands + *bracket.fails) / 2) : std::nullopt;
  Json all = {{"quantities",
               {{"factor_of_safety", number(middle, "the mean of the next two")},
                {"factor_that_stands", number(bracket.stands, "the largest factor, below the next, at which the soil stands")},
                {"factor_that_fails", number(bracket.fails, "the smallest factor at which it fails")}}},
              {"checks", {{"finished", finished}, {"undecided_between", bracket.undecided.size()}}}};
  Json list = Json::array();
  for (const Trial& trial : trials) {
    list.push_back({{"factor", trial.factor},
                    {"end", word_of(trial.end)},
                    {"movement_m", trial.movement},
                    {"movement_limit_m", trial.limit},
                    {"wall_s", trial.wall_s}});
    if (!trial.why.empty()) list.back()["why"] = trial.why;
  }
  all["trials"] = list;
  all["warnings"] = doubts_of(trials, settings.method);
  all["text"] = {{"title", settings.title}, {"answer", answer_in_words(trials)}, {"version", BERM_VERSION}};
  return all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string trials_html(const std::vector<Trial>& trials)
{
  std::string html =
      "<table>\n" + text::plain_row({"F", "the soil", "largest displacement", "has failed from", "wall time", ""}, 0, 4, "th");
  for (const Trial& trial : trials)
    html += text::plain_row({fmt::format("<a href=\"runs/{}\">{:.4f}</a>", trial_name(trial.factor), trial.factor), word_of(trial.end),
                             metres(trial.movement), metres(trial.limit), wall_time(trial.wall_s), text::html_text(trial.why)},
                            0, 4, "td");
  return html + "</table>\n";
}

std::string picture_html(const fs::path& file, const std::string& caption)
{
  std::error_code error;
  if (!fs::exists(file, error)) return "";
  return fmt::format("<figure><img src=\"data:image/png;base64,{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
                     text::base64(io::read_text_file(file)), text::html_text(caption), text::html_text(caption));
}

std::string definition_html(const settings::Case& settings)
{
  std::string html =
      "<p>F is the factor by which the strength of the soil is divided, from the start of the first stage: cohesion, tan(friction "
      "angle), "
      "undrained strength and tension cut-off of every soil, tan(friction angle), adhesion and tension of its interfaces. The stiffness "
      "and the dilation angle are not reduced; the dilation angle is at most the reduced friction angle. Clay has its strength at the "
      "reference "
      "rate.</p>\n"
      "<p>The soil <b>fails</b> where a point of it moves farther than the displacement in the table, in a stage that moves no body: a "
      "hundredth of the height that can slide plus twice the compression of elastic soil of that height under its weight and loads, unless "
      "safety.movement is given.  ";
  html += settings.method == settings::Method::fem
              ? "It also fails where the finite elements do not reach equilibrium, or where more than a tenth of the displacement occurs "
                "in the last half of the last stage while the soil yields: at small strain soil that flows does not stop. Soil that moves "
                "and yields nowhere is consolidating: it stands. Soil that yields too little to flow, and is still moving, is undecided."
              : "Larger displacements make the slope flatter, and a slide comes to rest: soil at rest at the end may have failed.";
  return html + " It <b>stands</b> where it has not failed and is at rest at the end of the last stage.</p>\n";
}

std::string page_html(const settings::Case& settings, const std::vector<Trial>& trials, const std::vector<std::string>& figures,
                      const fs::path& folder)
{
  const Bracket bracket = bracket_of(trials);
  std::string html =
      fmt::format("<h1>{}</h1>\n<p><b>{}</b></p>\n", text::html_text(title_of(settings)), text::html_text(answer_in_words(trials)));
  for (const std::string& doubt : doubts_of(trials, settings.method))
    html += fmt::format("<p class=\"warning\">{}</p>\n", text::html_text(doubt));
  html += "<h2>Trials</h2>\n" + trials_html(trials);
  html += "<h2>Definition of failure</h2>\n" + definition_html(settings);
  std::string pictures;
  for (const std::string& figure : figures)
    pictures +=
        picture_html(folder / (figure + ".png"), figure == "movement" ? "Displacement against the factor" : "Displacement over time");
  if (!pictures.empty()) html += fmt::format("<h2>Displacement</h2>\n<div class=\"pictures\">\n{}</div>\n", pictures);
  std::string soil;
  const auto add = [&](const std::optional<Real>& factor, const char* words) {
    if (factor)
      soil += picture_html(folder / "runs" / trial_name(*factor) / "soil.png", fmt::format("F = {:.4f}: the soil {}", *factor, words));
  };
  add(bracket.fails, "fails");
  add(bracket.stands, "stands");
  if (!soil.empty()) html += fmt::format("<h2>Mechanism</h2>\n<div class=\"pictures\">\n{}</div>\n", soil);
  html +=
      fmt::format("<p class=\"quiet\">berm {}, {}. All digits are in <a href=\"safety.csv\">safety.csv</a> and <a "
                  "href=\"summary.json\">summary.json</a>; a trial is a run like any other: berm report runs/F_... makes its page.</p>\n",
                  BERM_VERSION, settings.method == settings::Method::fem ? "finite elements" : "material point method");
  return text::plain_page("berm: " + title_of(settings), html);
}

}  // namespace

std::string trial_name(Real factor)
{
  return fmt::format("F_{:.4f}", factor);
}

std::string safety_csv(const std::vector<Trial>& trials)
{
  std::string csv = "factor,end,movement_m,movement_limit_m,wall_s\n";
  for (const Trial& trial : trials)
    csv += fmt::format("{},{},{},{},{}\n", trial.factor, word_of(trial.end), cell(trial.movement), cell(trial.limit), cell(trial.wall_s));
  return csv;
}

std::string answer_in_words(const std::vector<Trial>& trials)
{
  const Bracket bracket = bracket_of(trials);
  const auto at = [&](Real factor) {
    return *std::find_if(trials.begin(), trials.end(), [&](const Trial& t) { return t.factor == factor; });
  };
  std::string words;
  if (bracket.stands && bracket.fails)
    words = fmt::format(
        "F = {:.4g} to {:.4g}: the soil stands with its strength divided by {:.4g} (it moves by {}) and fails with it divided by {:.4g}",
        *bracket.stands, *bracket.fails, *bracket.stands, metres(at(*bracket.stands).movement), *bracket.fails);
  else if (bracket.fails)
    words = fmt::format("F is below {:.4g}, where the soil still fails", *bracket.fails);
  else if (bracket.stands)
    words = fmt::format("F is above {:.4g}, where the soil still stands", *bracket.stands);
  else
    words = "no trial shows whether the soil stands or fails";
  if (bracket.fails && *bracket.fails <= 1) words += "; F is below 1: it fails with its own strength";
  if (!bracket.undecided.empty()) words += fmt::format("; undecided: {}", text_of_list(bracket.undecided, ", "));
  if (!bracket.stands_above.empty())
    words += fmt::format("; yet it stands at {}, which is doubtful: compare the histories", text_of_list(bracket.stands_above, ", "));
  return words;
}

std::vector<std::string> doubts_of(const std::vector<Trial>& trials, settings::Method method)
{
  std::vector<std::string> doubts;
  Real time_factor = nan;
  for (const Trial& trial : trials) time_factor = std::fmin(time_factor, trial.time_factor);
  if (time_factor < 1)
    doubts.push_back(fmt::format("the water of the soil still flows when the last stage ends: c_v T / H2 is {:.2g}, H being the depth of "
                                 "the soil, and its pressures are steady from 1 on. Give the last stage {:.2g} times "
                                 "its time, or take it as the factor at that moment",
                                 time_factor, 1 / time_factor));
  const Bracket bracket = bracket_of(trials);
  if (!bracket.stands && bracket.fails && *bracket.fails <= min_factor)
    doubts.push_back(fmt::format("the soil fails even with {:g} times its strength, which no slope or footing does: check supports, loads "
                                 "and units before its strength",
                                 1 / min_factor));
  if (moves_alike(trials))
    doubts.push_back("the soil moves by the same amount whatever its strength, so this is not failure: water still flows, or loads still "
                     "change. Give the last stage more time");
  if (!trials.empty() && method == settings::Method::mpm)
    doubts.push_back("the factor of the material point method is too large on coarse cells: a vertical cut with 20 cells over its height "
                     "gives 6 % more than the exact factor, and half of that with cells half as large. Take method = \"fem\" (1.7 % "
                     "there), or two cell sizes, and extrapolate to zero");
  return doubts;
}

std::string safety_words(const std::vector<Trial>& trials)
{
  std::string words = fmt::format("{:>8}  {:<10} {:>14} {:>14} {:>10}\n", "F", "the soil", "movement (m)", "failed at (m)", "wall (s)");
  const auto number = [](Real value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : std::string("-"); };
  for (const Trial& trial : trials)
    words += fmt::format("{:>8.4f}  {:<10} {:>14} {:>14} {:>10}{}\n", trial.factor, word_of(trial.end), number(trial.movement),
                         number(trial.limit), number(trial.wall_s), trial.why.empty() ? "" : "  " + trial.why);
  return words + answer_in_words(trials) + "\n";
}

void write_safety_report(const settings::Case& settings, const std::vector<Trial>& trials, const fs::path& folder, bool finished)
{
  io::write_atomically(folder / "safety.csv", safety_csv(trials));
  io::write_atomically(folder / "summary.json", summary_json(settings, trials, finished));
  const std::vector<std::string> figures = draw_safety(trials, folder, title_of(settings));
  io::write_atomically(folder / "safety.html", page_html(settings, trials, figures, folder));
}

}  // namespace berm::safety
