// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/depth/profile_test.cpp
#include "structures/depth/profile_page.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "plot/panels.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::depth {
namespace {

/// A panel of the picture: numbers in kN over depth, as steps or from level to level.
struct Panel {
  std::string label;
  std::vector<Real> value, depth;
};

/// The profiles of the last stage that has some.
std::vector<Profile> last_profiles(const record::RunRecord& run)
{
  std::vector<Profile> all = profiles(run);
  std::vector<Profile> last;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (k + 1 == all.size() || all[k + 1].body != all[k].body) last.push_back(std::move(all[k]));
  return last;
}

const char* per_depth(const Profile& p)
{
  return p.whole ? "kN/m" : "kPa";
}
const char* of_force(const Profile& p)
{
  return p.whole ? "kN" : "kN/m";
}

/// A slice's value from its upper to its lower end.
Panel steps_of(std::string label, const Profile& p, const std::vector<Real>& values)
{
  Panel panel{std::move(label), {}, {}};
  for (std::size_t k = 0; k < values.size(); ++k)
    for (const std::size_t end : {k, k + 1}) panel.value.push_back(values[k] / 1e3), panel.depth.push_back(p.level(end));
  return panel;
}

std::vector<Panel> panels_of(const Profile& p)
{
  std::vector<Panel> panels;
  if (!p.h.empty()) panels.push_back(steps_of(fmt::format("H on the soil per metre of depth, {}", per_depth(p)), p, p.h));
  panels.push_back(steps_of(fmt::format("V on the shaft per metre of depth, {}", per_depth(p)), p, p.v));
  Panel axial{fmt::format("axial force, from the base upwards, {}", of_force(p)), {}, {}};
  for (std::size_t k = 0; k < p.axial.size(); ++k) axial.value.push_back(p.axial[k] / 1e3), axial.depth.push_back(p.level(k));
  panels.push_back(std::move(axial));
  return panels;
}

/// Panels beside one another, depth downwards.
std::string svg_of(const Profile& p)
{
  plot::Panels all{.title = fmt::format("Forces of the soil on {} by depth", p.body),
                   .css_class = "depth_log",
                   .y_label = "depth below the bed, m",
                   .downwards = true,
                   .height = 320};
  for (const Panel& panel : panels_of(p)) {
    const auto [low, high] = std::minmax_element(panel.value.begin(), panel.value.end());
    const Real from = std::min(Real(0), *low), to = std::max(Real(0), *high);
    all.panels.push_back(
        {panel.label, from, to > from ? to : from + 1, 0, p.level(p.v.size()), {{"", plot::thick_style(0), panel.value, panel.depth}}});
  }
  return plot::svg_of(all);
}

std::string words_of(const Profile& p)
{
  constexpr Real round_off = 1e-9;
  const auto [low, high] = std::minmax_element(p.axial.begin(), p.axial.end());
  const Real nothing = round_off * std::max(std::abs(*low), std::abs(*high)), base = p.axial.back();
  const auto force = [&](Real newtons) { return text::force_words(newtons, p.whole ? 3 : 2); };
  const std::string at_base = std::abs(base) > nothing ? fmt::format(", base resistance {}", force(base)) : "";
  if (p.sideways || !(p.drag_load() > nothing))
    return text::html_paragraph(
        fmt::format("{} at the end of stage \"{}\": shaft friction {}{}.", p.body, p.stage, force(p.axial.front() - base), at_base));
  std::string words = fmt::format("At the end of stage \"{}\" the soil ", p.stage);
  words += fmt::format("drags {} down with {} above a neutral plane {} below the bed", p.body, force(p.drag_load()),
                       text::length_words(p.neutral_plane()));
  if (*high - base > nothing)
    words += fmt::format("; below it: shaft friction {}{}", force(*high - base), at_base);
  else if (!at_base.empty())
    words += at_base;
  return text::html_paragraph(words + ".");
}

std::string table_of(const Profile& p, const std::string& id)
{
  text::HtmlTable table(id, fmt::format("{}: forces of the soil by depth, at the end of stage \"{}\"", p.body, p.stage));
  std::vector<text::HtmlCell> header{{"depth below the bed, m"}};
  if (!p.h.empty()) header.push_back({fmt::format("H on the soil, {}", per_depth(p)), true});
  header.push_back({fmt::format("V on the shaft, {}", per_depth(p)), true});
  header.push_back({fmt::format("axial force, from the base upwards, {}", of_force(p)), true});
  table.columns(header);
  const auto number = [](Real value) { return text::HtmlCell{text::table_number(value / 1e3), true}; };
  for (std::size_t k = 0; k < p.v.size(); ++k) {
    std::vector<text::HtmlCell> cells{{fmt::format("{} to {}", text::table_number(p.level(k)), text::table_number(p.level(k + 1)))}};
    if (!p.h.empty()) cells.push_back(number(p.h[k]));
    cells.push_back(number(p.v[k]));
    cells.push_back(number(p.axial[k]));
    table.row(cells);
  }
  std::vector<text::HtmlCell> base{{"base"}};
  if (!p.h.empty()) base.push_back({""});
  base.push_back({""});
  base.push_back(number(p.axial.back()));
  table.row(base);
  return table.html();
}

}  // namespace

std::string profile_csv(const record::RunRecord& run)
{
  std::string text, header;
  for (const Profile& p : profiles(run)) {
    header = p.whole ? "body,stage,z_top_m,z_bottom_m,H_N_m,V_N_m,axial_top_N,axial_bottom_N\n"
                     : "body,stage,z_top_m,z_bottom_m,H_Pa,V_Pa,axial_top_N_m,axial_bottom_N_m\n";
    for (std::size_t k = 0; k < p.v.size(); ++k)
      text += fmt::format("{},{},{:.6g},{:.6g},{},{:.6g},{:.6g},{:.6g}\n", p.body, p.stage, p.level(k), p.level(k + 1),
                          p.h.empty() ? "" : fmt::format("{:.6g}", p.h[k]), p.v[k], p.axial[k], p.axial[k + 1]);
  }
  return header + text;
}

std::string tz_csv(const record::RunRecord& run)
{
  std::string text, header;
  for (const TzCurve& curve : tz_curves(run)) {
    header = curve.whole ? "body,stage,z_m,w_m,t_N_m\n" : "body,stage,z_m,w_m,t_Pa\n";
    for (std::size_t k = 0; k < curve.w.size(); ++k)
      text += fmt::format("{},{},{:.6g},{:.6g},{:.6g}\n", curve.body, curve.stage, curve.z, curve.w[k], curve.t[k]);
  }
  return header + text;
}

void write_files(const run_folder::RunFolder& folder, const record::RunRecord& run)
{
  if (const std::string csv = profile_csv(run); !csv.empty()) io::write_atomically(folder.file("depth_profile.csv"), csv);
  if (const std::string csv = tz_csv(run); !csv.empty()) io::write_atomically(folder.file("tz.csv"), csv);
}

std::string profile_section(const record::RunRecord& run, const std::string& id)
{
  std::string html;
  for (const Profile& p : last_profiles(run)) html += words_of(p) + svg_of(p) + table_of(p, fmt::format("{}-depth-{}", id, p.body));
  return html;
}

namespace {

/// The picture as SVG and PNG for a run after the other. Gives the names of what was drawn.
std::vector<std::string> draw_profiles(const base::Runs& runs, const base::PublishedPoints&, const std::filesystem::path& folder)
{
  std::vector<std::string> drawn;
  const auto draw = [&](const std::string& name, plot::Figure figure, const std::vector<Panel>& panels,
                        const std::vector<const char*>& names) {
    for (std::size_t k = 0; k < panels.size(); ++k)
      figure.curves.push_back({names[k], plot::curve_style(k, k), panels[k].value, panels[k].depth});
    if (draw_png_and_svg(folder, name, figure)) drawn.push_back(name);
  };
  for (const auto& [run, n] : runs)
    for (const Profile& p : last_profiles(*run)) {
      std::vector<Panel> panels = panels_of(p);
      plot::Figure figure{fmt::format("{}: forces of the soil on {} by depth", run->name, p.body),
                          per_depth(p),
                          "depth below the bed (m)",
                          {},
                          "set yrange [*:*] reverse\nset key below\n"};
      const std::string body = record::file_name_of(p.body);
      if (!p.h.empty()) {
        draw(fmt::format("depth_profile_H_{}_{}", body, n), figure, {panels.front()}, {"H on the soil"});
        panels.erase(panels.begin());
      }
      figure.x_label = fmt::format("{} (V), {} (axial force)", per_depth(p), of_force(p));
      draw(fmt::format("depth_profile_{}_{}", body, n), figure, panels, {"V on the shaft", "axial force, from the base upwards"});
    }
  return drawn;
}

}  // namespace

base::Reading reading()
{
  return {.write_files = write_files, .other_results = profile_section, .draw_report_curves = draw_profiles};
}

}  // namespace berm::depth
