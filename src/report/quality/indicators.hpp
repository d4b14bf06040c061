// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/pipe/run_record.hpp"
#include "text/html.hpp"

namespace berm::report {

/// Up to which value something is good, beyond which it is bad, and why just there. With `large` it is the other way round: good from `good` on, bad
/// below `bad`.
struct Limit {
  Real good, bad;
  const char* reason;
  bool large = false;
};

/// How a value stands; unknown where it is NaN.
text::Standing judge(const Limit& limit, Real value);

namespace limits {

inline constexpr Limit energy{
    0.01, 0.05,
    "a smaller mpm.courant lowers it; at D/20 the probe test has 0.1 % (examples/mesh_study), the published contact "
    "scheme makes 0.4 to 1.5 % (examples/contact_schemes)"};
inline constexpr Limit energy_of_fem{
    0.01, 0.05, "stress and contact forces grow in a straight line within an increment: a smaller fem.largest_step lowers it"};
inline constexpr Limit kinetic{
    0.05, 0.10, "the usual rule for explicit programs: a few per cent of the internal energy, or inertia is part of the answer"};
inline constexpr Limit out_of_balance{
    0.01, 0.05, "a bed that has not settled at all has 0.09, a settled one 0.001 of its weight (docs/theory.md, section 5)"};
inline constexpr Limit held{0.05, 0.10, "the drag is to hold V within 5 % (examples/probe_test)"};
inline constexpr Limit shaking{
    0.07, 0.15,
    "the push of the probe test has 0.05 at D/10; where it had 0.11, V was 5 % too low, and where it had 0.21, 68 % (docs/decisions/0017)"};
inline constexpr Limit at_bounds{0.001, 0.01, "soil at a bound of its volume no longer follows its law (docs/theory.md, section 7)"};
inline constexpr Limit in_the_air{0.001, 0.01, "grains that fly carry nothing"};
inline constexpr Limit noise_of_V{0.02, 0.05,
                                  "the probe test has 1.2 % at D/40, 1.8 % at D/20, 2.2 % at D/10, 2.9 % at D/5 (examples/mesh_study)"};
inline constexpr Limit noise_of_H{
    0.09, 0.18,
    "sand without cohesion slides in jerks: 4 to 13 % in the first 0.2 D, whatever the contact scheme (examples/contact_schemes)"};
inline constexpr Limit gap{
    0.17, 0.25,
    "half a particle's width, 0.11 of a cell with 9 particles and 0.16 with 4, is no gap; contact at all nodes of cut cells holds soil off "
    "at 0.18 to 0.28 and makes V 10 to 28 % larger (examples/contact_schemes)"};
inline constexpr Limit overlap{0.002, 0.01, "no particle should be deeper than 0.002 D in the pipe (examples/probe_test)"};
inline constexpr Limit second_impulse{0.01, 0.05,
                                      "the second contact correction is no force; with every contact scheme it stays below 0.7 % of V "
                                      "(examples/contact_schemes)"};
inline constexpr Limit momentum{1e-9, 1e-6, "impulses add up to the change of momentum to round-off, or the program is wrong"};
inline constexpr Limit cells{
    20, 10, "in the push of the probe test V(0.1 D) is 14 % above that of D/40 at D/20, and 28 % at D/10 (examples/mesh_study)", true};
inline constexpr Limit shear_bands{
    0.05, 0.25,
    "V(0.1 D) of the probe test, which can lose 18 %, falls from 0.92 to 0.56 kN/m with cells of D/10 to D/80 (examples/localisation)"};
inline constexpr Limit particles{9, 4, "use nine or more near the pipe: with four stresses scatter more (docs/theory.md, section 9)", true};
inline constexpr Limit elements{
    40, 20, "D/40 is what berm's own studies use (examples/wip_study); half the size should change little where psi = phi", true};
inline constexpr Limit unbalance{1, 10, "over fem.tolerance: at most one is called equilibrium"};
inline constexpr Limit loose{0, 0.1, "increments that did not converge leave forces that nothing carries"};
inline constexpr Limit lag{
    0.01, 0.05,
    "an increment is solved again until its own lag is 1 %; with the lag of large increments V was 20 to 25 % too small "
    "(docs/decisions/0013)"};
inline constexpr Limit overstress{0.01, 0.05,
                                  "far below 0.01 it is right; above 0.05 the soil cannot carry the force (docs/how_to/run_a_case.md)"};

}  // namespace limits

/// Where the energies balance worst.
struct EnergyError {
  Real over_work;     ///< the largest error over the largest work, as summary.json has it, else as the history has it
  std::string where;  ///< "drag, u = 18 mm"; "" where it is not known
};
EnergyError energy_error(const pipe::RunRecord& run);

/// The largest kinetic over internal energy in the stages of a list, beyond the first tenth of the rows of each (internal energy begins at nothing); NaN
/// where there are no such rows.
Real kinetic_over_internal(const pipe::RunRecord& run, const std::vector<std::string>& stages);

/// The energy that contact (friction_J_m) gave in all, where it should take some, over the largest work; 0 where it took some, NaN without a history.
Real work_of_contact(const pipe::RunRecord& run);

/// Whether a drag of the run holds a vertical force.
bool holds_force(const problem::Case& settings);

/// A quantity's value, NaN where there is none.
Real quantity_value(const pipe::RunRecord& run, const std::string& name);

/// The mean contact gap in cells of the mesh near the pipe, and how much larger the pipe acts, at most: 2 gap / D.
Real gap_in_cells(const pipe::RunRecord& run);
Real acts_larger(const pipe::RunRecord& run);

}  // namespace berm::report
