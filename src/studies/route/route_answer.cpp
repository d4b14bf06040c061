// SPDX-License-Identifier: BSD-3-Clause
#include "route/route_answer.hpp"

#include "beam/pipe_section.hpp"
#include "formulas/axial.hpp"
#include "formulas/f114.hpp"
#include "formulas/global_buckling.hpp"
#include "formulas/uplift.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace berm::route {
namespace {

/// One soil out of the low, best and high of a section.
struct Soil {
  Real strength, sensitivity, adhesion_factor, strength_ratio, friction_angle, interface_angle;
};

Real best_of(const Estimates3& values)
{
  return values.empty() ? nan : values[values.size() / 2];
}

/// The best soil first, then each number at its low and its high, one at a time.
std::vector<Soil> soils_of(const Section& s)
{
  const Soil best{best_of(s.strength),       best_of(s.sensitivity),    best_of(s.adhesion_factor),
                  best_of(s.strength_ratio), best_of(s.friction_angle), best_of(s.interface_angle)};
  std::vector<Soil> soils = {best};
  for (const auto& [values, number] : {std::pair(&s.strength, &Soil::strength),
                                       {&s.sensitivity, &Soil::sensitivity},
                                       {&s.adhesion_factor, &Soil::adhesion_factor},
                                       {&s.strength_ratio, &Soil::strength_ratio},
                                       {&s.friction_angle, &Soil::friction_angle},
                                       {&s.interface_angle, &Soil::interface_angle}})
    if (values->size() == 3)
      for (const std::size_t end : {0, 2}) soils.push_back(best), soils.back().*number = (*values)[end];
  return soils;
}

beam::Pipe steel_of(const Pipe& pipe)
{
  return {.outer_diameter = pipe.steel_diameter.value_or(pipe.diameter),
          .wall = pipe.wall,
          .young_modulus = pipe.young_modulus,
          .poisson_ratio = pipe.poisson_ratio,
          .expansion = pipe.expansion};
}

/// Clay at the invert of the pipe at an embedment.
formulas::PipeInClay in_clay(const Pipe& pipe, const Section& s, const Soil& soil, Real w, Real sensitivity = 1)
{
  return {pipe.diameter, w, (soil.strength + s.gradient * w) / sensitivity, soil.adhesion_factor, s.gradient / sensitivity, s.unit_weight};
}

formulas::PipeInSand in_sand(const Pipe& pipe, const Section& s, const Soil& soil, Real w)
{
  return {pipe.diameter, w, s.unit_weight, soil.friction_angle, soil.interface_angle};
}

/// Where the vertical resistance is the load; the diameter where it is not even there.
template <class Missing>
Real embedment_under(Real diameter, const Missing& missing)
{
  constexpr int halvings = 60;
  Real low = 1e-9 * diameter, high = diameter;
  if (!(missing(high) <= 0)) return diameter;
  for (int k = 0; k < halvings; ++k) {
    const Real middle = (low + high) / 2;
    (missing(middle) > 0 ? low : high) = middle;
  }
  return high;
}

/// The embedment of laying and under the weights that followed, and that under the weight of now alone.
struct Embedments {
  Real flooded, operation, alone;
};

Embedments embedments_of(const Pipe& pipe, const Section& s, const Soil& soil)
{
  const Real EI = section_of(steel_of(pipe)).bending_stiffness;
  const auto resistance = [&](Real w, Real sensitivity) {
    return s.is_clay() ? f114_undrained_model_2(in_clay(pipe, s, soil, w, sensitivity)).value
                       : f114_drained_vertical(in_sand(pipe, s, soil, w)).value;
  };
  const auto under = [&](Real weight) { return embedment_under(pipe.diameter, [&](Real w) { return weight - resistance(w, 1); }); };
  // Motions of laying remould the clay that they press on.
  const Real laid = embedment_under(pipe.diameter, [&](Real w) {
    const Real Q = resistance(w, soil.sensitivity),
               factor = pipe.lay_factor.value_or(formulas::f114_lay_factor(Q, w, EI, pipe.lay_tension).value);
    return std::max(factor, Real(1)) * pipe.laying - Q;
  });
  const Real flooded = std::max(laid, under(pipe.flooded.value_or(0))), alone = under(pipe.operation);
  return {flooded, std::max(flooded, alone), alone};
}

/// Takes the low, best and high of one soil; `first`: it is the best one.
void widen(Bounds& bounds, Real low, Real best, Real high, bool first)
{
  if (first) bounds = {low, best, high};
  bounds.low = std::min(bounds.low, low), bounds.high = std::max(bounds.high, high);
}

void take_doubt(Resistances& found, const char* what, const formulas::Formula& formula)
{
  const std::string words = fmt::format("{} is outside the range of {} ({})", what, citation(formula.source), formula.source.range);
  if (!formula.valid && std::ranges::find(found.doubts, words) == found.doubts.end()) found.doubts.push_back(words);
}

/// Lateral breakout in clay: low and high over both models, best of the first.
void take_clay_breakout(Resistances& found, Bounds& into, const formulas::PipeInClay& clay, Real V, bool first)
{
  const formulas::Estimates one = f114_undrained_lateral_1(clay, formulas::Rear::gap);
  const formulas::Formula two = f114_undrained_lateral_2(clay, V);
  take_doubt(found, "lateral breakout", one.best);
  widen(into, std::min(one.low.value, two.value), one.best.value, std::max(one.high.value, two.value), first);
}

void take_clay(Resistances& found, const Pipe& pipe, const Section& s, const Soil& soil, const Embedments& w, bool first)
{
  const Real D = pipe.diameter, V = pipe.operation;
  const formulas::PipeInClay clay = in_clay(pipe, s, soil, w.operation);
  take_doubt(found, "embedment", f114_undrained_model_2(clay));
  take_clay_breakout(found, found.lateral_breakout, clay, V, first);
  if (pipe.flooded) take_clay_breakout(found, found.hydrotest_breakout, in_clay(pipe, s, soil, w.flooded), *pipe.flooded, first);
  const formulas::Estimates residual = f114_clay_residual(clay, V);
  take_doubt(found, "lateral residual", residual.best);
  widen(found.lateral_residual, residual.low.value, residual.best.value, residual.high.value, first);
  const Real breakout =
      soil.strength_ratio > 0
          ? formulas::axial_consolidated(D, w.operation, V, s.consolidation,
                                         {soil.strength_ratio, s.exponent, soil.adhesion_factor, pipe.flooded.value_or(V) / V})
                .value
          : formulas::axial_undrained(D, w.operation, soil.adhesion_factor * clay.strength).value;
  // Slow or after many cycles, the excess pore pressure of sliding has gone.
  const Real drained = soil.interface_angle > 0 ? formulas::axial_drained(D, w.operation, soil.interface_angle, V).value : 0;
  const Real remoulded = breakout / soil.sensitivity;
  widen(found.axial_breakout, breakout, breakout, std::max(breakout, drained), first);
  widen(found.axial_residual, remoulded, remoulded, std::max(remoulded, drained), first);
}

void take_sand(Resistances& found, const Pipe& pipe, const Section& s, const Soil& soil, const Embedments& w, bool first)
{
  const auto lateral = [&](Real embedment, Real V) { return f114_drained_lateral(in_sand(pipe, s, soil, embedment), V); };
  const formulas::Formula breakout = lateral(w.operation, pipe.operation);
  take_doubt(found, "embedment", f114_drained_vertical(in_sand(pipe, s, soil, w.operation)));
  take_doubt(found, "lateral breakout", breakout);
  widen(found.lateral_breakout, breakout.value, breakout.value, breakout.value, first);
  if (pipe.flooded) {
    const Real H = lateral(w.flooded, *pipe.flooded).value;
    widen(found.hydrotest_breakout, H, H, H, first);
  }
  // Out of its trench: on the seabed at least, as deep as it was at most.
  widen(found.lateral_residual, lateral(0, pipe.operation).value, lateral(w.alone, pipe.operation).value, breakout.value, first);
  const Real axial = formulas::axial_drained(pipe.diameter, w.operation, soil.interface_angle, pipe.operation).value;
  widen(found.axial_breakout, axial, axial, axial, first);
  widen(found.axial_residual, axial, axial, axial, first);
}

/// Of a buried line: over all formulas that hold; the best is that of shear on vertical planes.
void take_uplift(Resistances& found, const Pipe& pipe, const Section& s, const Soil& soil, bool first)
{
  const bool sand = !s.is_clay();
  const formulas::BuriedPipe buried{.diameter = pipe.diameter,
                                    .cover = *s.cover,
                                    .unit_weight = s.unit_weight,
                                    .friction_angle = sand ? soil.friction_angle : 0,
                                    .strength = sand ? 0 : soil.strength + s.gradient * *s.cover / 2,
                                    .roughness = sand ? 0 : soil.adhesion_factor};
  Real low = infinity, high = 0;
  for (const formulas::UpliftModel& model : uplift_models(buried))
    if (model.resistance.valid) low = std::min(low, model.resistance.value), high = std::max(high, model.resistance.value);
  widen(found.uplift, low, sand ? uplift_vertical_slip(buried).value : otc_uplift_clay(buried).value, high, first);
}

Resistances by_formulas(const Pipe& pipe, const Section& s)
{
  Resistances found;
  found.V = pipe.operation;
  bool first = true;
  for (const Soil& soil : soils_of(s)) {
    if (s.cover) {
      take_uplift(found, pipe, s, soil, first);
    } else {
      const Embedments w = embedments_of(pipe, s, soil);
      widen(found.embedment, w.operation, w.operation, w.operation, first);
      const Real k = pipe.operation / w.operation;
      widen(found.stiffness, k, k, k, first);
      (s.is_clay() ? take_clay : take_sand)(found, pipe, s, soil, w, first);
    }
    first = false;
  }
  found.source = s.cover       ? "uplift of buried pipes: least and largest of the published formulas"
                 : s.is_clay() ? "DNV-RP-F114: embedment model 2, lateral models 1 and 2, residual; axial: White and Randolph 2007"
                               : "DNV-RP-F114: drained vertical and lateral; axial: White and Randolph 2007";
  return found;
}

/// The number at a KP, level beyond the ends.
Real at_kp(const std::vector<Real>& kp, const std::vector<Real>& values, Real x)
{
  if (values.size() == 1) return values.front();
  if (x <= kp.front()) return values.front();
  for (std::size_t k = 1; k < kp.size(); ++k)
    if (x <= kp[k]) return std::lerp(values[k - 1], values[k], (x - kp[k - 1]) / (kp[k] - kp[k - 1]));
  return values.back();
}

Real force_at(const RouteCase& c, Real kp)
{
  const Operation& operation = c.operation;
  return constrained_force(steel_of(c.pipe), at_kp(operation.kp, operation.temperature, kp), at_kp(operation.kp, operation.pressure, kp),
                           c.pipe.lay_tension);
}

/// What a length holds of the compression: of a buried line, whose axial resistance no formula here has, all of it.
Real held_by(const Resistances& soil, Real length)
{
  return std::isnan(soil.axial_breakout.high) ? infinity : soil.axial_breakout.high * length;
}

/// The least of what heat and pressure make, and of what lies between here and each free end, with the high axial breakout.
struct Compression {
  const RouteCase& c;
  const std::vector<SectionAnswer>& answers;

  Real at_rest(Real kp) const { return force_at(c, kp); }
  Real from_begin(Real kp) const { return between(c.section.front().from, kp); }
  Real to_end(Real kp) const { return between(kp, c.section.back().to); }

  /// What the line holds between two places.
  Real between(Real from, Real to) const
  {
    if (c.operation.ends == Ends::anchored) return infinity;
    Real held = 0;
    for (std::size_t k = 0; k < answers.size(); ++k)
      if (const Real length = std::min(to, c.section[k].to) - std::max(from, c.section[k].from); length > 0)
        held += held_by(answers[k].soil, length);
    return held;
  }

  /// Along a section. All three are linear between its ends and the KPs of the operation.
  std::vector<ForceAt> along(const Section& s) const
  {
    std::vector<Real> places = {s.from};
    for (const Real kp : c.operation.kp)
      if (kp > s.from && kp < s.to) places.push_back(kp);
    places.push_back(s.to);
    const std::size_t pieces = places.size() - 1;
    for (std::size_t k = 0; k < pieces; ++k)
      for (const auto& [one, other] : {std::pair(&Compression::at_rest, &Compression::from_begin),
                                       {&Compression::at_rest, &Compression::to_end},
                                       {&Compression::from_begin, &Compression::to_end}}) {
        const Real begin = (this->*one)(places[k]) - (this->*other)(places[k]),
                   end = (this->*one)(places[k + 1]) - (this->*other)(places[k + 1]);
        if (begin * end < 0 && std::isfinite(begin * end)) places.push_back(std::lerp(places[k], places[k + 1], begin / (begin - end)));
      }
    std::ranges::sort(places);
    std::vector<ForceAt> forces;
    for (const Real kp : places) forces.push_back({kp, std::min({at_rest(kp), from_begin(kp), to_end(kp)})});
    return forces;
  }
};

Real largest(const std::vector<ForceAt>& forces)
{
  return std::ranges::max(forces, {}, &ForceAt::force).force;
}

void screen_lateral(Screening& found, const beam::Section& steel, const Resistances& soil, const std::optional<Real>& radius)
{
  const formulas::HotLine weak{steel.bending_stiffness, steel.axial_stiffness, soil.lateral_breakout.low, soil.axial_breakout.low};
  formulas::HobbsMode mode = formulas::HobbsMode::two;
  found.hobbs = infinity;
  for (const auto& [one, lobes] : {std::pair(formulas::HobbsMode::two, 2), {formulas::HobbsMode::three, 3}, {formulas::HobbsMode::four, 4}})
    if (const Real P = hobbs_smallest_force(one, weak); P < found.hobbs) found.hobbs = P, found.lobes = lobes, mode = one;
  if (found.lobes == 0) found.hobbs = nan;
  if (radius) found.curve = formulas::curve_buckling_force(soil.lateral_breakout.low, *radius).value;
  const Real P_0 = found.compression;
  found.lateral = P_0 / (std::isnan(found.curve) ? found.hobbs : std::min(found.hobbs, found.curve));
  const auto buckle = [&](Real axial) {
    return hobbs_buckle_at(mode, {steel.bending_stiffness, steel.axial_stiffness, soil.lateral_residual.best, axial}, P_0);
  };
  if (!(P_0 > 0)) return;
  found.buckle = buckle(soil.axial_residual.best);
  found.anchor_spacing = {2 * buckle(soil.axial_residual.high).slip_length, 2 * found.buckle.slip_length,
                          2 * buckle(soil.axial_residual.low).slip_length};
  if (std::isfinite(found.buckle.compression))
    found.feed_in = formulas::buckle_feed_in(P_0, found.buckle.compression, steel.axial_stiffness, soil.axial_residual.best).value;
}

}  // namespace

std::vector<SectionAnswer> answer_of(const RouteCase& c, const FromRun& from_run)
{
  const beam::Section steel = section_of(steel_of(c.pipe));
  std::vector<SectionAnswer> answers;
  for (const Section& s : c.section)
    answers.emplace_back().soil = s.run.empty() ? by_formulas(c.pipe, s) : from_run(c.folder / s.run, c.pipe);
  const Compression compression{c, answers};
  for (std::size_t k = 0; k < answers.size(); ++k) {
    const Section& s = c.section[k];
    SectionAnswer& answer = answers[k];
    answer.compression = compression.along(s);
    Screening& found = answer.screening;
    found.constrained_force = std::max(force_at(c, s.from), force_at(c, s.to));
    for (const Real kp : c.operation.kp)
      if (kp > s.from && kp < s.to) found.constrained_force = std::max(found.constrained_force, force_at(c, kp));
    found.compression = largest(answer.compression);
    if (!s.cover) {
      screen_lateral(found, steel, answer.soil, s.curve_radius);
    } else if (s.prop_height > 0) {
      const formulas::Formula held = formulas::palmer_download(found.compression, steel.bending_stiffness, c.pipe.laying, s.prop_height);
      found.download = found.compression > 0 ? held.value : 0;
      found.upheaval = found.download / (c.pipe.operation + answer.soil.uplift.low);
    }
  }
  return answers;
}

}  // namespace berm::route
