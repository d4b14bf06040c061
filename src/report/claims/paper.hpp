// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"

// M. Maglia, N. M. Pinyol and C. Hoffman: Material Point Method modelling of offshore unburied cable/pipe interacting with soil.

namespace berm::report {

/// What the paper states of its test, in metres, diameters and N/m. It gives forces in kN and neither length nor scale. The curves show them per metre run of the model, as V is read.
constexpr Real paper_diameter = 0.02;
constexpr Real paper_V_push = 4000, paper_w_push = 0.1;  ///< section 3.4: 4 kN at 0.1 D, and held in the drag
constexpr Real paper_u_drag = 0.3, paper_w_drag = 0.25;  ///< section 3.4: after 0.3 D the embedment is 0.25 D, its maximum
constexpr std::pair<Real, Real> paper_H_fem[] = {{0.1, 1000.}, {0.25, 2000.}};  ///< section 3.4: wished in place at w, dragged: H

/// Whether a run has the pipe and the sand of the paper's centrifuge test: D = 20 mm at 50 g, phi = 35 deg without cohesion, E = 7 MPa, nu = 0.25, friction
/// of the interface 2/3 phi.
bool is_of_paper(const pipe::RunRecord& run);

/// A number that the paper states, in a chart of V over w, H over u or w over u; without x it is a level.
struct PaperPoint {
  const char* chart;      ///< "V_w", "H_u" or "w_u"
  std::optional<Real> x;  ///< m
  Real y;                 ///< N/m or m
  std::string label;
};

/// What the paper states; empty unless a run is of its test.
std::vector<PaperPoint> paper_points(const std::vector<pipe::RunRecord>& runs);

}  // namespace berm::report
