// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/sea/displacement_test.cpp
#include "sea/displacement_report.hpp"

#include "plot/figure.hpp"
#include "text/html.hpp"
#include "text/plain_page.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::sea {
namespace {

template <class Get>
std::vector<Real> values_of(const SeaCase& c, const std::vector<Track>& tracks, const Get& get)
{
  std::vector<Real> values;
  for (const Track& track : tracks) values.push_back(get(numbers_of(track, c.pipe.diameter)));
  return values;
}

void add_curve(plot::Figure& figure, const std::string& name, const Track& track)
{
  plot::FigureCurve curve{name, plot::curve_style(static_cast<int>(figure.curves.size()), 0), track.time, {}};
  for (const Real u : track.u) curve.y.push_back(u - track.u.front());
  figure.curves.push_back(std::move(curve));
}

/// Of the runs, beside the macro-element in the same waves; of the whole of each seed where there are none.
bool draw_tracks(const Displacements& moved, const std::filesystem::path& folder)
{
  plot::Figure figure;
  figure.title = moved.runs.empty() ? "Displacement on the macro-element, by seed" : "Displacement in the largest waves";
  figure.x_label = "time (s)";
  figure.y_label = "u (m)";
  figure.more = "set key below\n";
  figure.width = 900, figure.height = 420;
  if (moved.runs.empty()) {
    constexpr std::size_t most = 10;
    for (std::size_t k = 0; k < std::min(most, moved.seeds.size()); ++k) add_curve(figure, fmt::format("seed {}", k + 1), moved.seeds[k]);
  } else {
    std::vector<int> seeds;
    for (const RunBeside& run : moved.runs) {
      add_curve(figure, fmt::format("{} ({}), seed {}", run.name, run.method, run.seed), run.track);
      if (std::ranges::find(seeds, run.seed) == seeds.end()) seeds.push_back(run.seed);
    }
    for (const int seed : seeds)
      add_curve(figure, fmt::format("macro-element, seed {}", seed), moved.waves[static_cast<std::size_t>(seed) - 1]);
  }
  return plot::draw_figure(folder, "track", figure);
}

bool draw_distribution(std::vector<Real> largest, const std::filesystem::path& folder)
{
  plot::Figure figure;
  figure.title = "Largest displacement of a realisation: fraction of the seeds below it, (i - 0.3)/(n + 0.4)";
  figure.x_label = "largest displacement (m)";
  figure.y_label = "probability";
  figure.more = plot::from_zero;
  figure.width = 900, figure.height = 340;
  std::ranges::sort(largest);
  plot::FigureCurve curve{"seeds", plot::curve_style(0, 0), largest, {}};
  for (std::size_t k = 0; k < largest.size(); ++k)
    curve.y.push_back((static_cast<Real>(k) + 0.7) / (static_cast<Real>(largest.size()) + 0.4));
  figure.curves = {std::move(curve)};
  return plot::draw_figure(folder, "distribution", figure);
}

std::vector<std::string> cells_of(const std::string& name, const std::string& waves, const TrackNumbers& n, Real D)
{
  return {text::html_text(name),
          waves,
          fmt::format("{:.3g}", n.largest),
          fmt::format("{:.3g}", n.largest / D),
          fmt::format("{:.3g}", n.half_cycle),
          fmt::format("{:.3g}", n.end),
          fmt::format("{:.3g}", n.largest_w)};
}

}  // namespace

MeanAndScatter mean_and_scatter(const std::vector<Real>& values)
{
  const auto n = static_cast<Real>(values.size());
  MeanAndScatter found;
  for (const Real value : values) found.mean += value / n;
  for (const Real value : values) found.deviation += std::pow(value - found.mean, 2) / (n - 1);
  found.deviation = n < 2 ? nan : std::sqrt(found.deviation);
  return found;
}

MovedPipe moved_pipe(const SeaCase& c, const Displacements& moved)
{
  const std::vector<Real> largest = values_of(c, moved.seeds, [](const TrackNumbers& n) { return n.largest; });
  return {.largest = mean_and_scatter(largest),
          .end = mean_and_scatter(values_of(c, moved.seeds, [](const TrackNumbers& n) { return n.end; })),
          .half_cycle = mean_and_scatter(values_of(c, moved.seeds, [](const TrackNumbers& n) { return n.half_cycle; })),
          .embedment = mean_and_scatter(values_of(c, moved.seeds, [](const TrackNumbers& n) { return n.largest_w; })),
          .largest_of_all = std::ranges::max(largest),
          .waves_of_first = numbers_of(moved.waves.front(), c.pipe.diameter)};
}

std::vector<std::string> words_of(const SeaCase& c, const Displacements& moved)
{
  const Real D = c.pipe.diameter;
  const MovedPipe n = moved_pipe(c, moved);
  std::vector<std::string> words = {fmt::format(
      "On its macro-element, with the loads of its own velocity and embedment, the pipe moves {:.3g} m ({:.3g} D) at most in a realisation "
      "of {:.3g} h: mean of {} seeds, standard deviation {:.2g} m, largest {:.3g} m; its embedment is {:.3g} m then ({:.2g} s for all "
      "seeds).",
      n.largest.mean, n.largest.mean / D, c.sea.duration / 3600, moved.seeds.size(), n.largest.deviation, n.largest_of_all,
      n.embedment.mean, moved.wall_s)};
  for (const RunBeside& run : moved.runs) {
    const TrackNumbers of_run = numbers_of(run.track, D), of_element = numbers_of(moved.waves[static_cast<std::size_t>(run.seed) - 1], D);
    words.push_back(fmt::format("In the {} largest waves of seed {} it moves {:.3g} m by {} ({}), {:.3g} m by the macro-element.",
                                c.record.waves, run.seed, of_run.largest, run.method, run.name, of_element.largest));
  }
  return words;
}

std::string picture(const std::filesystem::path& folder, const char* name, const char* alt)
{
  return "<div class=\"pictures\">" + plot::html_image(folder, name, alt) + "</div>\n";
}

std::string displacement_section(const SeaCase& c, const Displacements& moved, const std::filesystem::path& folder)
{
  const Real D = c.pipe.diameter;
  std::string html = "<h2>Displacement</h2>\n";
  if (draw_tracks(moved, folder)) html += picture(folder, "track", "displacement over time");
  if (moved.seeds.size() > 2 && draw_distribution(values_of(c, moved.seeds, [](const TrackNumbers& n) { return n.largest; }), folder))
    html += picture(folder, "distribution", "distribution of the largest displacement");
  html += "<table>\n" +
          text::plain_row({"", "waves", "largest |u| (m)", "/ D", "largest half-cycle (m)", "at the end (m)", "largest embedment (m)"}, 2,
                          6, "th");
  const auto row = [&](const std::string& name, const std::string& waves, const Track& track) {
    html += text::plain_row(cells_of(name, waves, numbers_of(track, D), D), 2, 6, "td");
  };
  for (std::size_t k = 0; k < moved.seeds.size(); ++k) row("macro-element", fmt::format("seed {}, all", k + 1), moved.seeds[k]);
  for (std::size_t k = 0; k < moved.waves.size(); ++k)
    row("macro-element", fmt::format("seed {}, {} largest", k + 1, c.record.waves), moved.waves[k]);
  for (const RunBeside& run : moved.runs)
    row(fmt::format("{}: {}", run.name, run.method), fmt::format("seed {}, {} largest", run.seed, c.record.waves), run.track);
  return html + "</table>\n";
}

std::string csv_of(const Track& track)
{
  std::string csv = "time_s,u_m,w_m\n";
  for (std::size_t row = 0; row < track.time.size(); ++row)
    csv += fmt::format("{:.7g},{:.6g},{:.6g}\n", track.time[row], track.u[row], track.w[row]);
  return csv;
}

}  // namespace berm::sea
