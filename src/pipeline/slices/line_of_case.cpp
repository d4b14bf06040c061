// SPDX-License-Identifier: BSD-3-Clause
#include "slices/line_of_case.hpp"

#include "formulas/axial.hpp"
#include "macro_element/under_force.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace berm::slices {
namespace {

Real diameter_of(const settings::Case& c)
{
  return bodies::width_of<2>(bodies::make_shape<2>(c.rigid.front().second.shape));
}

beam::Pipe pipe_of(const settings::PipelineSettings& p, Real diameter)
{
  beam::Pipe pipe;
  pipe.outer_diameter = diameter;
  pipe.wall = p.wall.value_or(0);
  pipe.young_modulus = p.young_modulus.value_or(0);
  pipe.poisson_ratio = p.poisson_ratio;
  pipe.expansion = p.expansion;
  return pipe;
}

Real mass_of(const settings::Case& c)
{
  return c.pipeline->mass.value_or(c.rigid.front().second.mass);
}

/// Stiffnesses of the case, or of a wall as thick as it is; weight and masses are the case's.
beam::Section section_of_case(const settings::Case& c)
{
  const settings::PipelineSettings& p = *c.pipeline;
  beam::Section section;
  if (p.wall) section = beam::section_of(pipe_of(p, diameter_of(c)));
  if (p.bending_stiffness) section.bending_stiffness = *p.bending_stiffness;
  if (p.axial_stiffness) section.axial_stiffness = *p.axial_stiffness;
  section.mass = mass_of(c);
  section.axial_mass = p.axial_mass.value_or(section.mass);
  section.submerged_weight = p.submerged_weight;
  section.radius = diameter_of(c) / 2;
  return section;
}

Real compression(const settings::PipelineSettings& p, const beam::Section& section, Real diameter, Real temperature, Real pressure)
{
  if (p.wall) return beam::constrained_force(pipe_of(p, diameter), temperature, pressure, p.lay_tension);
  return section.axial_stiffness * p.expansion * temperature - p.lay_tension;
}

LineLoads laid_loads(const settings::PipelineSettings& p)
{
  LineLoads loads;
  loads.weight = p.submerged_weight;
  return loads;
}

/// The load of the line that a column of a load history is of; null of another one.
std::optional<Real>* load_of(settings::PipelineLoads& loads, settings::LoadAlong along)
{
  switch (along) {
  case settings::LoadAlong::temperature:
    return &loads.temperature;
  case settings::LoadAlong::far_temperature:
    return &loads.far_temperature;
  case settings::LoadAlong::pressure:
    return &loads.pressure;
  case settings::LoadAlong::weight:
    return &loads.weight;
  case settings::LoadAlong::lateral:
    return &loads.lateral;
  case settings::LoadAlong::pull:
    return &loads.pull;
  default:
    return nullptr;
  }
}

LineLoads between(const LineLoads& from, const LineLoads& to, Real part)
{
  const auto mix = [&](Real LineLoads::*load) { return std::lerp(from.*load, to.*load, part); };
  return {mix(&LineLoads::temperature), mix(&LineLoads::far_temperature), mix(&LineLoads::pressure),
          mix(&LineLoads::weight),      mix(&LineLoads::lateral),         mix(&LineLoads::pull)};
}

/// Calls visit(k, loads) with the loads at the end of each stage k, and at each row of its load history: between them they go linearly.
template <class Visit>
void for_loads_of_stages(const settings::Case& c, const Visit& visit)
{
  LineLoads now = laid_loads(*c.pipeline);
  for (std::size_t k = 0; k < c.stage.size(); ++k) {
    const settings::StageSettings& stage = c.stage[k];
    if (stage.kind != settings::StageKind::pipeline) continue;
    for (const Real time : stage.load_times)
      if (const Real since = time * stage.time_scale; since < *stage.until.time) visit(k, loads_in(stage, now, since));
    now = end_of(stage, now);
    visit(k, now);
  }
}

/// The largest compression that the stages can bring, N.
Real largest_compression(const settings::Case& c, const beam::Section& section)
{
  Real largest = 0;
  for_loads_of_stages(c, [&](std::size_t, const LineLoads& now) {
    largest =
        std::max(largest, compression(*c.pipeline, section, diameter_of(c), std::max(now.temperature, now.far_temperature), now.pressure));
  });
  return largest;
}

/// Elements from slice to slice, or parts of that where a buckle needs them shorter; beyond the slices they grow.
std::vector<Real> nodes_of(const settings::Case& c, const std::vector<Real>& places)
{
  const settings::PipelineSettings& p = *c.pipeline;
  const Real longest = longest_element_of(c);
  constexpr Real growth = 1.1, max_nodes = 20000;
  if (const Real to = places.back(); !(static_cast<Real>(places.size()) + (to + p.length) / longest < max_nodes))
    throw KeyError(fmt::format("pipeline.length: elements of {:.3g} m, which the largest compression requires, would be more than {}: "
                               "shorten the line, or look at its stiffness and loads",
                               longest, max_nodes));
  std::vector<Real> nodes = {0};
  for (std::size_t k = 1; k < places.size(); ++k) {
    const int parts = static_cast<int>(std::ceil((places[k] - places[k - 1]) / longest));
    for (int part = 1; part <= parts; ++part) nodes.push_back(std::lerp(places[k - 1], places[k], static_cast<Real>(part) / parts));
  }
  const std::size_t within = nodes.size();
  for (Real size = nodes[within - 1] - nodes[within - 2]; nodes.back() < p.length * (1 - 1e-9);) {
    size = std::min(longest, size * growth);
    nodes.push_back(nodes.back() + size);
  }
  // The line ends where it does, without a stump.
  nodes.back() = p.length;
  if (nodes.size() > within + 1) nodes[nodes.size() - 2] = (nodes[nodes.size() - 3] + p.length) / 2;
  return nodes;
}

/// Through the points, with the slope of the chord between the two beside each; straight on beyond the last. Mirrored it has no slope at x = 0.
void give_route(beam::Line& line, const settings::Route& route, bool mirrored)
{
  const std::vector<Real>&x = route.x, &y = route.y;
  const std::size_t last = x.size() - 1;
  const auto chord = [&](std::size_t a, std::size_t b) { return (y[b] - y[a]) / (x[b] - x[a]); };
  for (std::size_t k = 0; k < last; ++k)
    if (!(std::abs(chord(k, k + 1)) <= beam::largest_valid_slope))
      throw KeyError(fmt::format("pipeline.route.y: the route has a slope of {:.3g} from x = {:.6g} to {:.6g} m, and the strain measure of "
                                 "the line is valid up to {:g}: rotate the axes along the line",
                                 chord(k, k + 1), x[k], x[k + 1], beam::largest_valid_slope));
  const auto slope_at = [&](std::size_t k) { return k == 0 && mirrored ? 0 : chord(k == 0 ? 0 : k - 1, std::min(k + 1, last)); };
  const auto at = [&](Real place) {  // displacement and slope
    if (place >= x[last]) return std::pair(y[last] + slope_at(last) * (place - x[last]), slope_at(last));
    const std::size_t b = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), place) - x.begin()), a = b - 1;
    const Real h = x[b] - x[a], s = (place - x[a]) / h, m = slope_at(a) * h, n = slope_at(b) * h, dy = y[b] - y[a];
    return std::pair(y[a] + s * (m + s * (3 * dy - 2 * m - n + s * (m + n - 2 * dy))),
                     (m + s * (2 * (3 * dy - 2 * m - n) + 3 * s * (m + n - 2 * dy))) / h);
  };
  beam::set_shape(
      line, beam::Plane::lateral, [&](Real place) { return at(place).first; }, [&](Real place) { return at(place).second; });
}

void give_shape(beam::Line& line, const settings::PipelineSettings& p)
{
  if (!p.route.x.empty()) return give_route(line, p.route, p.half == settings::LineHalf::symmetric);
  if (p.imperfection.amplitude == 0) return;
  const Real a = p.imperfection.amplitude, k = 2 * pi / p.imperfection.length, half = p.imperfection.length / 2;
  const Real b = a * 4 / (3 * std::sqrt(3.0));  // (1 + cos) sin has its largest, 3 sqrt(3)/4, at 60 degrees
  const Real steepest = p.half == settings::LineHalf::symmetric ? std::abs(a) * k / 2 : 2 * std::abs(b) * k;
  if (!(steepest <= beam::largest_valid_slope))
    throw KeyError(fmt::format("pipeline.imperfection.amplitude: is {:.4g} m in a length of {:.4g} m, a slope of {:.3g}, and the strain "
                               "measure of the line is valid up to {:g}: make it {:.2g} m or less, or longer",
                               a, p.imperfection.length, steepest, beam::largest_valid_slope,
                               std::abs(a) * beam::largest_valid_slope / steepest));
  if (p.half == settings::LineHalf::symmetric)
    beam::set_shape(
        line, beam::Plane::lateral, [&](Real x) { return x < half ? a * (1 + std::cos(k * x)) / 2 : 0; },
        [&](Real x) { return x < half ? -a * k * std::sin(k * x) / 2 : 0; });
  else
    beam::set_shape(
        line, beam::Plane::lateral, [&](Real x) { return x < half ? b * std::sin(k * x) * (1 + std::cos(k * x)) : 0; },
        [&](Real x) { return x < half ? b * k * (std::cos(k * x) + std::cos(2 * k * x)) : 0; });
}

/// Sideways, beyond the slices. Nothing where there is no resistance.
std::optional<beam::PlasticSpring> lateral_spring(const settings::PipelineSettings& p, Real diameter)
{
  const settings::FarSoil& soil = p.far_soil;
  beam::PlasticSpring spring;
  for (std::size_t k = 0; k < soil.lateral.x.size(); ++k) spring.backbone.points.push_back({soil.lateral.x[k], soil.lateral.y[k]});
  if (!spring.backbone.points.empty()) {
    try {
      beam::check(spring);
    } catch (const InputError& error) {
      throw KeyError(fmt::format("pipeline.far_soil.lateral: {}", error.what()));
    }
    return spring;
  }
  if (!(soil.friction > 0)) return {};
  return beam::friction(soil.friction * p.submerged_weight, soil.mobilisation > 0 ? soil.mobilisation : diameter / 100);
}

Real vertical_stiffness_of(const settings::PipelineSettings& p, Real diameter)
{
  return p.far_soil.stiffness.value_or(p.submerged_weight / (diameter / 100));
}

/// The largest force that pushed the pipe down before it carries its weight, N/m.
Real laying_force_of(const settings::Case& c)
{
  Real largest = c.pipeline->submerged_weight;
  for (const settings::StageSettings& stage : c.stage)
    if (stage.kind == settings::StageKind::push) largest = std::max(largest, stage.force.value_or(0));
  return largest;
}

/// Across and along the line at nodes with a length across; friction along it elsewhere.
void add_macro_elements(beam::Line& line, const settings::Case& c, const std::vector<Real>& across, const std::vector<Real>& all)
{
  const settings::PipelineSettings& p = *c.pipeline;
  macro_element::Parameters parameters;
  try {
    parameters = macro_element::read_parameters(p.far_soil.macro_element);
  } catch (const InputError& error) {
    throw KeyError(fmt::format("pipeline.far_soil.macro_element: {}", error.what()));
  }
  beam::add_macro_elements(line, parameters, across, macro_element::laid(parameters, laying_force_of(c), p.submerged_weight));
  std::vector<Real> on_slices = all;
  for (std::size_t i = 0; i < all.size(); ++i) on_slices[i] -= across[i];
  if (p.far_soil.axial_friction > 0)
    beam::add_springs(line, beam::Direction::axial,
                      beam::friction(p.far_soil.axial_friction * p.submerged_weight, p.far_soil.axial_mobilisation), on_slices);
}

/// Springs: along the line everywhere, across it beyond the slices and where these may be springs.
void add_soil(beam::Line& line, const settings::Case& c, Real last_slice)
{
  const settings::PipelineSettings& p = *c.pipeline;
  const settings::FarSoil& soil = p.far_soil;
  const std::vector<Real> all = beam::lengths_of_nodes(line),
                          across = p.slices.as_spring == settings::SliceAsSpring::never ? beam::lengths_of_nodes(line, last_slice) : all;
  if (p.end_stiffness) {
    std::vector<Real> end(static_cast<std::size_t>(line.nodes()), 0);
    end.back() = 1;
    beam::add_springs(line, beam::Direction::axial, beam::LinearSpring{*p.end_stiffness}, end);
  }
  if (!soil.macro_element.empty()) return add_macro_elements(line, c, across, all);
  if (const std::optional<beam::PlasticSpring> spring = lateral_spring(p, diameter_of(c)))
    beam::add_springs(line, beam::Direction::lateral, *spring, across);
  // That of an interface is found once the pipe is laid: a factor of the weight.
  const Real along = soil.axial_angle || soil.axial_strength ? 1 : soil.axial_friction;
  if (along > 0) beam::add_springs(line, beam::Direction::axial, beam::friction(along * p.submerged_weight, soil.axial_mobilisation), all);
  beam::add_springs(line, beam::Direction::vertical, beam::LinearSpring{vertical_stiffness_of(p, diameter_of(c))}, across);
}

beam::Line line_of(const settings::Case& c, const std::vector<Real>& places)
{
  const settings::PipelineSettings& p = *c.pipeline;
  beam::Line line = beam::straight_line(nodes_of(c, places), section_of_case(c), {beam::Plane::lateral, beam::Plane::vertical});
  give_shape(line, p);
  switch (p.half) {
  case settings::LineHalf::symmetric:
    beam::hold(line, 0, beam::EndCondition::symmetric);
    break;
  case settings::LineHalf::antisymmetric:
    beam::hold(line, 0, beam::EndCondition::antisymmetric);
    break;
  case settings::LineHalf::none:
    break;
  }
  if (p.end == settings::LineEnd::anchored) beam::hold(line, line.nodes() - 1, beam::EndCondition::clamped);
  add_soil(line, c, places.back());
  line.axial_where_sideways = false;
  line.damping[1] = p.vertical_damping;
  return line;
}

}  // namespace

Real longest_element_of(const settings::Case& c)
{
  const beam::Section section = section_of_case(c);
  const Real P = largest_compression(c, section);
  return P > 0 ? pi * std::sqrt(section.bending_stiffness / P) / 4 : c.pipeline->length;
}

LineOfCase::LineOfCase(const settings::Case& c)
    : line(line_of(c, places_of(c.pipeline->slices))),
      places(places_of(c.pipeline->slices)),
      stations(line, places),
      diameter(diameter_of(c)),
      mass(mass_of(c)),
      length_of_nodes(beam::lengths_of_nodes(line)),
      length_beyond(beam::lengths_of_nodes(line, places.back())),
      lateral(lateral_spring(*c.pipeline, diameter)),
      vertical_stiffness(vertical_stiffness_of(*c.pipeline, diameter)),
      settings(*c.pipeline)
{
}

Real LineOfCase::constrained_force(const LineLoads& loads, Real x) const
{
  const Real temperature = std::lerp(loads.temperature, loads.far_temperature, x / line.x.back());
  return compression(settings, line.section.front(), diameter, temperature, loads.pressure);
}

Real LineOfCase::mobilised(Real displacement) const
{
  if (!lateral) return 1;
  Real largest = 0;
  for (const beam::CurvePoint& point : lateral->backbone.points) largest = std::max(largest, point.force);
  return lateral->backbone.force(std::abs(displacement)) / largest;
}

LineLoads LineOfCase::laid() const
{
  return laid_loads(settings);
}

Real LineOfCase::axial_resistance(Real embedment, Real force) const
{
  const settings::FarSoil& soil = settings.far_soil;
  Real resistance = 0;
  if (soil.axial_angle) resistance += formulas::axial_drained(diameter, embedment, *soil.axial_angle, std::max(force, Real(0))).value;
  if (soil.axial_strength) resistance += formulas::axial_undrained(diameter, embedment, *soil.axial_strength).value;
  return resistance;
}

LineLoads target_of(const settings::PipelineLoads& stage, const LineLoads& before)
{
  LineLoads now = before;
  // Without a temperature of its own the far end has that of x = 0.
  if (stage.temperature) now.temperature = now.far_temperature = *stage.temperature;
  now.far_temperature = stage.far_temperature.value_or(now.far_temperature);
  now.pressure = stage.pressure.value_or(before.pressure);
  now.weight = stage.weight.value_or(before.weight);
  now.lateral = stage.lateral.value_or(before.lateral);
  now.pull = stage.pull.value_or(before.pull);
  return now;
}

LineLoads loads_in(const settings::StageSettings& stage, const LineLoads& before, Real since)
{
  if (!has_load_history(stage)) return between(before, target_of(stage.pipeline, before), stage.ramp > since ? since / stage.ramp : 1);
  settings::PipelineLoads now;
  for (std::size_t k = 0; k < settings::load_columns.size(); ++k) {
    if (stage.loads.columns[k].empty()) continue;
    if (std::optional<Real>* load = load_of(now, settings::load_columns[k].along)) *load = load_of_column(stage, k, since);
  }
  return target_of(now, before);
}

LineLoads end_of(const settings::StageSettings& stage, const LineLoads& before)
{
  return loads_in(stage, before, stage.until.time.value_or(infinity));
}

std::size_t hottest_stage_of(const settings::Case& c, const LineOfCase& of)
{
  Real largest = -infinity;
  std::size_t hottest = 0;
  for_loads_of_stages(c, [&](std::size_t k, const LineLoads& loads) {
    if (const Real compression = of.constrained_force(loads, 0); compression > largest) largest = compression, hottest = k;
  });
  return hottest;
}

std::string words_of_places(const std::vector<Real>& places)
{
  Real least = infinity, most = 0;
  for (std::size_t k = 1; k < places.size(); ++k) {
    least = std::min(least, places[k] - places[k - 1]);
    most = std::max(most, places[k] - places[k - 1]);
  }
  if (most - least < 1e-6 * most) return fmt::format("{} slices every {:.4g} m, to {:.4g} m", places.size(), most, places.back());
  return fmt::format("{} slices {:.3g} to {:.3g} m apart, to {:.4g} m", places.size(), least, most, places.back());
}

}  // namespace berm::slices
