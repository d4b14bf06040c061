// SPDX-License-Identifier: BSD-3-Clause
#include "fem/contact_points.hpp"

#include <map>

namespace berm::fem {
namespace {

constexpr Real adhesion_per_pressure = 10;

}  // namespace

FemTraction update_traction(const FemInterface& interface, const Vec<2>& normal, const FemContactState& before, const Vec<2>& movement)
{
  const Real k = interface.stiffness;
  FemTraction now{{before.gap + movement.dot(normal), Vec<2>::Zero(), before.slip, before.parted}, Matrix<2>::Zero()};
  if (interface.tied) {
    now.state.traction = before.traction - k * movement;
    now.stiffness = -k * Matrix<2>::Identity();
    return now;
  }
  const bool bonded = interface.tension > 0 && before.parted == 0;
  const Real pressure = std::max(-k * now.state.gap, bonded ? -interface.tension : -infinity);
  // Closed at zero pressure, so that the first iterate for stress-free soil moves it with the body.
  if (!(pressure >= 0) && !bonded) return now;
  const Vec<2> tangent(-normal[1], normal[0]);
  const Real status = bonded ? interface.adhesion : std::min(interface.adhesion, adhesion_per_pressure * pressure);
  const Real trial = before.traction.dot(tangent) - k * movement.dot(tangent),
             limit = interface.friction * std::max(Real(0), pressure - interface.pore_pressure) + status;
  const Real rise =
      (pressure >= interface.pore_pressure ? interface.friction : 0) + (status < interface.adhesion ? adhesion_per_pressure : 0);
  const bool slides = std::abs(trial) > limit;
  const Real sign = trial < 0 ? -1 : 1, shear = slides ? sign * limit : trial;
  now.state.traction = pressure * normal + shear * tangent;
  if (pressure > -interface.tension || !bonded) now.stiffness = -k * normal * normal.transpose();
  if (slides) now.state.slip += (std::abs(trial) - limit) / k;
  if (slides)
    now.stiffness -= sign * rise * k * tangent * normal.transpose();
  else
    now.stiffness -= k * tangent * tangent.transpose();
  return now;
}

bool parts(const FemInterface& interface, const FemContactState& now)
{
  constexpr Real rounding = 1e-9;
  return interface.tension > 0 && now.gap * interface.stiffness > (1 + rounding) * interface.tension;
}

Eigen::Matrix<Real, 2, 5> relative_movement(const FemContactPoint& point)
{
  return Eigen::Matrix<Real, 2, 5>{{1, 0, -1, 0, point.arm[1]}, {0, 1, 0, -1, -point.arm[0]}};
}

std::vector<FemContactPoint> make_contact_points(const std::vector<BoundarySide>& sides, const NodeField<Vec<2>>& position,
                                                 const bodies::RigidShape<2>& shape, mesh::Metric metric)
{
  std::map<Index, FemContactPoint> points;
  for (const auto& [from, to, middle, boundary] : sides) {
    const Vec<2>&a = position[from], &b = position[to], &m = position[middle];
    // dx/ds at the ends and in the middle of the parabola through the three nodes, s from 0 to 1.
    const Vec<2> whole = b - a, half = m - a;
    const Real speed[3] = {(4 * half - whole).norm(), (3 * whole - 4 * half).norm(), whole.norm()};
    const Real part[3] = {1. / 6, 1. / 6, 4. / 6};
    const Index nodes[3] = {from, to, middle};
    for (int k = 0; k < 3; ++k) {
      FemContactPoint& point = points.try_emplace(nodes[k], FemContactPoint{nodes[k], Vec<2>::Zero(), Vec<2>::Zero(), 0}).first->second;
      const Vec<2>& x = position[nodes[k]];
      // At a corner of the body the surface's normal is that of the side.
      point.normal += part[k] * speed[k] * surface_at<2>(shape, Vec<2>(x + 1e-3 * (m - x))).normal;
      point.area += part[k] * speed[k] * weight_at(metric, x);
      point.arm = x - center_of<2>(shape);
    }
  }
  std::vector<FemContactPoint> list;
  for (auto& [node, point] : points) {
    point.normal.normalize();
    if (point.area > 0) list.push_back(point);  // on the axis there is none
  }
  return list;
}

}  // namespace berm::fem
