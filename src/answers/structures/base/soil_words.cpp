// SPDX-License-Identifier: BSD-3-Clause
#include "structures/base/soil_words.hpp"

#include "os/text_of_list.hpp"
#include "text/quantity_words.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::base {
namespace {

/// "cohesion 2 kPa, Young's modulus 1 MPa".
std::string values_in_words(const material::Material& material)
{
  const std::vector<FieldInfo> fields = local_fields(material);
  const std::vector<Real> values = local_values(material);
  std::vector<std::string> words;
  for (std::size_t k = 0; k < fields.size(); ++k) words.push_back(fmt::format("{} {}", fields[k].label, text::stress_words(values[k])));
  return text_of_list(words, ", ");
}

}  // namespace

std::string layers_in_words(const settings::BodySoil& soil)
{
  std::string words = fmt::format("\"{}\"", soil.names.front());
  for (const settings::SoilLayer& layer : soil.layers)
    words += fmt::format(", from {} down \"{}\"", text::length_words(layer.top), soil.names[layer.material]);
  for (const auto& [region, number] : soil.of_region) words += fmt::format(", in region \"{}\" \"{}\"", region, soil.names[number]);
  return words;
}

std::vector<EarthworkWords> earthworks_in_words(const settings::Case& c)
{
  std::vector<EarthworkWords> all;
  const auto add = [&](const std::string& body, const bodies::EarthworkSettings& work, const std::string& material) {
    std::string words = material.empty() ? "excavation " + work.name : fmt::format("fill {} of {}", work.name, material);
    words += fmt::format(", in stage \"{}\"", work.stage);
    if (work.lifts > 1)
      words += fmt::format(", {} lifts{}", work.lifts, work.duration > 0 ? fmt::format(" in {:.3g} s", work.duration) : "");
    all.push_back({work, body, material, words});
  };
  for (const auto& [name, body] : c.body) {
    for (const bodies::ExcavationSettings& excavation : body.excavation) add(name, excavation, "");
    for (const bodies::FillSettings& fill : body.fill) {
      add(name, fill, fill.material);
      if (fill.k0) all.back().words += ", K₀ = " + text::number_words(*fill.k0);
    }
  }
  return all;
}

std::string k0_in_words(const bodies::K0Settings& at_rest, Real sin_friction)
{
  if (at_rest.k0) return text::number_words(*at_rest.k0);
  if (at_rest.ocr) return fmt::format("{} by OCR = {}", text::number_words(at_rest.at(sin_friction, 0)), text::number_words(*at_rest.ocr));
  return "by POP = " + text::stress_words(*at_rest.pop);
}

namespace {

/// Depth of the mesh below the surface of a level bed, m; of a mesh from a file it is not known.
Real depth_of_mesh(const settings::Case& c)
{
  constexpr Real deep = 1e4;
  if (const auto* bed = std::get_if<mesh::SeabedMesh>(&c.mesh)) return bed->depth;
  if (const auto* box = std::get_if<mesh::BoxMesh>(&c.mesh)) return c.surface - (box->lower.empty() ? 0 : box->lower[1]);
  return deep;
}

/// The depth at which the vertical stress at the start is this, Pa; 0 where it is not there down to the deepest, m.
Real depth_under(const settings::BodySoil& soil, Real vertical_stress, Real deepest)
{
  Real low = 0, high = deepest;
  if (!(soil.vertical_stress("", high) > vertical_stress) || !(vertical_stress > 0)) return 0;
  for (int k = 0; k < 60; ++k) {
    const Real middle = (low + high) / 2;
    (soil.vertical_stress("", middle) < vertical_stress ? low : high) = middle;
  }
  return high;
}

}  // namespace

std::vector<std::string> k0_words(const settings::Case& c)
{
  std::vector<std::string> lines;
  for (const auto& [name, body] : c.body) {
    const auto add = [&, &name = name](Real top, const std::string& material, const bodies::K0Settings& own, Real sine) {
      if (!own.by_history()) return;
      const Real passive = (1 + sine) / (1 - sine);
      lines.push_back(fmt::format("K0           body \"{}\"{}, \"{}\": {}; 1 - sin phi = {}, at most Kp = {}", name,
                                  top > 0 ? ", from " + text::length_words(top) + " down" : "", material, k0_in_words(own, sine),
                                  text::number_words(1 - sine), text::number_words(passive)));
      if (!own.pop) return;
      const settings::BodySoil soil = soil_of(c, body);
      std::string at_depths;
      for (const Real ratio : {9., 3., 1.5, 1.1})
        if (const Real depth = depth_under(soil, *own.pop / (ratio - 1), depth_of_mesh(c)); depth > top)
          at_depths += fmt::format("{}{} at {}", at_depths.empty() ? "" : ", ", text::number_words(own.at(sine, *own.pop / (ratio - 1))),
                                   text::length_words(depth));
      if (!at_depths.empty()) lines.push_back("             " + at_depths + " below the surface");
    };
    add(0, body.material, body.at_rest(), body.sin_friction);
    for (const bodies::SoilLayerSettings& layer : body.soil_layer)
      add(layer.top, layer.material, layer.at_rest().given() ? layer.at_rest() : body.at_rest(), layer.sin_friction);
  }
  return lines;
}

std::vector<std::string> soil_words(const settings::Case& c)
{
  std::vector<std::string> lines;
  for (const auto& [name, settings] : c.body) {
    const settings::BodySoil soil = soil_of(c, settings);
    if (!varies(soil)) continue;
    lines.push_back(fmt::format("soil         body \"{}\", material {}", name, layers_in_words(soil)));
    lines.push_back(fmt::format("             at the surface: {}", values_in_words(soil.at("", 0))));
    if (const Real depth = soil_depth(c, problem::ground_of(c), reference_depth(c)); depth > 0)
      lines.push_back(fmt::format("             {} deep, the lowest point of the {}: {}", text::length_words(depth), body_word(c),
                                  values_in_words(soil.at("", depth))));
  }
  for (const EarthworkWords& work : earthworks_in_words(c))
    lines.push_back(fmt::format("soil         body \"{}\": {}", work.body, work.words));
  return lines;
}

namespace {

std::string stage_words(const settings::Case& c, const settings::StageDrainage& stage)
{
  const std::string& name = c.stage[stage.stage].name;
  if (stage.moves) {
    return fmt::format("stage \"{}\": v D/c_v = {:.3g}, {}", name, stage.number, drainage_word(stage.number));
  }
  if (std::isnan(stage.number)) return fmt::format("stage \"{}\": as long as its consolidation takes", name);
  constexpr Real day = 86400;  // s
  const std::optional<Real> real = c.stage[stage.stage].until.real_time;
  return fmt::format("stage \"{}\": T = c_v t/D2 = {:.3g}{}", name, stage.number,
                     real ? fmt::format(", {:.4g} days of the soil in {:.4g} s of the run", *real / day, *c.stage[stage.stage].until.time)
                          : "");
}

std::string stage_line(const settings::Case& c, const settings::StageDrainage& stage, const settings::Consolidation& soil, Real width)
{
  const std::optional<settings::StageInertia> inertia = inertia_in(c, stage, soil, width);
  return "             " + stage_words(c, stage) + (inertia ? "; " + inertia_words(*inertia) : "");
}

/// c_v, m2/s, of the soil that touches the main rigid body, or of the first whose water flows.
Real c_v_of(const settings::Case& c, Real width)
{
  const std::vector<settings::Consolidation> found = consolidation_of(c, width);
  return found.empty() ? nan : found.front().c_v;
}

}  // namespace

const char* drainage_word(Real number)
{
  return number <= settings::drained_up_to ? "drained" : number >= settings::undrained_from ? "undrained" : "partially drained";
}

std::string inertia_words(const settings::StageInertia& inertia)
{
  using Measure = settings::StageInertia::Measure;
  const std::string part = fmt::format("{:.2g}", inertia.part);
  const std::string measure = inertia.measure == Measure::strength ? "density v2 is " + part + " of the strength"
                              : inertia.measure == Measure::wave
                                  ? "v is " + part + " of the speed of waves"
                                  : "a wave crosses the body in " + part + " of the time in which half of the pressure dissipates";
  return measure + (inertia.is_small() ? ": inertia is small" : inertia.is_large() ? ": inertia matters" : ": inertia may matter");
}

std::vector<std::string> drainage_words(const settings::Case& c)
{
  std::vector<std::string> lines;
  const Real width = body_scale(c).width;
  for (const settings::Consolidation& soil : consolidation_of(c, width)) {
    lines.push_back(fmt::format("water        \"{}\"{}: c_v = {:.3g} m2/s with M = {} of one-dimensional compression", soil.material,
                                soil.depth > 0 ? fmt::format(", {} below the surface", text::length_words(soil.depth)) : "", soil.c_v,
                                text::stress_words(soil.modulus)));
    if (width == 0) continue;
    for (const settings::StageDrainage& stage : drainage_of_stages(c, width, soil.c_v)) lines.push_back(stage_line(c, stage, soil, width));
  }
  if (!lines.empty() && width > 0)
    lines.push_back(fmt::format("             (D = {}; drained up to v D/c_v = {:g}, undrained from {:g})", text::length_words(width),
                                settings::drained_up_to, settings::undrained_from));
  return lines;
}

std::vector<Dissipation> dissipation_of(const record::RunRecord& run)
{
  const run_folder::History& h = run.history;
  std::vector<Dissipation> found;
  if (h.rows() == 0 || !h.has_label("U") || !h.has_label("p max")) return found;
  const Real width = body_scale(run).width, c_v = c_v_of(run.settings, width);
  const Real scale = width > 0 ? c_v / (width * width) : nan;
  const std::vector<Real>&time = h["time_s"], &U = h.by_label("U"), &pressure = h.by_label("p max");
  for (const settings::StageSettings& stage : run.settings.stage) {
    if (stage.kind == settings::StageKind::geostatic || speed_of(stage) > 0) continue;
    const auto first = std::find(h.stage.begin(), h.stage.end(), stage.name);
    if (first == h.stage.end()) continue;
    const Index begin = static_cast<Index>(first - h.stage.begin());
    Index end = begin;
    while (end < h.rows() && h.stage[end] == stage.name) ++end;
    const Real from = time[std::max<Index>(0, begin - 1)];
    if (!(*std::max_element(pressure.begin() + begin, pressure.begin() + end) > 0)) continue;
    const auto half = std::find_if(U.begin() + begin, U.begin() + end, [](Real u) { return u >= 0.5; });
    const Real t = time[end - 1] - from, t50 = half == U.begin() + end ? nan : time[half - U.begin()] - from;
    found.push_back({stage.name, t, U[end - 1], t50, t * scale, t50 * scale});
  }
  return found;
}

Charts dissipation_charts(const record::RunRecord& run)
{
  const run_folder::History& h = run.history;
  const Real part = settings::part_of_real_time(run.settings).value_or(1);
  Chart chart{
      "U_t", {"time since its beginning", "t", "s"}, {"degree of consolidation", "U", "1"}, {}, "Degree of consolidation over time"};
  for (const Dissipation& d : dissipation_of(run)) {
    Curve curve{d.stage};
    Real begin = 0;
    for (Index row = 0; row < h.rows(); ++row)
      if (h.stage[row] != d.stage) {
        if (curve.rows.empty()) begin = h["time_s"][row];
      } else {
        curve.rows.push_back(row);
        curve.x.push_back((h["time_s"][row] - begin) / part);
        curve.y.push_back(h.by_label("U")[row]);
      }
    chart.curves.push_back(std::move(curve));
  }
  return chart.curves.empty() ? Charts{} : Charts{chart};
}

std::vector<SurfaceForce> surface_forces_of(const record::RunRecord& run)
{
  constexpr Real last_part = 0.05;
  const run_folder::History& h = run.history;
  std::vector<SurfaceForce> found;
  if (h.rows() == 0 || !h.has_label("N eff") || !h.has_label("V") || !h.has("w_m")) return found;
  const std::vector<Real>&time = h["time_s"], &w = h["w_m"], &N = h.by_label("N eff"), &V = h.by_label("V");
  for (const settings::StageSettings& stage : run.settings.stage) {
    if (stage.kind == settings::StageKind::geostatic) continue;
    const auto first = std::find(h.stage.begin(), h.stage.end(), stage.name);
    if (first == h.stage.end()) continue;
    const Index begin = static_cast<Index>(first - h.stage.begin());
    Index end = begin;
    while (end < h.rows() && h.stage[end] == stage.name) ++end;
    const Real from = time[end - 1] - last_part * (time[end - 1] - time[begin]);
    SurfaceForce force{stage.name, w[end - 1], 0, 0};
    int rows = 0;
    for (Index k = begin; k < end; ++k)
      if (time[k] >= from && std::isfinite(N[k]) && std::isfinite(V[k])) force.N_eff += N[k], force.V += V[k], ++rows;
    if (rows == 0) continue;
    force.N_eff /= rows, force.V /= rows;
    found.push_back(force);
  }
  return found;
}

std::vector<run_folder::Quantity> dissipation_quantities(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> quantities;
  for (const Dissipation& d : dissipation_of(run)) {
    quantities.push_back({"U_of_" + d.stage, d.degree, "1", "degree of consolidation at the end of " + d.stage});
    if (std::isnan(d.t50)) continue;
    quantities.push_back(
        {"t50_of_" + d.stage, d.t50, "s", "time until half of the largest excess pore pressure has dissipated, of " + d.stage});
    if (std::isnan(d.T50)) continue;
    quantities.push_back({"T50_of_" + d.stage, d.T50, "1", "the same as c_v t/D2"});
  }
  return quantities;
}

std::vector<run_folder::Quantity> fill_quantities(const record::RunRecord& run)
{
  std::vector<run_folder::Quantity> quantities;
  const bool whole = run.settings.force_dimension() == 3;
  for (const auto& [name, body] : run.settings.body)
    for (const bodies::FillSettings& fill : body.fill)
      for (const auto& [what, meaning] : {std::pair{"mass", "placed"}, {"expected_mass", "that would fill its area"}}) {
        const std::string column = fmt::format("{}_{}_{}", fill.name, what, whole ? "kg" : "kg_m");
        if (run.history.rows() == 0 || !run.history.has(column)) continue;
        quantities.push_back({fmt::format("{}_{}", fill.name, what), run.history[column].back(), whole ? "kg" : "kg/m",
                              fmt::format("mass of the fill {} {}", fill.name, meaning)});
      }
  return quantities;
}

}  // namespace berm::base
