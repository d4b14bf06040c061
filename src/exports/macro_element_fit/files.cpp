// SPDX-License-Identifier: BSD-3-Clause
#include "macro_element_fit/files.hpp"

#include "io/atomic_file.hpp"
#include "io/revision.hpp"
#include "macro_element/parameters.hpp"
#include "macro_element_fit/fmu.hpp"
#include "plot/figure.hpp"
#include "structures/base/invalid_answer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::macro_element_fit {
namespace {

using Json = nlohmann::ordered_json;

/// A number as JSON has it: none is null.
Json number(Real value)
{
  return std::isnan(value) ? Json() : Json(value);
}

std::string percent(Real value)
{
  return std::isnan(value) ? "-" : fmt::format("{:.1f} %", 100 * value);
}

/// The run and the macro-element over the same numbers.
void draw_pair(const std::filesystem::path& folder, const std::string& name, const Comparison& c, const std::string& x_label,
               const std::string& y_label, const std::vector<Real>& run_x, const std::vector<Real>& run_y, const std::vector<Real>& x,
               const std::vector<Real>& y, const char* more, std::vector<std::string>& drawn)
{
  plot::Figure figure;
  figure.title = fmt::format("{}, {}", c.path.name, c.fitted ? "fitted" : "not fitted");
  figure.x_label = x_label;
  figure.y_label = y_label;
  figure.more = std::string("set key below\n") + more;
  figure.curves = {{"run", "lines lc rgb '#a0a0a0' lw 3", run_x, run_y}, {"macro-element", plot::curve_style(1, 0, 2), x, y}};
  if (plot::draw_figure(folder, name, figure)) drawn.push_back(name + ".png");
}

void draw(const std::filesystem::path& folder, const Comparison& c, std::vector<std::string>& drawn)
{
  const Real D = c.path.diameter;
  std::vector<Real> u, w, H, V;
  for (const PathPoint& p : c.path.points) u.push_back(p.u / D), w.push_back(p.w / D), H.push_back(p.H / 1000), V.push_back(p.V / 1000);
  const std::vector<Real> w_of = plot::scaled(c.response.w, 1 / D), H_of = plot::scaled(c.response.H, 1e-3),
                          V_of = plot::scaled(c.response.V, 1e-3);
  const std::string name = record::file_name_of(c.path.name);
  if (!std::isnan(c.misfit.H)) draw_pair(folder, name + ".H", c, "u / D", "H (kN/m)", u, H, u, H_of, "", drawn);
  if (!std::isnan(c.misfit.H)) draw_pair(folder, name + ".w", c, "u / D", "w / D", u, w, u, w_of, "set yrange [] reverse\n", drawn);
  draw_pair(folder, name + ".V", c, "w / D", "V (kN/m)", w, V, w_of, V_of, "", drawn);
}

/// Why the answers of runs are not to be used, a line each.
std::vector<std::string> invalid_lines(const std::vector<Comparison>& comparisons)
{
  std::vector<std::string> lines;
  for (const Comparison& c : comparisons)
    for (std::string& line : base::invalid_lines(c.path.name, c.path.invalid, c.fitted ? "what is fitted to it" : "it as a check"))
      lines.push_back(std::move(line));
  return lines;
}

}  // namespace

Comparison compare(const Parameters& parameters, Path path, bool fitted)
{
  Response response = follow(parameters, path);
  const Misfit misfit = misfit_of(path, response);
  return {std::move(path), fitted, std::move(response), misfit};
}

std::string json_of(const Parameters& p, const std::vector<Comparison>& comparisons)
{
  Json all;
  all["written_by"] = "berm " + io::version_words();
  all["model"] = "macro-element of a pipe on the seabed, plane strain, per metre of pipe";
  all.update(macro_element::json_of(p));
  for (const Comparison& c : comparisons) {
    Json run = {{"name", c.path.name},
                {"folder", c.path.run.string()},
                {"fitted", c.fitted},
                {"invalid", c.path.invalid},
                {"points", c.path.points.size()}};
    run["rms_H_over_largest"] = number(c.misfit.H);
    run["largest_H_over_largest_of_run"] = number(c.misfit.largest);
    run["rms_w_over_D"] = number(c.misfit.w);
    run["rms_V_over_largest"] = number(c.misfit.V);
    run["end_w_difference_over_D"] = number(c.misfit.end);
    all["runs"].push_back(run);
  }
  return all.dump(2) + "\n";
}

std::string code_of(const Parameters& p, const std::vector<Comparison>& comparisons)
{
  std::string text(code_c), invalid;
  for (std::string line : invalid_lines(comparisons)) {
    std::erase(line, '*');  // nothing may end the comment
    invalid += "\n   " + line;
  }
  text +=
      fmt::format("\n/* Fitted by berm {}.{} */\nconst berm_macro_element_parameters berm_macro_element_fitted = {{\n  .version = {},\n",
                  io::version_words(), invalid, p.version);
  for (const berm_macro_element_member& m : berm_macro_element_members)
    text += fmt::format("  .{} = {:.17g},\n", m.name, macro_element::value_of(p, m));
  text += fmt::format("  .backbone_points = {},\n", p.backbone_points);
  for (const auto& [name, values] : {std::pair{"backbone_w", p.backbone_w}, std::pair{"backbone_V", p.backbone_V}}) {
    text += fmt::format("  .{} = {{", name);
    for (int k = 0; k < p.backbone_points; ++k) text += fmt::format("{}{:.17g}", k > 0 ? ", " : "", values[k]);
    text += p.backbone_points > 0 ? "},\n" : "0},\n";
  }
  return text + "};\n";
}

std::string table_of(const std::vector<Comparison>& comparisons)
{
  std::size_t width = 4;
  for (const Comparison& c : comparisons) width = std::max(width, c.path.name.size());
  std::string text = fmt::format("{:<{}}  {:<10}  {:>12}  {:>12}  {:>10}  {:>12}  {:>14}\n", "run", width, "", "rms H", "largest H",
                                 "rms w", "rms V", "w at its end");
  text += fmt::format("{:<{}}  {:<10}  {:>12}  {:>12}  {:>10}  {:>12}  {:>14}\n", "", width, "", "of largest", "less run's", "of D",
                      "of largest", "less run's");
  for (const Comparison& c : comparisons)
    text += fmt::format("{:<{}}  {:<10}  {:>12}  {:>12}  {:>10}  {:>12}  {:>12} D\n", c.path.name, width,
                        c.fitted ? "fitted" : "not fitted", percent(c.misfit.H), percent(c.misfit.largest - 1), percent(c.misfit.w),
                        percent(c.misfit.V), fmt::format("{:+.3f}", c.misfit.end));
  for (const std::string& line : invalid_lines(comparisons)) text += line + "\n";
  return text;
}

std::vector<std::string> write_files(const std::filesystem::path& folder, const Parameters& parameters,
                                     const std::vector<Comparison>& comparisons)
{
  io::make_folder(folder);
  std::vector<std::string> names = {"macro_element.json", "macro_element.h", "macro_element.c", "macro_element.fmi2.fmu",
                                    "macro_element.fmi3.fmu"};
  io::write_atomically(folder / names[0], json_of(parameters, comparisons));
  io::write_atomically(folder / names[1], code_h);
  io::write_atomically(folder / names[2], code_of(parameters, comparisons));
  io::write_atomically(folder / names[3], fmu_of(parameters, 2));
  io::write_atomically(folder / names[4], fmu_of(parameters, 3));
  for (const Comparison& c : comparisons) draw(folder, c, names);
  return names;
}

}  // namespace berm::macro_element_fit
