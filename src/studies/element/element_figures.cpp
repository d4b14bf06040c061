// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/element/element_report_test.cpp
#include "element/element_report.hpp"

#include "plot/figure.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace berm::element {
namespace {

using Records = std::vector<const TestRecord*>;
using Reading = std::function<Real(const TestRecord&, const TestRow&)>;

constexpr const char* of_strength = "lines lw 1.5 lc rgb '#8a929a' dt '-'";
constexpr Real kilo = 1e-3, percent = 100;

bool shears(const TestRecord& record)
{
  return std::holds_alternative<SimpleShear>(record.settings.kind);
}

std::string style_of(std::size_t k)
{
  return plot::curve_style(k, k / plot::curve_colors);
}

plot::FigureCurve curve_of(const TestRecord& record, const std::string& style, const Reading& x, const Reading& y)
{
  plot::FigureCurve curve{record.settings.name, style, {}, {}};
  for (const TestRow& row : record.rows) {
    curve.x.push_back(x(record, row));
    curve.y.push_back(y(record, row));
  }
  return curve;
}

plot::Figure figure_of(const Records& records, const std::string& what, const Reading& x, const Reading& y)
{
  std::string kind = kind_word(records.front()->settings.kind);
  std::replace(kind.begin(), kind.end(), '_', ' ');
  plot::Figure figure;
  figure.title = fmt::format("{}: {}", kind, what);
  for (std::size_t k = 0; k < records.size(); ++k) figure.curves.push_back(curve_of(*records[k], style_of(k), x, y));
  figure.more = "set key below font ',11'\nset offsets 0, 0, graph 0.05, 0\nset yrange [*<0:*]\n";
  figure.width = 720;
  figure.height = 500;
  return figure;
}

Real driven_percent(const TestRecord& record, const TestRow& row)
{
  return percent * driven_strain(record.settings, row);
}

const char* strain_label(const Records& records)
{
  return shears(*records.front()) ? "shear strain (%)" : "axial strain (%)";
}

/// What the law allows in place of what is drawn over the strain.
Real allowed(const TestRecord& record, const TestRow& row)
{
  const Real t = strength(record, row).value_or(nan) * kilo;
  const auto* triaxial = std::get_if<Triaxial>(&record.settings.kind);
  const auto* biaxial = std::get_if<Biaxial>(&record.settings.kind);
  const Direction direction = triaxial != nullptr ? triaxial->direction : biaxial != nullptr ? biaxial->direction : Direction::compression;
  return (shears(record) ? 1 : 2) * (direction == Direction::compression ? t : -t);
}

plot::Figure stress_strain(const Records& records)
{
  const bool shear = shears(*records.front());
  plot::Figure figure = figure_of(records, "stress and strain", driven_percent, [shear](const TestRecord&, const TestRow& row) {
    return kilo * (shear ? shear_stress(row) : deviator_stress(row));
  });
  figure.x_label = strain_label(records);
  figure.y_label = shear ? "shear stress tau (kPa)" : "q (kPa)";
  for (std::size_t k = 0; k < records.size(); ++k) {
    plot::FigureCurve& curve = figure.curves.emplace_back(curve_of(*records[k], of_strength, driven_percent, allowed));
    curve.title = k == 0 ? "strength of the law" : "";
  }
  return figure;
}

/// The strength of each material over the pressures of the figure.
void add_strengths(plot::Figure& figure, const Records& records, bool triaxial)
{
  Real most = 0;
  for (const plot::FigureCurve& curve : figure.curves) most = std::max(most, plot::largest_size(curve.x));
  std::vector<std::pair<std::string, Direction>> done;
  for (const TestRecord* record : records) {
    const auto* kind = std::get_if<Triaxial>(&record->settings.kind);
    const std::pair<std::string, Direction> key{record->settings.material, kind != nullptr ? kind->direction : Direction::compression};
    if (std::find(done.begin(), done.end(), key) != done.end()) continue;
    const auto same = [&](const auto& other) { return other.first == key.first; };
    const bool first = std::find_if(done.begin(), done.end(), same) == done.end();
    plot::FigureCurve line{first ? "strength of " + record->settings.material : "", of_strength, {}, {}};
    constexpr int points = 50;
    for (int n = 0; n <= points; ++n) {
      const Real pressure = most * n / points / kilo;
      const std::optional<Real> t = triaxial ? triaxial_strength(*record, pressure, key.second)
                                             : material::shear_strength(record->material, -pressure, record->rows.back().state.data());
      if (!t) break;
      line.x.push_back(pressure * kilo);
      line.y.push_back(*t * kilo);
    }
    figure.curves.push_back(line);
    done.push_back(key);
  }
}

plot::Figure stress_path(const Records& records)
{
  const bool triaxial = std::holds_alternative<Triaxial>(records.front()->settings.kind);
  plot::Figure figure = figure_of(
      records, "effective stress path",
      [triaxial](const TestRecord&, const TestRow& row) { return kilo * (triaxial ? mean_stress(row) : middle_stress(row)); },
      [triaxial](const TestRecord&, const TestRow& row) { return kilo * (triaxial ? deviator_stress(row) : max_shear_stress(row)); });
  figure.x_label = triaxial ? "p' (kPa)" : "s' = (s1' + s3')/2 (kPa)";
  figure.y_label = triaxial ? "q (kPa)" : "t = (s1' - s3')/2 (kPa)";
  add_strengths(figure, records, triaxial);
  return figure;
}

plot::Figure volume(const Records& records)
{
  plot::Figure figure = figure_of(records, "volumetric strain, compression positive", driven_percent,
                                  [](const TestRecord&, const TestRow& row) { return percent * volumetric_strain(row); });
  figure.x_label = strain_label(records);
  figure.y_label = "volumetric strain (%)";
  return figure;
}

plot::Figure pore_pressure(const Records& records)
{
  plot::Figure figure = figure_of(records, "excess pore pressure", driven_percent, [](const TestRecord& record, const TestRow& row) {
    return kilo * excess_pore_pressure(record, row).value_or(0);
  });
  figure.x_label = strain_label(records);
  figure.y_label = "excess pore pressure (kPa)";
  return figure;
}

plot::Figure compression(const Records& records)
{
  const bool isotropic = std::holds_alternative<Isotropic>(records.front()->settings.kind);
  plot::Figure figure = figure_of(
      records, "compression curve",
      [](const TestRecord&, const TestRow& row) { return vertical_stress(row) > 0 ? kilo * vertical_stress(row) : nan; },
      [isotropic](const TestRecord&, const TestRow& row) { return percent * (isotropic ? volumetric_strain(row) : -row.strain[1]); });
  figure.x_label = isotropic ? "mean stress p' (kPa)" : "vertical stress (kPa)";
  figure.y_label = isotropic ? "volumetric strain (%)" : "axial strain (%)";
  figure.more = "set key below font ',11'\nset autoscale x\nset logscale x\nset yrange [*:*] reverse\n";
  for (plot::FigureCurve& curve : figure.curves)
    for (std::size_t k = 0; k < curve.x.size(); ++k)
      if (!(curve.x[k] > 0)) curve.y[k] = nan;
  return figure;
}

Records chosen(const Records& records, const std::function<bool(const TestRecord&)>& which)
{
  Records some;
  std::copy_if(records.begin(), records.end(), std::back_inserter(some), [&](const TestRecord* record) { return which(*record); });
  return some;
}

}  // namespace

std::optional<Real> triaxial_strength(const TestRecord& record, Real p, Direction direction)
{
  // s = p + q/6. A strength that grows with s by sin phi makes q = 2 t(s(q)) contract by sin(phi)/3 a time.
  Real q = 0;
  constexpr int times = 60;
  for (int n = 0; n < times; ++n) {
    const std::optional<Real> t = material::shear_strength(record.material, -(p + q / 6), record.rows.back().state.data());
    if (!t) return {};
    q = direction == Direction::compression ? 2 * *t : -2 * *t;
  }
  return q;
}

std::vector<std::string> draw_figures(const std::vector<TestRecord>& records, const std::filesystem::path& folder)
{
  std::vector<std::string> drawn;
  const auto draw = [&](const Records& some, const char* what, plot::Figure (*make)(const Records&)) {
    if (some.empty()) return;
    const std::string name = fmt::format("{}_{}", kind_word(some.front()->settings.kind), what);
    if (plot::draw_figure(folder, name, make(some))) drawn.push_back(name);
  };
  for (std::size_t kind = 0; kind < std::variant_size_v<TestKind>; ++kind) {
    Records all;
    for (const TestRecord& record : records)
      if (record.settings.kind.index() == kind && record.rows.size() > 1) all.push_back(&record);
    const bool compresses = !all.empty() && is_compression(all.front()->settings.kind);
    draw(all, compresses ? "compression" : "stress_strain", compresses ? compression : stress_strain);
    draw(chosen(all, shows_effective_stress), "stress_path", stress_path);
    if (compresses) continue;
    draw(chosen(all, [](const TestRecord& record) { return drained(record.settings.kind); }), "volume", volume);
    draw(chosen(all, [](const TestRecord& record) { return !drained(record.settings.kind) && shows_effective_stress(record); }),
         "pore_pressure", pore_pressure);
  }
  return drawn;
}

}  // namespace berm::element
