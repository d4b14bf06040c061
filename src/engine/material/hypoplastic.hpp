// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/law_queries.hpp"
#include "material/pressure_elasticity.hpp"

namespace berm::material {

/// Hypoplastic sand with intergranular strain: with the effective stress T (tension positive), t = T / tr(T), its deviator t*, and the strain rate D,
///
///   rate of T = f_b f_e (L : D + f_d N |D|),   L = (F^2 I + a^2 t t) / (t : t),   N = a F (t + t*) / (t : t),
///   a = sqrt(3/8) (3 - sin(phi)) / sin(phi),   F = sqrt(x^2 / 8 + (2 - x^2) / (2 + sqrt(2) x cos(3 theta))) - x / sqrt(8),   x = sqrt(3) |t*|,
///   f_d = ((e - e_d) / (e_c - e_d))^alpha,   f_e = (e_c / e)^beta,   e_d / e_d0 = e_c / e_c0 = e_i / e_i0 = exp(-(3 p' / h_s)^n),
///   f_b = h_s / n (e_i0 / e_c0)^beta (1 + e_i) / e_i (3 p' / h_s)^(1 - n) / (3 + a^2 - a sqrt(3) ((e_i0 - e_d0) / (e_c0 - e_d0))^alpha).
///
/// At the critical state, e = e_c, a |t*| = F: the surface of Matsuoka and Nakai with phi in triaxial compression. The intergranular strain d, |d| = R r, with
/// its direction n, stiffens the soil after a change of the direction of strain, w = r^chi:
///
///   rate of T = (w m_T + (1 - w) m_R) L : D + w (1 - m_T) L : n (n : D) + w N (n : D)  where n : D > 0,  else the second term is w (m_R - m_T) L : n (n : D),
///   rate of d = D - n (n : D) r^beta_r  where n : D > 0,  else D  (L and N here with their factors f_b, f_e, f_d).
///
/// Sources: von Wolffersdorff, Mech. Cohes.-Frict. Mater. 1 (1996); Niemunis and Herle, the same 2 (1997).
///
/// State: the void ratio e, and the intergranular strain d (xx yy zz xy yz zx, tension positive).
struct Hypoplastic {
  static constexpr const char* word = "hypoplastic";
  static constexpr int state_size = 7;

  Real density = 0;                      ///< kg/m3, gives the weight
  std::optional<Real> inertia_density;   ///< kg/m3, gives the inertia; empty: density
  Real critical_friction_angle = 0;      ///< rad
  Real granular_hardness = 0;            ///< h_s, Pa
  Real hardness_exponent = 0;            ///< n
  Real min_void_ratio = 0;               ///< e_d0
  Real critical_void_ratio = 0;          ///< e_c0
  Real max_void_ratio = 0;               ///< e_i0
  Real dilatancy_exponent = 0;           ///< alpha
  Real stiffness_exponent = 0;           ///< beta
  std::optional<Real> void_ratio;        ///< at the start; or
  std::optional<Real> relative_density;  ///< at the start, (e_c - e) / (e_c - e_d)
  Real small_strain = 0;                 ///< R; 0: no intergranular strain
  Real reversal_stiffness = 0;           ///< m_R
  Real turn_stiffness = 0;               ///< m_T
  Real evolution_exponent = 0;           ///< beta_r
  Real decay_exponent = 0;               ///< chi
  Real min_pressure = 100;               ///< Pa
  Real max_pressure = 0;                 ///< Pa
  std::optional<PoreWater> water = {};

  bool operator==(const Hypoplastic&) const = default;
};

void describe(Describe& d, Hypoplastic& law);

/// One of void_ratio and relative_density is given; e_d0 < e_c0 < e_i0; 1 <= m_T <= m_R; min_pressure < max_pressure.
void check(Describe& d, const std::string& path, const Hypoplastic& law);

/// Isotropic moduli, at e_d and max_pressure after a reversal of strain, that bound the work of any strain increment below that pressure.
Elasticity elasticity(const Hypoplastic& law);
YoungPoisson young_poisson(const Hypoplastic& law);

std::string law_name(const Hypoplastic& law);
std::vector<FieldInfo> state_fields(const Hypoplastic& law);

/// e that is given, or that of the relative density at this p'; no intergranular strain.
void initial_state(const Hypoplastic& law, const SymTensor<3>& stress, Real* state);

struct PreparedHypoplastic {
  static constexpr int state_size = 7;
  static constexpr int rotating_state = 1;
  static constexpr bool indefinite_tangent = true;
  static constexpr bool elastic_is_largest = true;

  Elasticity elastic;
  Real a = 0;
  Real min_pressure = 0, max_pressure = 0;                   ///< Pa
  Real per_hardness = 0, exponent = 0;                       ///< 3 / h_s, n
  Real min_void_ratio = 0;                                   ///< e_d0
  Real per_range_of_void_ratio = 0, per_max_void_ratio = 0;  ///< 1 / (e_c0 - e_d0), 1 / e_i0
  Real stiffness = 0;                                        ///< the constant factor of f_b f_e, Pa
  Real alpha = 0, beta = 0;                                  //
  Real range = 0, per_range = 1, reversal = 1, turn = 1, evolution = 0,
       decay = 0;  ///< R, 1 / R, m_R, m_T, beta_r, chi; with R = 0: direction of the strain
};

PreparedHypoplastic prepare(const Hypoplastic& law);

/// No stress mobilises more friction than this angle: (9 - sin^2) / (1 - sin^2) of 65 degrees, the limit of I1 I2 / I3.
constexpr Real most_mobilised = 45.79;

template <class T>
[[gnu::always_inline]] inline T power_of(const T& logarithm_of_base, Real exponent)
{
  return exponential(logarithm_of_base * exponent);
}

/// det of a symmetric tensor.
template <int dim, class T>
[[gnu::always_inline]] inline T determinant(const SymTensor<dim, T>& s)
{
  const T plane = s[0] * s[1] - s[3] * s[3];
  if constexpr (dim == 2) return plane * s[2];
  return plane * s[2] + 2. * s[3] * s[4] * s[5] - s[0] * s[4] * s[4] - s[1] * s[5] * s[5];
}

/// t* of a stress, and |t*|^2 and det(t*).
template <int dim, class T>
struct StressRatio {
  T pressure;  ///< p', at least the minimum
  SymTensor<dim, T> deviator;
  T square, determinant;

  [[gnu::always_inline]] StressRatio(const SymTensor<dim, T>& stress, Real min_pressure)
  {
    const T mean = trace(stress) * (1. / 3);
    pressure = larger(-mean, T{} + min_pressure);
    const T per_trace = (-1. / 3) / pressure;
    for (int k = 0; k < tensor_size<dim>; ++k) deviator[k] = (k < 3 ? stress[k] - mean : stress[k]) * per_trace;
    square = double_dot(deviator, deviator);
    determinant = material::determinant(deviator);
  }
  /// (k I3 - I2) / I1 with the deviator times a factor, and its derivative with respect to the factor: 0 at the friction of I1 I2 / I3 = k, the most.
  [[gnu::always_inline]] T room(const T& factor) const
  {
    return (k / 27 - 1. / 3) + factor * factor * (square * (0.5 - k / 6) + factor * (k * determinant));
  }
  [[gnu::always_inline]] T room_change(const T& factor) const { return factor * (square * (1 - k / 3) + factor * (3 * k * determinant)); }
  [[gnu::always_inline]] auto is_beyond(const T& factor) const { return (room(factor) < T{}) | (factor * factor * square > T{} + 0.66); }

private:
  static constexpr Real k = most_mobilised;
};

/// The rate of stress of hypoplasticity in a state: what all strain rates share. The compiler copies whole tensors of vectors through memory in halves, which
/// waits; so tensors are written by component.
template <int dim, class T>
struct HypoplasticState {
  StressRatio<dim, T> ratio;
  T f_square, a_square;  ///< F^2 and a^2 times f_b f_e / (t : t), Pa
  T nonlinear;           ///< f_b f_e f_d a F / (t : t), Pa

  [[gnu::always_inline]] HypoplasticState(const PreparedHypoplastic& law, const SymTensor<dim, T>& stress, const T& void_ratio)
      : ratio(stress, law.min_pressure)
  {
    // x^2 = 3 |t*|^2 and sqrt(2) x cos(3 theta) = -18 det(t*) / |t*|^2.
    const T square = ratio.square + 1e-30, eighth = square * (3. / 8);
    const T lode = larger(2. * square - 18. * ratio.determinant, 0.01 * square);
    const T f = square_root(eighth + larger(2. - 3. * square, T{}) * square / lode) - square_root(eighth);
    // Void ratios over that of their packing, exp(-(3 p' / h_s)^n), are compared with those at zero pressure.
    const T log_share = logarithm(smaller(ratio.pressure, T{} + law.max_pressure) * law.per_hardness);
    const T grow = exponential(power_of(log_share, law.exponent)), unloaded = void_ratio * grow;
    const T above = larger((unloaded - law.min_void_ratio) * law.per_range_of_void_ratio, T{} + 1e-30);
    const T f_d = power_of(logarithm(above), law.alpha);
    const T log_f = log_share * (1 - law.exponent) - law.beta * logarithm(larger(unloaded, T{} + law.min_void_ratio));
    const T factor = law.stiffness * exponential(log_f) * (1. + grow * law.per_max_void_ratio) / (square + 1. / 3);
    const T of_f = factor * f;
    f_square = of_f * f;
    a_square = factor * (law.a * law.a);
    nonlinear = of_f * f_d * law.a;
  }
  /// L : D + size N.
  [[gnu::always_inline]] SymTensor<dim, T> rate(const SymTensor<dim, T>& strain, const T& size) const
  {
    const T n = nonlinear * size;
    const T along = a_square * (double_dot(ratio.deviator, strain) + trace(strain) * (1. / 3)) + 2. * n,
            of_pressure = (along - n) * (1. / 3);
    SymTensor<dim, T> rate;
    for (int k = 0; k < tensor_size<dim>; ++k) {
      rate[k] = f_square * strain[k] + along * ratio.deviator[k];
      if (k < 3) rate[k] += of_pressure;
    }
    return rate;
  }
};

/// What the intergranular strain makes of the rates; without it, as if it were R in the direction of the strain.
template <int dim, class T>
struct Intergranular {
  T per_size;            ///< 1 / |d|
  T along;               ///< n : D
  T mobilised, evolved;  ///< r^chi and r^beta_r

  [[gnu::always_inline]] Intergranular(const PreparedHypoplastic& law, const SymTensor<dim, T>& grains, const SymTensor<dim, T>& strain)
  {
    const T one = T{} + 1.;
    mobilised = evolved = one;
    if (!(law.range > 0)) {
      along = square_root(double_dot(strain, strain));
      per_size = T{};
      return;
    }
    const T square = double_dot(grains, grains) + 1e-60;
    per_size = 1. / square_root(square);
    along = double_dot(grains, strain) * per_size;
    const T log_square = logarithm(smaller(square * (law.per_range * law.per_range), one));
    mobilised = power_of(log_square, 0.5 * law.decay);
    evolved = power_of(log_square, 0.5 * law.evolution);
  }
};

/// The change of stress in a piece with this strain, Pa.
template <int dim, class T>
[[gnu::always_inline]] inline SymTensor<dim, T> stress_change(const PreparedHypoplastic& law, const HypoplasticState<dim, T>& soil,
                                                              const Intergranular<dim, T>& factors, const SymTensor<dim, T>& grains,
                                                              const SymTensor<dim, T>& strain)
{
  const T along = factors.mobilised * factors.along, zero{};
  const T all = law.reversal + (law.turn - law.reversal) * factors.mobilised;
  const T part = along * (along > zero ? zero + (1 - law.turn) : zero + (law.reversal - law.turn)) * factors.per_size;
  SymTensor<dim, T> stiffened;
  for (int k = 0; k < tensor_size<dim>; ++k) stiffened[k] = all * strain[k] + part * grains[k];
  return soil.rate(stiffened, larger(along, zero));
}

/// The intergranular strain after a piece by the two methods of Euler. That of the implicit one has the direction of begin + strain: pieces of any size end
/// at R in the direction of the strain.
template <int dim, class T>
[[gnu::always_inline]] inline SymTensor<dim, T> explicit_grains(const Intergranular<dim, T>& factors, const SymTensor<dim, T>& begin,
                                                                const SymTensor<dim, T>& strain)
{
  const T kept = 1. - factors.evolved * larger(factors.along, T{}) * factors.per_size;
  SymTensor<dim, T> end;
  for (int k = 0; k < tensor_size<dim>; ++k) end[k] = kept * begin[k] + strain[k];
  return end;
}
template <int dim, class T>
[[gnu::always_inline]] inline SymTensor<dim, T> implicit_grains(const PreparedHypoplastic& law, const SymTensor<dim, T>& begin,
                                                                const SymTensor<dim, T>& strain, const T& evolved)
{
  SymTensor<dim, T> end;
  for (int k = 0; k < tensor_size<dim>; ++k) end[k] = begin[k] + strain[k];
  const T zero{}, size = larger(square_root(double_dot(end, end)), zero + 1e-30), per_size = 1. / size;
  const T taken = double_dot(begin, strain) >= zero ? larger(double_dot(end, strain), zero) * per_size * evolved : zero;
  const T part = smaller(larger(size - taken, zero), zero + law.range) * per_size;
  for (int k = 0; k < tensor_size<dim>; ++k) end[k] *= part;
  return end;
}

/// Below this |t*|^2 no stress has the friction of most_mobilised: det(t*) is at least -2 (|t*|^2 / 6)^(3/2), with which room is positive.
constexpr Real surely_within = 0.13;

/// p' is at least the minimum, and friction at most that of most_mobilised; rare.
template <int dim, class T>
[[gnu::noinline]] void keep_in_compression(SymTensor<dim, T>& stress, Real min_pressure)
{
  const StressRatio<dim, T> ratio(stress, min_pressure);
  const T one = T{} + 1.;
  const auto is_beyond = ratio.is_beyond(one);
  const auto is_open = trace(stress) > T{} - 3 * min_pressure;
  T factor = one;
  if (any(is_beyond)) {
    T low{}, high = one;
    for (int k = 0; k < 40; ++k) {
      const T middle = (low + high) * 0.5;
      const auto too_much = ratio.is_beyond(middle);
      low = too_much ? low : middle;
      high = too_much ? middle : high;
    }
    low -= ratio.room(low) / ratio.room_change(low);  // which gives it its derivatives
    factor = is_beyond ? low : one;
  }
  const T part = -3. * ratio.pressure * factor;
  for (int k = 0; k < tensor_size<dim>; ++k) {
    const T kept = part * ratio.deviator[k] - (k < 3 ? ratio.pressure : T{});
    stress[k] = (is_beyond | is_open) ? kept : stress[k];
  }
}

/// The largest errors in a piece, of stress over p' and of the intergranular strain over R; the smallest piece of an increment, and the most tries.
constexpr Real piece_error = 1e-3, piece_error_of_grains = 0.02, least_piece = 1. / 1024;
constexpr int most_pieces = 2048;
/// Up to a change of stress by this part of p', and of strain by this part of R, Euler's method is within a tenth of a percent on a long path.
constexpr Real small_change = 2e-3, small_change_of_grains = 0.02;

/// What an increment is made of, and its errors over the largest.
template <int dim, class T>
struct HypoplasticPiece {
  SymTensor<dim, T> stress, grains;
  T void_ratio, error;
};

template <int dim, class T, class Mask>
[[gnu::always_inline]] inline HypoplasticPiece<dim, T> piece_of(const PreparedHypoplastic& law, const SymTensor<dim, T>& stress,
                                                                const T& void_ratio, const SymTensor<dim, T>& grains,
                                                                const SymTensor<dim, T>& strain, const Mask& acts)
{
  constexpr int size = tensor_size<dim>;
  const T zero{}, one = zero + 1.;
  const bool has_grains = law.range > 0;
  HypoplasticPiece<dim, T> piece;
  piece.void_ratio = (1. + void_ratio) * exponential(trace(strain)) - 1.;
  piece.error = zero;
  const Intergranular<dim, T> before(law, grains, strain);
  const HypoplasticState<dim, T> begin(law, stress, void_ratio);
  const SymTensor<dim, T> first = stress_change(law, begin, before, grains, strain);
  for (int k = 0; k < size; ++k) piece.stress[k] = stress[k] + first[k];

  const T change = double_dot(first, first), most = small_change * begin.ratio.pressure;
  auto is_large = acts & (change > most * most);
  if (has_grains) {
    piece.grains = explicit_grains(before, grains, strain);
    is_large = is_large | (acts & (double_dot(strain, strain) > zero + std::pow(small_change_of_grains * law.range, 2)));
  }
  if (any(is_large)) [[unlikely]] {
    const SymTensor<dim, T> end_grains = implicit_grains(law, grains, strain, before.evolved);
    const Intergranular<dim, T> after(law, end_grains, strain);
    const SymTensor<dim, T> second =
        stress_change(law, HypoplasticState<dim, T>(law, piece.stress, piece.void_ratio), after, end_grains, strain);
    SymTensor<dim, T> difference;
    for (int k = 0; k < size; ++k) {
      difference[k] = 0.5 * (second[k] - first[k]);
      piece.stress[k] = is_large ? piece.stress[k] + difference[k] : piece.stress[k];
    }
    T error = square_root(double_dot(difference, difference)) / (begin.ratio.pressure * piece_error);
    if (has_grains) {
      const SymTensor<dim, T> alternative = implicit_grains(law, grains, strain, after.evolved);
      for (int k = 0; k < size; ++k) {
        difference[k] = 0.5 * (alternative[k] - piece.grains[k]);
        piece.grains[k] = is_large ? piece.grains[k] + difference[k] : piece.grains[k];
      }
      error = larger(error, square_root(double_dot(difference, difference)) * (law.per_range / piece_error_of_grains));
    }
    piece.error = is_large ? error : zero;
  }
  if (has_grains) {
    const T length = square_root(double_dot(piece.grains, piece.grains)), range = zero + law.range;
    const T part = length > range ? range / length : one;
    for (int k = 0; k < size; ++k) piece.grains[k] = part * piece.grains[k];
  }
  // Lanes without a particle have no stress, which must not count.
  const T mean = trace(piece.stress) * (1. / 3), square = double_dot(piece.stress, piece.stress);
  const auto beyond = acts & ((mean > zero - law.min_pressure) | (square > (3 + 9 * surely_within) * (mean * mean)));
  if (any(beyond)) [[unlikely]]
    keep_in_compression(piece.stress, law.min_pressure);
  return piece;
}

/// Advances `stress` (Pa, tension positive) by an increment of any duration, in pieces by Heun's method, whose difference from Euler's sets their size. Pieces
/// are halved and doubled, so that they do not change with the strain where it is differentiated.
template <int dim, class T>
[[gnu::always_inline]] inline void update(const PreparedHypoplastic& law, SymTensor<dim, T>& stress, const Increment<dim, T>& increment,
                                          T* state)
{
  constexpr int size = tensor_size<dim>;
  const T zero{}, one = zero + 1.;
  T left = one, part = one, void_ratio = state[0];
  SymTensor<dim, T> grains;
  for (int k = 0; k < size; ++k) grains[k] = state[1 + k];
  auto acts = increment.active;
  for (int n = 0; n < most_pieces && any(acts); ++n) {
    SymTensor<dim, T> strain;
    for (int k = 0; k < size; ++k) strain[k] = part * increment.strain[k];
    const HypoplasticPiece<dim, T> piece = piece_of(law, stress, void_ratio, grains, strain, acts);
    const auto holds = acts & ((piece.error <= one) | (part <= zero + least_piece));
    for (int k = 0; k < size; ++k) {
      stress[k] = holds ? piece.stress[k] : stress[k];
      if (law.range > 0) grains[k] = holds ? piece.grains[k] : grains[k];
    }
    void_ratio = holds ? piece.void_ratio : void_ratio;
    left = holds ? left - part : left;
    const T factor =
        piece.error <= one ? (piece.error < zero + 0.125 ? zero + 2. : one) : (piece.error <= zero + 16. ? zero + 0.5 : zero + 0.25);
    part = smaller(larger(part * factor, zero + least_piece), left);
    acts = acts & (left > zero);
  }
  if (law.range > 0)
    for (int k = 0; k < size; ++k) state[1 + k] = increment.active ? grains[k] : state[1 + k];
  state[0] = increment.active ? void_ratio : state[0];
}

}  // namespace berm::material
