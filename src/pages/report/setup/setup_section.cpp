// SPDX-License-Identifier: BSD-3-Clause
#include "report/setup/setup_section.hpp"
#include "os/text_of_list.hpp"
#include "picture/model_picture.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::report {
namespace {

constexpr std::size_t max_open_drawings = 2;  // more than these are folded away

/// Runs that look the same.
struct Alike {
  std::string look;  ///< their drawing without a title
  const record::RunRecord* first;
  std::vector<std::string> names;
};

std::vector<Alike> alike(const std::vector<record::RunRecord>& runs)
{
  std::vector<Alike> groups;
  for (const record::RunRecord& run : runs) {
    const std::string look = picture::draw_on_page(run.settings, run.ground, "").svgs;
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Alike& group) { return group.look == look; });
    if (same == groups.end())
      groups.push_back({look, &run, {run.name}});
    else
      same->names.push_back(run.name);
  }
  return groups;
}

std::string figure_of(const Alike& group)
{
  const std::string names = text_of_list(group.names, ", ");
  const picture::PageDrawing drawing = picture::draw_on_page(group.first->settings, group.first->ground, "Drawing to scale: " + names);
  std::string words = fmt::format("<strong>{}</strong>, to scale.", text::html_text(names));
  for (const std::string& note : drawing.notes) words += fmt::format(" {}", text::html_text(note));
  return fmt::format("<figure>\n<div class=\"drawing\">\n{}</div>\n<figcaption>{}</figcaption>\n</figure>\n", drawing.svgs, words);
}

std::string drawings_of(const std::vector<record::RunRecord>& runs)
{
  std::string open, folded;
  const std::vector<Alike> groups = alike(runs);
  for (std::size_t k = 0; k < groups.size(); ++k) (k < max_open_drawings ? open : folded) += figure_of(groups[k]);
  const auto side_by_side = [](const std::string& figures) { return fmt::format("<div class=\"drawings\">\n{}</div>\n", figures); };
  if (folded.empty()) return side_by_side(open);
  return side_by_side(open) + fmt::format("<details><summary>Drawings of {} more</summary>\n{}</details>\n",
                                          groups.size() - max_open_drawings, side_by_side(folded));
}

}  // namespace

std::string setup_section(const std::vector<record::RunRecord>& runs)
{
  const std::string drawings = drawings_of(runs), table = compact_table(runs).html(), computation = computation_table(runs).html();
  // The table of one run has two columns: it stands beside the drawings.
  std::string content = runs.size() == 1
                            ? fmt::format("<div id=\"one-model\">\n<div>\n{}{}</div>\n{}</div>\n", drawings, computation, table)
                            : drawings + table;
  content += soil_over_depth(runs);
  content += fmt::format("<details class=\"for_screen everything\"><summary>All parameters</summary>\n{}</details>\n",
                         parameter_columns(runs).html());
  if (runs.size() > 1) content += computation;
  return text::html_section("model", "Model", content);
}

}  // namespace berm::report
