// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/function.hpp"

#include <algorithm>

namespace berm::user_law {
namespace {

/// berm's component of each component of Abaqus: 11 22 33 12 13 23 among xx yy zz xy yz zx.
constexpr int component_of[6] = {0, 1, 2, 3, 5, 4};
constexpr std::size_t name_length = 80;

}  // namespace

Answer call(const OwnFunction& function, const Constants& constants, material::UserIncrement& increment, bool& tangent_given)
{
  berm_law_increment own;
  own.version = BERM_LAW_VERSION;
  own.dimension = increment.dimension;
  own.material = constants.material.c_str();
  own.property_count = static_cast<int>(constants.properties.size());
  own.properties = constants.properties.data();
  own.dt = increment.dt;
  own.time = increment.time;
  std::copy_n(increment.strain, 6, own.strain);
  std::copy_n(increment.stress, 6, own.stress);
  own.state_count = constants.state_variables;
  own.state = increment.state;
  own.tangent = increment.with_tangent ? increment.tangent : nullptr;
  own.tangent_given = 0;
  const int answer = function(&own);
  std::copy_n(own.stress, 6, increment.stress);
  tangent_given = own.tangent_given != 0;
  return answer == berm_law_done ? Answer::done : answer == berm_law_smaller ? Answer::smaller : Answer::failed;
}

Answer call(const Umat& umat, const Constants& constants, material::UserIncrement& increment, bool& tangent_given)
{
  const Unknown& unknown = umat.unknown;
  const int normal = 3, size = increment.dimension == 2 ? 4 : 6, shear = size - normal;
  double stress[6], dstran[6], stran[6], ddsdde[36] = {};
  for (int a = 0; a < size; ++a) {
    stress[a] = increment.stress[component_of[a]];
    dstran[a] = increment.strain[component_of[a]];
    stran[a] = unknown.stran;
  }
  char name[name_length];
  std::fill(name, name + name_length, ' ');
  std::copy_n(constants.material.data(), std::min(constants.material.size(), name_length), name);
  const double turn[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const double gradient[9] = {unknown.stretch, 0, 0, 0, unknown.stretch, 0, 0, 0, unknown.stretch};
  const double coords[3] = {unknown.coords, unknown.coords, unknown.coords}, time[2] = {increment.time, increment.time}, no_change[1] = {0};
  double energies[3] = {}, heat = 0, of_temperature[6] = {}, of_strain[6] = {}, drpldt = 0, pnewdt = 1;
  const int state_variables = constants.state_variables, properties = static_cast<int>(constants.properties.size()), zero = 0;
  const int kstep[4] = {1, 0, 0, 0};  // newer versions call it JSTEP, of four numbers
  const int kinc = increment.time > 0 ? 2 : 1;

  umat.function(stress, increment.state, ddsdde, &energies[0], &energies[1], &energies[2], &heat, of_temperature, of_strain, &drpldt, stran,
                dstran, time, &increment.dt, &unknown.temp, no_change, &unknown.predef, no_change, name, &normal, &shear, &size,
                &state_variables, constants.properties.data(), &properties, coords, turn, &pnewdt, &unknown.celent, gradient, gradient,
                &unknown.number, &unknown.number, &zero, &zero, kstep, &kinc, name_length);

  for (int a = 0; a < size; ++a) increment.stress[component_of[a]] = stress[a];
  tangent_given = increment.with_tangent && std::any_of(ddsdde, ddsdde + size * size, [](double x) { return x != 0; });
  if (tangent_given)
    for (int a = 0; a < size; ++a)
      for (int b = 0; b < size; ++b) increment.tangent[6 * component_of[a] + component_of[b]] = ddsdde[a + size * b];
  return pnewdt < 1 ? Answer::smaller : Answer::done;
}

}  // namespace berm::user_law
