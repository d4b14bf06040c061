// SPDX-License-Identifier: BSD-3-Clause
#include "fem/flow.hpp"

namespace berm::fem {
namespace {

/// k / gamma_w, m2/(Pa s), of the porosity that this displacement of the nodes has made.
Real mobility(const PointWater& water, const VolumeStrain& volume, const VolumeStrain& displacement)
{
  const Real n = water.hydraulics.porosity_at(1 + volume.dot(displacement));
  return water.hydraulics.permeability_at(n) / material::unit_weight_of_water;
}

}  // namespace

CornerShape corner_shape(const ShapeAtPoint& shape)
{
  CornerShape corners;
  for (int k = 0; k < 3; ++k) {
    const int next = 3 + k, last = 3 + (k + 2) % 3;  // in the middle of its sides
    corners.value[k] = shape.value[k] + (shape.value[next] + shape.value[last]) / 2;
    corners.gradient[k] = shape.gradient[k] + (shape.gradient[next] + shape.gradient[last]) / 2;
  }
  return corners;
}

VolumeStrain volume_strain(const ShapeAtPoint& shape)
{
  VolumeStrain volume;
  for (int k = 0; k < 6; ++k) {
    volume[2 * k] = shape.gradient[k][0] + shape.value[k] * shape.per_radius;
    volume[2 * k + 1] = shape.gradient[k][1];
  }
  return volume;
}

Real pressure_at_end(const CornerShape& corners, const FlowIncrement& increment)
{
  Real p = 0;
  for (int k = 0; k < 3; ++k) p += corners.value[k] * (increment.pressure_before[k] + increment.added[k]);
  return p;
}

Vec<2> water_flux(const ShapeAtPoint& shape, const PointWater& water, const VolumeStrain& displacement, const std::array<Real, 3>& pressure)
{
  const CornerShape corners = corner_shape(shape);
  Vec<2> slope = Vec<2>::Zero();
  for (int k = 0; k < 3; ++k) slope += pressure[k] * corners.gradient[k];
  return -mobility(water, volume_strain(shape), displacement) * slope;
}

CellFlow water_balance(const std::array<ShapeAtPoint, triangle_points>& shapes, const std::array<PointWater, triangle_points>& water,
                       const FlowIncrement& increment)
{
  constexpr Real smallest_strain = 1e-9;  // what is less does not count as an imbalance
  CellFlow flow;
  for (int q = 0; q < triangle_points; ++q) {
    const CornerShape corners = corner_shape(shapes[q]);
    const VolumeStrain volume = volume_strain(shapes[q]);
    Vec<2> slope = Vec<2>::Zero();
    Real added = 0;
    for (int k = 0; k < 3; ++k) {
      slope += (increment.pressure_before[k] + increment.added[k]) * corners.gradient[k];
      added += corners.value[k] * increment.added[k];
    }
    const Real area = shapes[q].area, widened = volume.dot(increment.moved), compressed = water[q].compressibility * added;
    const Vec<2> path = increment.dt * mobility(water[q], volume, increment.moved_before) * slope;  // of the water, against its flux
    flow.volume += area * (std::abs(widened) + std::abs(compressed) + smallest_strain);
    for (int k = 0; k < 3; ++k) {
      flow.residual[k] -= area * (corners.value[k] * (widened + compressed) + corners.gradient[k].dot(path));
      flow.volume += area * std::abs(corners.gradient[k].dot(path));
    }
  }
  return flow;
}

std::array<Real, pressure_entries> balance_derivatives(const std::array<ShapeAtPoint, triangle_points>& shapes,
                                                       const std::array<PointWater, triangle_points>& water, const FlowIncrement& increment)
{
  std::array<Real, pressure_entries> entries{};
  for (int q = 0; q < triangle_points; ++q) {
    const CornerShape corners = corner_shape(shapes[q]);
    const VolumeStrain volume = volume_strain(shapes[q]);
    const Real area = shapes[q].area, conductance = increment.dt * mobility(water[q], volume, increment.moved_before);
    int entry = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 12; ++j) entries[entry++] -= area * corners.value[i] * volume[j];
      for (int j = 0; j <= i; ++j)
        entries[entry++] -= area * (water[q].compressibility * corners.value[i] * corners.value[j] +
                                    conductance * corners.gradient[i].dot(corners.gradient[j]));
    }
  }
  return entries;
}

}  // namespace berm::fem
