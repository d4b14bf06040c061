// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "run_folder/summary.hpp"
#include "structures/base/driven_body.hpp"
#include "structures/driven/path.hpp"

#include <map>
#include <optional>

namespace berm::driven {

using base::BodyScale;

/// A point of a push.
struct PushPoint {
  Real w, V;  ///< m, N/m
};

/// V after a travel of a push that begins with the body in the bed.
struct TravelPoint {
  Real travel, V;  ///< m, N/m
};

/// A point of a drag; u counts from where it began.
struct DragPoint {
  Real u, w, H, V;  ///< m, m, N/m, N/m
};

/// H of a drag at a displacement: the largest, over the curve averaged to its very end, or that at breakout.
struct DragPeak {
  Real u, H;  ///< m, N/m
};

/// Where results are taken, over D: V in the push at each multiple; after a travel of a push that begins with the body in the bed; in the drag.
constexpr Real push_spacing = 0.05;
constexpr Real travel_points[] = {0.0025, 0.005, 0.01, 0.02, 0.03};
constexpr Real drag_points[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5, 6, 8, 10};

/// What a limit or a force of the input gives, and a run only meets.
struct Prescribed {
  bool u = false, w = false, H = false, V = false;  ///< where the stage ends
  bool w_always = false, V_always = false;          ///< all along the drag
};

/// How far a force moves the body. u counts along x from where the stage began.
struct Displacements {
  Real u_largest = nan, u_end = nan;  ///< m; of the largest size
  Real w_largest = nan, w_end = nan;  ///< m
  Real largest_half_cycle = nan;      ///< m, largest way between two turns
  Real half_cycles = 0;               ///< ways between turns, of at least a hundredth of D
  std::optional<Real> time_half_D{},
      time_D{};                      ///< s of the load history since the start of the stage: when the body first is 0.5 D and D from there
  std::optional<Real> time_scale{};  ///< of a force that varies: time of the run over that of its load history
};

/// A way between two turns.
struct HalfCycle {
  Real begin_s, end_s;  ///< since the start of the stage
  Real u_begin, u_end;  ///< m, from where the stage began
  Real w_end;           ///< m
};

/// A drag. H is positive where the soil resists; u counts along the drag from where it began.
struct DragResults {
  std::string stage{};
  std::vector<DragPoint> points{};         ///< at some parts of D
  std::optional<DragPeak> largest{};       ///< of any drag that has begun
  std::optional<DragPeak> breakout{};      ///< the first peak (results/resistance.hpp)
  std::optional<Real> onset{};             ///< N/m, at which it begins to slide, without such a peak
  std::optional<DragPoint> end{};          ///< means over the last tenth of the travel, at least the last 0.1 D; u and w of the end itself
  std::optional<Real> residual{};          ///< N/m, the plateau of H (results/resistance.hpp)
  std::optional<Real> berm{};              ///< N/m, H at the end against a berm
  std::optional<Real> V{};                 ///< N/m, mean once it is what it shall be
  std::optional<Real> over_penetration{};  ///< the largest V of the push over V
  std::optional<Real> H_noise{}, V_rms_error{};        ///< bare numbers; V's where it is held
  std::optional<Real> berm_height{}, berm_distance{};  ///< m, of the berm at the end (results/mechanism.hpp)
  std::optional<Real> remoulded_depth{};               ///< m below the lowest point of the body, of clay that softens, at the end
  std::optional<Real> remoulded_area{};                ///< of that clay, over D^2
  std::optional<Displacements> moved{};                ///< of a drag by force
  Prescribed given{};
};

/// How a body in the soil resists when it is lifted: R = -V, what pulls it down.
struct UpliftResults {
  std::string stage{};
  DragPeak largest{nan, nan};      ///< travel upwards, m, and R, N/m: the peak where R falls after it
  Real half_travel = nan;          ///< m, travel at which R first is half of that
  Real w_begin = nan;              ///< m, embedment from which it is lifted
  std::optional<DragPoint> end{};  ///< u: travel; H: R, its mean over the end; V unused

  /// Whether R is less at the end by 5 % or more, and largest before the last tenth of the travel, whose mean the end is.
  bool falls() const { return end && end->H < 0.95 * largest.H && largest.u < 0.9 * end->u; }
};

/// A push that unloads or lifts the body, or that follows a drag: where it ends.
struct OtherPushResults {
  std::string stage;
  Real w, V;  ///< m, N/m
  Prescribed given{};
};

/// The body at rest between its travels (results/states.hpp).
struct StateResults {
  std::string name;
  Real w, V;             ///< m, N/m
  bool V_given = false;  ///< by the input
};

/// What of a driven body's run is worth a number of its own. A number that is not known, or that does not apply, is left out.
struct Results {
  std::vector<PushPoint> push;        ///< at each 0.05 D
  std::optional<PushPoint> push_end;  ///< or where the run was stopped in it
  Prescribed push_given;
  std::vector<TravelPoint> travel;
  std::vector<OtherPushResults> other_pushes;
  std::vector<UpliftResults> uplifts;
  std::vector<DragResults> drags;                      ///< in the order in which they ran
  std::size_t main = 0;                                ///< the drag whose resistance is the answer
  std::vector<StateResults> states;                    ///< where there is more than a push and drags right after it
  std::optional<Real> V_noise, second_impulse_over_V;  ///< bare numbers, of the push
  std::optional<Real> overlap_max, gap_mean;           ///< m

  /// The first drag, and the main one; nothing in it where there is none.
  const DragResults& drag() const;
  const DragResults& main_drag() const;
  /// What the names of a drag's numbers begin with: "" of the first, else its stage and a dot.
  std::string prefix_of(const DragResults& drag) const;
};

/// The name of a quantity at a part of D: V_at_w_0.1D.
std::string name_at(const char* what, Real part);

/// The results as summary.json tells them, each force and length with its dimensionless twin: forces over gamma' D^2 (suffix _over_gammaD2, in plane strain),
/// lengths over D (_over_D). The names of the first drag stand alone (H_max); those of later stages begin with the stage's name and a dot (back.H_max). `moving`: what is said behind
/// the meaning of lengths at an end at which the body still moves, by the push, drag or state that they are of.
std::vector<run_folder::Quantity> quantities_of(const Results& results, const BodyScale& scale,
                                                const std::map<std::string, std::string>& moving = {});

/// The results that such quantities tell of a case's stages; what is not among them is left out.
Results results_of(const std::vector<run_folder::Quantity>& quantities, const BodyScale& scale, const Stages& stages);

}  // namespace berm::driven
