// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/structures/depth/profile_test.cpp
#include "structures/depth/profile_page.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::depth {
namespace {

constexpr Real panel_width = 300, panel_height = 320, left = 74, gap = 40, top = 58, room = 20;  // of the picture, in its units

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

std::string label_at(Real x, Real y, const char* anchor, const std::string& text)
{
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, text::html_text(text));
}

std::string line(Real x1, Real y1, Real x2, Real y2, const char* color)
{
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" style=\"stroke:var(--{});stroke-width:1\"/>\n", x1, y1,
                     x2, y2, color);
}

std::string svg_of(const Panel& panel, Real deepest, Real x0)
{
  const auto [low, high] = std::minmax_element(panel.value.begin(), panel.value.end());
  const Real from = std::min(Real(0), *low), to = std::max(Real(0), *high), width = to > from ? to - from : 1;
  const auto across = [&](Real value) { return x0 + (value - from) / width * panel_width; };
  const auto down = [&](Real depth) { return top + depth / deepest * panel_height; };
  std::string svg = label_at(x0 + panel_width / 2, top - 34, "middle", panel.label);
  const Real step = plot::tic_step(width);
  for (Real tic = std::ceil(from / step - 1e-9) * step; tic <= from + width * (1 + 1e-9); tic += step)
    svg += line(across(tic), top, across(tic), top + panel_height, std::abs(tic) < 1e-9 * step ? "quiet" : "grid") +
           label_at(across(tic), top - 8, "middle", text::short_number(std::abs(tic) < 1e-9 * step ? 0 : tic));
  for (Real depth = 0; depth <= deepest * (1 + 1e-9); depth += plot::tic_step(deepest))
    svg += line(x0, down(depth), x0 + panel_width, down(depth), "grid");
  std::string points;
  for (std::size_t k = 0; k < panel.value.size(); ++k)
    points += fmt::format("{:.1f},{:.1f} ", across(panel.value[k]), down(panel.depth[k]));
  return svg + fmt::format("<polyline points=\"{}\" style=\"fill:none;stroke:{};stroke-width:2\"/>\n", points, plot::curve_color(0));
}

/// Panels beside one another, depth downwards.
std::string svg_of(const Profile& p)
{
  const std::vector<Panel> panels = panels_of(p);
  const Real count = static_cast<Real>(panels.size()), width = left + count * panel_width + (count - 1) * gap + room,
             deepest = p.level(p.v.size());
  std::string svg = fmt::format(
      "<figure class=\"depth_log\"><svg viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" style=\"max-width:100%;height:auto;font:13px "
      "sans-serif;fill:var(--text)\" role=\"img\">\n<title>Forces of the soil on {} by depth</title>\n",
      width, top + panel_height + room, width, text::html_text(p.body));
  for (std::size_t k = 0; k < panels.size(); ++k) svg += svg_of(panels[k], deepest, left + static_cast<Real>(k) * (panel_width + gap));
  for (Real depth = 0; depth <= deepest * (1 + 1e-9); depth += plot::tic_step(deepest))
    svg += label_at(left - 7, top + depth / deepest * panel_height + 4, "end", text::short_number(depth));
  svg += fmt::format("<text transform=\"translate(18 {:.0f}) rotate(-90)\" text-anchor=\"middle\">depth below the bed, m</text>\n",
                     top + panel_height / 2);
  return svg + "</svg></figure>\n";
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

std::vector<std::string> draw_profiles(const std::vector<record::RunRecord>& runs, const std::filesystem::path& folder)
{
  std::vector<std::string> drawn;
  const auto draw = [&](const std::string& name, plot::Figure figure, const std::vector<Panel>& panels,
                        const std::vector<const char*>& names) {
    for (std::size_t k = 0; k < panels.size(); ++k)
      figure.curves.push_back({names[k], plot::curve_style(k, k), panels[k].value, panels[k].depth});
    if (draw_png_and_svg(folder, name, figure)) drawn.push_back(name);
  };
  for (std::size_t n = 0; n < runs.size(); ++n)
    for (const Profile& p : last_profiles(runs[n])) {
      std::vector<Panel> panels = panels_of(p);
      plot::Figure figure{fmt::format("{}: forces of the soil on {} by depth", runs[n].name, p.body),
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

}  // namespace berm::depth
