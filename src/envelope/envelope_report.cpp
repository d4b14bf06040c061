// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/envelope/envelope_test.cpp
#include "envelope/envelope_report.hpp"

#include "io/atomic_file.hpp"
#include "plot/figure.hpp"
#include "plot/gnuplot.hpp"
#include "structures/structures.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace berm::envelope {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* of_probes = "points pt 7 ps 1.5 lc rgb '#1764ab'";
constexpr const char* of_swipe = "lines lw 2 lc rgb '#2f8f4e'";
constexpr const char* of_curve = "lines lw 2 lc rgb '#c8452f' dt '-'";
constexpr const char* of_points = "linespoints pt 9 ps 1.8 lw 2 lc rgb '#8155a6'";

/// NaN becomes null.
Json number(Real value, const char* unit)
{
  return {{"value", value}, {"unit", unit}};
}

/// What is published of the structure, for the ends of the probes.
base::PublishedEnvelope published_for(const problem::Case& c, const std::vector<EnvelopeRow>& rows)
{
  base::EnvelopeEnds ends{{}, {}, extremes_of(rows).V_max};
  for (const EnvelopeRow& row : rows) {
    ends.V.push_back(row.result.end.V);
    ends.H.push_back(row.result.end.H);
  }
  return structures::structure_of(c).published_envelope(c, ends);
}

std::string summary_json(const problem::Case& c, const std::vector<EnvelopeRow>& rows)
{
  const EnvelopeExtremes extremes = extremes_of(rows);
  const base::PublishedEnvelope published = published_for(c, rows);
  const base::EmbeddedBody body = embedded_body(c);
  Json quantities = {{"w_over_D", number(body.embedment / body.width, "1")},
                     {"V_max", number(extremes.V_max, "N/m")},
                     {"H_max", number(extremes.H_max, "N/m")},
                     {"V_over_V_max_at_H_max", number(extremes.V_at_H_max / extremes.V_max, "1")}};
  if (published.unit > 0) {
    quantities["V_max_over_unit"] = number(extremes.V_max / published.unit, "1");
    quantities["H_max_over_unit"] = number(extremes.H_max / published.unit, "1");
    quantities["unit"] = number(published.unit, "N/m");
  }
  Json all = {{"quantities", quantities}, {"published", Json::object()}};
  for (const base::PublishedNumber& known : published.numbers) {
    const formulas::Source& source = known.formula.source;
    all["published"][known.name] = {{"value", known.formula.value},   {"unit", known.name.starts_with("parabola") ? "1" : "N/m"},
                                    {"label", word_of(source.label)}, {"source", citation(source)},
                                    {"range", source.range},          {"in_range", known.formula.valid}};
  }
  Json states = Json::object();
  for (const EnvelopeRow& row : rows) states[row.probe.name] = row.state;
  all["probes"] = states;
  all["text"] = {{"title", c.title}, {"version", BERM_VERSION}};
  if (!published.remark.empty()) all["text"]["remark"] = published.remark;
  return all.dump(2) + "\n";
}

void draw(const problem::Case& c, const std::vector<EnvelopeRow>& rows, const std::filesystem::path& folder)
{
  const base::PublishedEnvelope published = published_for(c, rows);
  const base::EmbeddedBody body = embedded_body(c);
  const EnvelopeExtremes extremes = extremes_of(rows);
  const plot::PlotUnit shown =
      published.unit > 0 ? plot::PlotUnit{1 / published.unit, ""} : plot::force_unit(extremes.V_max, c.force_dimension());
  const std::string unit = published.unit > 0 ? " / " + published.unit_name : fmt::format(" ({})", shown.name);
  plot::Figure figure;
  figure.title = fmt::format("{}: w/D = {:.3g}", c.title.empty() ? "Envelope" : c.title, body.embedment / body.width);
  figure.x_label = "V" + unit;
  figure.y_label = "H" + unit;
  plot::FigureCurve ends{fmt::format("berm ({}), ends of probes", c.method == problem::Method::fem ? "fem" : "mpm"), of_probes, {}, {}};
  plot::FigureCurve swipe{"berm, swipe", of_swipe, {}, {}};
  for (const EnvelopeRow& row : rows) {
    ends.x.push_back(row.result.end.V * shown.per_si);
    ends.y.push_back(row.result.end.H * shown.per_si);
    for (const EnvelopePoint& point : row.result.path) {
      swipe.x.push_back(point.V * shown.per_si);
      swipe.y.push_back(point.H * shown.per_si);
    }
  }
  for (const base::PublishedCurve& curve : published.curves) {
    plot::FigureCurve drawn{curve.title, curve.V.size() > 2 ? of_curve : of_points, curve.V, curve.H};
    for (Real& V : drawn.x) V *= shown.per_si;
    for (Real& H : drawn.y) H *= shown.per_si;
    figure.curves.push_back(drawn);
  }
  figure.curves.push_back(swipe);
  figure.curves.push_back(ends);
  Real V_most = 0, H_most = 0;
  for (const plot::FigureCurve& curve : figure.curves) {
    for (const Real V : curve.x) V_most = std::max(V_most, V);
    for (const Real H : curve.y) H_most = std::max(H_most, H);
  }
  figure.more = "set key inside bottom center vertical font ',11'\n";  // under the arch
  if (V_most > 0 && H_most > 0) figure.more += fmt::format("set xrange [0:{:.6g}]\nset yrange [0:{:.6g}]\n", 1.06 * V_most, 1.1 * H_most);
  figure.width = 1000;
  figure.height = 680;
  draw_figure(folder, "envelope", figure);
}

}  // namespace

void write_envelope_report(const problem::Case& c, const std::vector<EnvelopeRow>& rows, const std::filesystem::path& folder)
{
  io::write_atomically(folder / "envelope.csv", envelope_csv(rows));
  io::write_atomically(folder / "summary.json", summary_json(c, rows));
  draw(c, rows, folder);
}

std::string envelope_words(const problem::Case& c, const std::vector<EnvelopeRow>& rows)
{
  const base::PublishedEnvelope published = published_for(c, rows);
  const EnvelopeExtremes extremes = extremes_of(rows);
  std::string text = fmt::format("{:<18} {:>11} {:>11} {:>8} {:>8} {:>8}\n", "probe", "V (N/m)", "H (N/m)", "V/Vmax", "H/Hmax", "growth");
  for (const EnvelopeRow& row : rows) {
    const ProbeResult& r = row.result;
    if (row.state == "finished")
      text += fmt::format("{:<18} {:>11.5g} {:>11.5g} {:>8.3f} {:>8.3f} {:>7.2f}%\n", row.probe.name, r.end.V, r.end.H,
                          r.end.V / extremes.V_max, r.end.H / extremes.H_max, 100 * r.growth);
    else
      text += fmt::format("{:<18} {}\n", row.probe.name, row.state);
  }
  const std::string unit = published.unit > 0 ? fmt::format(" = {:.4g} and {:.4g} times {:.5g} N/m", extremes.V_max / published.unit,
                                                            extremes.H_max / published.unit, published.unit)
                                              : "";
  text += fmt::format("Vmax {:.5g} N/m, Hmax {:.5g} N/m{}\n", extremes.V_max, extremes.H_max, unit);
  for (const base::PublishedNumber& known : published.numbers)
    text += fmt::format("published: {} = {:.5g} [{}: {}{}]\n", known.name, known.formula.value, word_of(known.formula.source.label),
                        citation(known.formula.source),
                        known.formula.valid ? "" : fmt::format("; out of range: {}", known.formula.source.range));
  if (!published.remark.empty()) text += published.remark + "\n";
  return text;
}

}  // namespace berm::envelope
