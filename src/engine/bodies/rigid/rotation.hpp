// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"

#include <type_traits>

namespace berm::bodies {

/// An angular velocity, a rotation or a moment: in the plane a number, counter-clockwise about z; in space a vector.
template <int dim>
using Angular = std::conditional_t<dim == 2, Real, Vec<3>>;

template <int dim>
Angular<dim> no_angular()
{
  if constexpr (dim == 2)
    return 0;
  else
    return Vec<3>::Zero();
}

/// The rotation matrix of an angle (rad, counter-clockwise) about z.
template <int dim>
Matrix<dim> turn(Real angle)
{
  Matrix<dim> q = Matrix<dim>::Identity();
  q(0, 0) = q(1, 1) = std::cos(angle);
  q(1, 0) = std::sin(angle);
  q(0, 1) = -q(1, 0);
  return q;
}

/// angular x r.
inline Vec<2> cross(Real angular, const Vec<2>& r)
{
  return {-angular * r[1], angular * r[0]};
}
inline Vec<3> cross(const Vec<3>& a, const Vec<3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// r x force, the moment of a force about the point that r begins at.
inline Real moment_of(const Vec<2>& r, const Vec<2>& force)
{
  return r[0] * force[1] - r[1] * force[0];
}
inline Vec<3> moment_of(const Vec<3>& r, const Vec<3>& force)
{
  return cross(r, force);
}

inline Real dot(Real a, Real b)
{
  return a * b;
}
inline Real dot(const Vec<3>& a, const Vec<3>& b)
{
  return a.dot(b);
}
inline Real size_of_angular(Real a)
{
  return std::abs(a);
}
inline Real size_of_angular(const Vec<3>& a)
{
  return a.norm();
}

/// Rotation of a rigid body since the start: an angle in the plane, a unit quaternion in space.
template <int dim>
struct Orientation;

template <>
struct Orientation<2> {
  Real angle = 0;  ///< rad, counter-clockwise

  Matrix<2> matrix() const { return turn<2>(angle); }
  void turn_by(Real rotation) { angle += rotation; }
  bool operator==(const Orientation&) const = default;
};

template <>
struct Orientation<3> {
  Real w = 1, x = 0, y = 0, z = 0;

  Matrix<3> matrix() const
  {
    Matrix<3> q;
    q << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z), 1 - 2 * (x * x + z * z),
        2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
    return q;
  }
  /// Rotates it by a rotation vector (rad) in the axes of space: exact for a constant angular velocity.
  void turn_by(const Vec<3>& rotation)
  {
    const Real angle = rotation.norm();
    if (angle == 0) return;
    const Real c = std::cos(angle / 2), s = std::sin(angle / 2) / angle;
    const Real a = s * rotation[0], b = s * rotation[1], d = s * rotation[2];
    const Orientation q = *this;
    w = c * q.w - a * q.x - b * q.y - d * q.z;
    x = c * q.x + a * q.w + b * q.z - d * q.y;
    y = c * q.y + b * q.w + d * q.x - a * q.z;
    z = c * q.z + d * q.w + a * q.y - b * q.x;
    const Real length = std::sqrt(w * w + x * x + y * y + z * z);
    w /= length, x /= length, y /= length, z /= length;
  }
  bool operator==(const Orientation&) const = default;
};

/// The angle between two orientations, rad.
inline Real angle_between(const Orientation<2>& a, const Orientation<2>& b)
{
  return std::abs(a.angle - b.angle);
}
inline Real angle_between(const Orientation<3>& a, const Orientation<3>& b)
{
  return 2 * std::acos(std::min(Real(1), std::abs(a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z)));
}

/// The rotation since the start as an angle, or as a rotation vector, rad.
inline Real rotation_of(const Orientation<2>& q)
{
  return q.angle;
}
inline Vec<3> rotation_of(const Orientation<3>& q)
{
  const Vec<3> axis(q.x, q.y, q.z);
  const Real sine = axis.norm();
  return sine == 0 ? Vec<3>(Vec<3>::Zero()) : Vec<3>(axis * (2 * std::atan2(sine, q.w) / sine));
}

/// The rotation from one orientation to another as an angle, or as a rotation vector in the axes of space, rad.
inline Real rotation_between(const Orientation<2>& from, const Orientation<2>& to)
{
  return to.angle - from.angle;
}
inline Vec<3> rotation_between(const Orientation<3>& p, const Orientation<3>& q)
{
  const Orientation<3> by = {q.w * p.w + q.x * p.x + q.y * p.y + q.z * p.z, q.x * p.w - q.w * p.x + q.z * p.y - q.y * p.z,
                             q.y * p.w - q.w * p.y + q.x * p.z - q.z * p.x, q.z * p.w - q.w * p.z + q.y * p.x - q.x * p.y};
  return rotation_of(by.w < 0 ? Orientation<3>{-by.w, -by.x, -by.y, -by.z} : by);
}

}  // namespace berm::bodies
