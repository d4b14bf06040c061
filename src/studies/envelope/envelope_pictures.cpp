// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_report.hpp"

#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "structures/structures.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::envelope {
namespace {

constexpr const char* of_probes = "points pt 7 ps 1.5 lc rgb '#1764ab'";
constexpr const char* of_swipe = "lines lw 2 lc rgb '#2f8f4e'";
constexpr const char* of_curve = "lines lw 2 lc rgb '#c8452f' dt '-'";
constexpr const char* of_code = "lines lw 2 lc rgb '#d08a00' dt '.'";
constexpr const char* of_points = "linespoints pt 9 ps 1.8 lw 2 lc rgb '#8155a6'";

constexpr const char* of_sections[] = {"points pt 7 ps 1.5 lc rgb '#1764ab'", "points pt 5 ps 1.5 lc rgb '#2f8f4e'"};

/// What the axes of all pictures share.
struct Shown {
  std::string title, method, force_words, moment_words;  ///< words: what follows a symbol
  Real force = 1, moment = 1;                            ///< what is drawn per N/m and N (in space N and N m)
};

Shown shown_for(const settings::Case& c, const base::PublishedEnvelope& published, const EnvelopeExtremes& extremes)
{
  const base::EmbeddedBody body = embedded_body(c);
  Shown shown;
  shown.title = fmt::format("{}: w/D = {:.3g}", c.title.empty() ? "Envelope" : c.title, body.embedment / body.width);
  shown.method = c.method == settings::Method::fem ? "fem" : "mpm";
  if (published.unit > 0) {
    shown.force = 1 / published.unit, shown.moment = 1 / (published.unit * body.width);
    shown.force_words = " / " + published.unit_name, shown.moment_words = " / " + published.unit_name + " / D";
  } else {
    const plot::PlotUnit unit = plot::force_unit(extremes.V_max, c.force_dimension());
    shown.force = shown.moment = unit.per_si;
    shown.force_words = fmt::format(" ({})", unit.name), shown.moment_words = fmt::format(" ({} m)", unit.name);
  }
  return shown;
}

/// Published curves of a plane, scaled; the x and y of a curve that is of another are empty.
void add_published(plot::Figure& figure, const std::vector<base::PublishedCurve>& curves, std::vector<Real> base::PublishedCurve::*x,
                   Real x_scale, std::vector<Real> base::PublishedCurve::*y, Real y_scale)
{
  for (const base::PublishedCurve& curve : curves) {
    if ((curve.*x).empty() || (curve.*y).empty()) continue;
    plot::FigureCurve drawn{curve.title, curve.of_code ? of_code : (curve.*x).size() > 2 ? of_curve : of_points, curve.*x, curve.*y};
    for (Real& value : drawn.x) value *= x_scale;
    for (Real& value : drawn.y) value *= y_scale;
    figure.curves.push_back(drawn);
  }
}

/// Ranges from zero with room above the curves (from -x where both signs are), and draws.
void draw_from_zero(plot::Figure figure, const std::filesystem::path& folder, const char* name, bool both_signs)
{
  Real x_most = 0, y_most = 0;
  for (const plot::FigureCurve& curve : figure.curves) {
    for (const Real x : curve.x) x_most = std::max(x_most, both_signs ? std::abs(x) : x);
    for (const Real y : curve.y) y_most = std::max(y_most, y);
  }
  figure.more = "set key inside bottom center vertical font ',11'\n";  // under the arch
  if (x_most > 0 && y_most > 0)
    figure.more += both_signs ? fmt::format("set xrange [-{0:.6g}:{0:.6g}]\nset yrange [0:{1:.6g}]\n", 1.06 * x_most, 1.1 * y_most)
                              : fmt::format("set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]\n", 1.06 * x_most, 1.1 * y_most);
  figure.width = 1000;
  figure.height = 680;
  draw_figure(folder, name, figure);
}

plot::Figure figure_of(const Shown& shown, std::string x, std::string y)
{
  plot::Figure figure;
  figure.title = shown.title;
  figure.x_label = std::move(x);
  figure.y_label = std::move(y);
  return figure;
}

/// The ends of probes and the paths of swipes in a plane.
template <class Takes>
void add_probes(plot::Figure& figure, const Shown& shown, const std::vector<EnvelopeRow>& rows, Real EnvelopePoint::*y, Real y_scale,
                const Takes& takes)
{
  plot::FigureCurve ends{fmt::format("berm ({}), ends of probes", shown.method), of_probes, {}, {}};
  plot::FigureCurve swipe{"berm, swipe", of_swipe, {}, {}};
  for (const EnvelopeRow& row : rows) {
    if (!takes(row.probe)) continue;
    ends.x.push_back(row.result.end.V * shown.force);
    ends.y.push_back(row.result.end.*y * y_scale);
    for (const EnvelopePoint& point : row.result.path) {
      swipe.x.push_back(point.V * shown.force);
      swipe.y.push_back(point.*y * y_scale);
    }
  }
  figure.curves.push_back(swipe);
  figure.curves.push_back(ends);
}

void draw_sections(const Shown& shown, const base::PublishedEnvelope& published, const std::vector<EnvelopeRow>& rows, Real V_max,
                   const std::filesystem::path& folder)
{
  plot::Figure figure = figure_of(shown, "H" + shown.force_words, "M" + shown.moment_words);
  add_published(figure, published.curves, &base::PublishedCurve::H, shown.force, &base::PublishedCurve::M, shown.moment);
  for (std::size_t k = 0; k < std::size(base::section_levels); ++k) {
    plot::FigureCurve points{
        fmt::format("berm ({}), swipes at V = {:g} Vmax", shown.method, base::section_levels[k]), of_sections[k], {}, {}};
    for (const EnvelopePoint& point : section_at(base::section_levels[k] * V_max, rows)) {
      points.x.push_back(point.H * shown.force);
      points.y.push_back(point.M * shown.moment);
    }
    figure.curves.push_back(points);
  }
  draw_from_zero(figure, folder, "sections", true);
}

}  // namespace

base::PublishedEnvelope published_for(const settings::Case& c, const std::vector<EnvelopeRow>& rows)
{
  base::EnvelopeEnds ends{{}, {}, extremes_of(rows).V_max};
  for (const EnvelopeRow& row : rows) {
    ends.V.push_back(row.result.end.V);
    ends.H.push_back(row.result.end.H);
  }
  return structures::structure_of(c).published_envelope(c, ends);
}

void draw_envelope(const settings::Case& c, const std::vector<EnvelopeRow>& rows, const std::filesystem::path& folder)
{
  const base::PublishedEnvelope published = published_for(c, rows);
  const EnvelopeExtremes extremes = extremes_of(rows);
  const Shown shown = shown_for(c, published, extremes);
  plot::Figure figure = figure_of(shown, "V" + shown.force_words, "H" + shown.force_words);
  add_published(figure, published.curves, &base::PublishedCurve::V, shown.force, &base::PublishedCurve::H, shown.force);
  add_probes(figure, shown, rows, &EnvelopePoint::H, shown.force, [](const Probe& probe) { return probe.turn == 0; });
  draw_from_zero(figure, folder, "envelope", false);
  if (!embedded_body(c).arm) return;
  plot::Figure moments = figure_of(shown, "V" + shown.force_words, "M" + shown.moment_words + " for H = 0");
  add_published(moments, published.curves, &base::PublishedCurve::V, shown.force, &base::PublishedCurve::M, shown.moment);
  add_probes(moments, shown, rows, &EnvelopePoint::M, shown.moment,
             [](const Probe& probe) { return probe.free_sideways || probe.angle == 90; });
  draw_from_zero(moments, folder, "moments", false);
  draw_sections(shown, published, rows, extremes.V_max, folder);
}

}  // namespace berm::envelope
