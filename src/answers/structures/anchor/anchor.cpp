// SPDX-License-Identifier: BSD-3-Clause
#include "structures/anchor/anchor.hpp"

#include "plot/figure.hpp"
#include "structures/base/answer_table.hpp"
#include "structures/driven/driven.hpp"
#include "structures/driven/report.hpp"
#include "text/html.hpp"
#include "text/quantity_words.hpp"

#include <fmt/format.h>

namespace berm::anchor {
namespace {

constexpr int width = 1000, height = 520;  // pixels

/// Of a body that was not dragged, but pulled out, say, what any driven body has.
std::string words_of(const record::RunRecord& run, const base::DisplayUnits& shown)
{
  const TowResults r = tow_results(tow_path(run), base::body_scale(run));
  if (!std::isfinite(r.travel)) return driven::results_in_words(driven::DrivenRun(run), shown);
  const std::string name = text::html_text(base::body_word(run.settings));
  const int dimension = run.settings.force_dimension();
  const auto length = [](Real metres) { return text::length_words(metres); };
  const std::string goes_on =
      std::abs(r.depth_change) < 0.05 * std::max(std::abs(r.depth), r.last_travel)
          ? "at a constant depth"
          : fmt::format("still moving {} {}", length(std::abs(r.depth_change)), r.depth_change > 0 ? "deeper" : "up");
  return fmt::format(
      "Dragged {}, the lowest point of the {} moves from a depth of {} to {}; it was deepest, {}, after {}. The tow force is "
      "{} at most, after {}, and {} on average over the last "
      "{}, with V = {}; {}.",
      length(r.travel), name, length(r.first_depth), length(r.depth), length(r.max_depth), length(r.at_depth),
      text::force_words(r.max_force, dimension), length(r.at_force), text::force_words(r.force, dimension), length(r.last_travel),
      text::force_words(r.vertical, dimension), goes_on);
}

std::string table_of(const base::Runs& runs, const base::DisplayUnits&)
{
  base::AnswerTable table({"anchor-tow", "Tow"}, runs.front().record->settings.force_dimension(), tow_answers);
  for (const auto& [record, number] : runs) table.add(record->name, *record, "");
  return table.html({{"run"}});
}

std::vector<std::string> draw_depth(const base::Runs& runs, const base::PublishedPoints&, const std::filesystem::path& folder)
{
  plot::Figure depth{"Depth of the lowest point over travel",     "travel (m)", "depth (m)", {},
                     "set key below\nset yrange [*:*] reverse\n", width,        height};
  for (const auto& [record, number] : runs) {
    const TowPath path = tow_path(*record);
    if (path.travel.empty()) continue;
    depth.curves.push_back({record->name, plot::curve_style(number, number), path.travel, path.depth});
  }
  const bool drawn = !depth.curves.empty() && draw_png_and_svg(folder, "anchor_depth", depth);
  return drawn ? std::vector<std::string>{"anchor_depth"} : std::vector<std::string>{};
}

}  // namespace

/// An anchor, plough or grapnel that is dragged through the bed: depth of its lowest point and tow force over travel, beside what any driven body has, such as the uplift
/// resistance of a plate that is pulled out. It is named in the input.
base::Structure anchor()
{
  using Run = const record::RunRecord&;
  base::Reading travels = driven::reading();
  travels.words = {}, travels.quality_note = {};
  return {"anchor",
          {{.answers =
                [](Run run, const std::vector<Real>&) {
                  base::AnswerList list(run.settings.force_dimension());
                  list.of("drags", "");
                  list.add(tow_answers, tow_results(tow_path(run), base::body_scale(run)));
                  return list.list();
                },
            .names =
                [](const settings::Case&) {
                  base::AnswerList list(3);
                  list.add_names(tow_answers);
                  return list.names();
                },
            .headline =
                [](Run, const base::DisplayUnits&) {
                  return base::Headline{{"tow_force_max", "Largest tow force"}, {"tow_depth_max", "Largest depth"}};
                },
            .words = words_of,
            .key_results = table_of,
            .draw_report_curves = draw_depth},
           travels}};
}

}  // namespace berm::anchor
