// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dual.hpp"
#include "material/elasticity.hpp"
#include "material/increment.hpp"
#include "material/law_queries.hpp"

#include <algorithm>
#include <memory>
#include <type_traits>

namespace berm::material {

constexpr int max_user_state = 32;  ///< state variables per particle of a law of the user's own

/// An increment at one point as a law of the user's own receives it. Components xx yy zz xy yz zx, the last two 0 in plane strain; tension positive.
struct UserIncrement {
  int dimension = 2;
  Real dt = 0, time = 0;  ///< s, duration and beginning
  Real strain[6] = {};    ///< increment; shear strains are engineering strains, gamma = 2 e
  Real stress[6] = {};    ///< Pa, before and after
  Real state[max_user_state];
  bool with_tangent = false;
  Real tangent[36];  ///< Pa, d stress[i] / d strain[j] at [6 i + j], where it is wanted
};

/// A law that is called point by point: the door to the room that loads it. Serves several threads at a time.
class PointLaw {
public:
  virtual ~PointLaw() = default;
  /// Advances stress and state. Where the law fails both become NaN, and failure() says why.
  virtual void advance(UserIncrement& increment) const = 0;
  /// Why the law failed first since forget_failure(); "" where it did not.
  virtual std::string failure() const = 0;
  virtual void forget_failure() const = 0;
};

/// How the user's function is called: berm's own interface (include/berm/law.h), or a UMAT of Abaqus.
enum class Interface { own, umat };

/// A law of the user's own in a shared library: parameters.
template <Interface interface>
struct UserLaw {
  static constexpr const char* word = interface == Interface::umat ? "umat" : "user";
  static constexpr int state_size = max_user_state;  ///< at most; state_count(law) are in use

  Real density = 0;                     ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;  ///< kg/m3, gives the inertia; empty: density
  Real young_modulus = 0;               ///< Pa, of the stiffest response
  Real poisson_ratio = 0;
  std::string library, library_sha256, symbol;
  std::vector<Real> properties;
  int state_variables = 0;
  std::vector<Real> initial_state;  ///< empty: all 0
  std::vector<std::string> state_names;
  bool can_yield = true;
  enum class ThreadSafe { probed, yes, no } thread_safe = ThreadSafe::probed;
  std::shared_ptr<const PointLaw> loaded;  ///< by user_law::load; null before
  std::optional<PoreWater> water = {};

  bool operator==(const UserLaw&) const = default;
};

template <Interface interface>
void describe(Describe& d, UserLaw<interface>& law);

template <Interface interface>
void check(Describe& d, const std::string& path, const UserLaw<interface>& law);

template <Interface interface>
std::string law_name(const UserLaw<interface>&)
{
  return interface == Interface::umat ? "UMAT" : "user's own law";
}

template <Interface interface>
Elasticity elasticity(const UserLaw<interface>& law)
{
  return elasticity(law.young_modulus, law.poisson_ratio);
}

template <Interface interface>
int state_count(const UserLaw<interface>& law)
{
  return law.state_variables;
}

template <Interface interface>
std::vector<FieldInfo> state_fields(const UserLaw<interface>& law);

template <Interface interface>
bool yields(const UserLaw<interface>& law)
{
  return law.can_yield;
}

/// It may: nobody knows what a law of the user's own depends on.
template <Interface interface>
bool is_rate_dependent(const UserLaw<interface>&)
{
  return true;
}

template <Interface interface>
void initial_state(const UserLaw<interface>& law, const SymTensor<3>& /*stress*/, Real* state)
{
  std::copy(law.initial_state.begin(), law.initial_state.end(), state);
}

/// What an update needs of it; the same for both interfaces.
struct PreparedUserLaw {
  static constexpr int state_size = max_user_state;
  static constexpr bool elastic_is_largest = true;

  Elasticity elastic;
  int state_variables = 0;
  const PointLaw* law = nullptr;  ///< kept by the material
};

/// Throws std::logic_error where the law was not loaded.
template <Interface interface>
PreparedUserLaw prepare(const UserLaw<interface>& law);

inline int state_count(const PreparedUserLaw& law)
{
  return law.state_variables;
}

/// Advances one point, of one lane or alone. `number(x)` is its number of an x, x(k) the k-th of several.
template <int dim, class Number, class T>
UserIncrement user_increment(const PreparedUserLaw& law, const SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                             const T* state, const Number& number)
{
  UserIncrement point;
  point.dimension = dim;
  point.dt = increment.dt;
  point.time = increment.time;
  for (int k = 0; k < tensor_size<dim>; ++k) {
    point.stress[k] = number(stress[k]);
    point.strain[k] = (k < 3 ? 1 : 2) * number(increment.strain[k]);
  }
  for (int k = 0; k < law.state_variables; ++k) point.state[k] = number(state[k]);
  return point;
}

/// Calls the law once for each active lane, or once. With T = Dual the slopes of the new stress are those of the strain increment times the tangent that
/// the law gives; slopes of the old stress and of the state are not used, those of the new state are 0.
template <int dim, class T>
void update(const PreparedUserLaw& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment, T* state)
{
  if constexpr (std::is_same_v<T, Dual>) {
    UserIncrement point = user_increment<dim>(law, stress, increment, state, [](const Dual& x) { return x.value; });
    point.with_tangent = true;
    law.law->advance(point);
    for (int i = 0; i < tensor_size<dim>; ++i) {
      stress[i] = Dual{point.stress[i]};
      for (int j = 0; j < tensor_size<dim>; ++j)
        stress[i].slope += increment.strain[j].slope * (point.tangent[6 * i + j] * (j < 3 ? 1 : 2));
    }
    for (int k = 0; k < law.state_variables; ++k) state[k] = Dual{point.state[k]};
  } else if constexpr (std::is_same_v<T, Real>) {
    UserIncrement point = user_increment<dim>(law, stress, increment, state, [](Real x) { return x; });
    law.law->advance(point);
    std::copy_n(point.stress, tensor_size<dim>, stress.c);
    std::copy_n(point.state, law.state_variables, state);
  } else {
    for (int l = 0; l < lanes_of<T>; ++l) {
      if (!increment.active[l]) continue;
      UserIncrement point = user_increment<dim>(law, stress, increment, state, [l](const T& x) { return x[l]; });
      law.law->advance(point);
      for (int k = 0; k < tensor_size<dim>; ++k) stress[k][l] = point.stress[k];
      for (int k = 0; k < law.state_variables; ++k) state[k][l] = point.state[k];
    }
  }
}

}  // namespace berm::material
