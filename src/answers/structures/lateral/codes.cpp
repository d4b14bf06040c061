// SPDX-License-Identifier: BSD-3-Clause
#include "structures/lateral/codes.hpp"

#include "formulas/pile_lateral.hpp"
#include "structures/penetration/soil_profile.hpp"

#include <algorithm>
#include <memory>

namespace berm::lateral {
namespace {

constexpr Real small_strain_ratio = 550;  // G_0/s_u of the clay of Jeanjean 2009
constexpr int slices = 200;
constexpr Real far = 1e3;  // of the length: a displacement at which every method has its largest resistance

/// Binds the soil of a run by depth to a method.
template <class Soil, class At>
CodeMethod bound(const formulas::PileMethod<Soil>& method, const At& soil_at, Real length)
{
  CodeMethod code{method.name, method.column, method.choices, {}, {}, {}, {}};
  code.p = [=, p = method.p](Real z, Real y) { return p(soil_at(z), y); };
  if (method.m != nullptr) code.m = [=, m = method.m](Real z, Real tilt) { return m(soil_at(z), tilt); };
  if (method.base_H != nullptr) code.base_H = [=, H = method.base_H](Real y) { return H(soil_at(length), y); };
  if (method.base_M != nullptr) code.base_M = [=, M = method.base_M](Real tilt) { return M(soil_at(length), tilt); };
  return code;
}

/// Whether the soil behind the pile may part from it.
bool may_part(const settings::Case& c)
{
  const contact::ContactSettings& contact = *base::contact_of_body(c);
  return !rules_of(contact.scheme).tied && !std::isinf(contact.tension);
}

/// The lateral load and its moment about the point at `height`, where that point is displaced by u and the pile tilts.
struct Held {
  Real H = 0, moment = 0;
  bool valid = true;

  Held(const CodeMethod& method, Real length, Real height, Real u, Real tilt)
  {
    const auto value = [&](const formulas::Formula& formula) {
      valid = valid && formula.valid;
      return formula.value;
    };
    const Real dz = length / slices;
    const auto add = [&](Real force, Real z) { H += force, moment += force * (z + height); };
    for (int k = 0; k < slices; ++k) {
      const Real z = (k + 0.5) * dz;
      add(value(method.p(z, u - (z + height) * tilt)) * dz, z);
      if (method.m) moment -= value(method.m(z, tilt)) * dz;
    }
    if (method.base_H) add(value(method.base_H(u - (length + height) * tilt)), length);
    if (method.base_M) moment -= value(method.base_M(tilt));
  }
};

}  // namespace

std::vector<CodeMethod> code_methods(const LateralRun& run)
{
  if (run.empty() || base::contact_of_body(run.record.settings) == nullptr) return {};
  const auto soil = std::make_shared<const penetration::SoilProfile>(run.record);
  const Real D = run.width, L = run.path.length;
  std::vector<CodeMethod> methods;
  const penetration::SoilAt middle = soil->at(L / 2);
  if (run.strength > 0) {
    const bool gap = may_part(run.record.settings);
    const auto clay_at = [=](Real z) {
      const penetration::SoilAt at = soil->at(z);
      const Real alpha = std::isnan(at.interface_ratio) ? 1 : at.interface_ratio;
      return formulas::ClayAtPile{z,
                                  D,
                                  L,
                                  at.strength,
                                  soil->at(0).strength,
                                  at.overburden,
                                  alpha,
                                  formulas::strain_50_of(at.rigidity_index),
                                  small_strain_ratio * at.strength,
                                  gap};
    };
    for (const auto& method : formulas::clay_pile_methods()) methods.push_back(bound(method, clay_at, L));
  } else if (middle.friction_angle > 0) {
    const auto sand_at = [=](Real z) {
      const penetration::SoilAt at = soil->at(z);
      return formulas::SandAtPile{z, D, L, at.friction_angle, at.overburden};
    };
    for (const auto& method : formulas::sand_pile_methods()) methods.push_back(bound(method, sand_at, L));
  }
  return methods;
}

RigidPile rigid_pile(const CodeMethod& method, Real length, Real height, Real u)
{
  constexpr int doublings = 60, halvings = 60;
  if (std::isinf(u)) u = std::copysign(far * length, u);
  const auto moment = [&](Real tilt) { return Held(method, length, height, u, tilt).moment; };
  // The moment falls as the tilt grows: soil that the pile leaves resists it.
  Real low = -std::abs(u) / length, high = -low;
  for (int k = 0; k < doublings && moment(low) < 0; ++k) low *= 2;
  for (int k = 0; k < doublings && moment(high) > 0; ++k) high *= 2;
  for (int k = 0; k < halvings; ++k) {
    const Real middle = (low + high) / 2;
    (moment(middle) > 0 ? low : high) = middle;
  }
  // Where a slice turns from one side to the other between the two, a part of it does.
  const Held above(method, length, height, u, low), below(method, length, height, u, high);
  const Real jump = above.moment - below.moment, part = jump > 0 ? std::clamp(above.moment / jump, Real(0), Real(1)) : 0.5;
  const Real tilt = (low + high) / 2;
  return {std::lerp(above.H, below.H, part), std::abs(tilt) > 1e-12 * std::abs(u) / length ? u / tilt - height : nan,
          above.valid && below.valid && std::isfinite(above.H)};
}

}  // namespace berm::lateral
