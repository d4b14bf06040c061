// SPDX-License-Identifier: BSD-3-Clause
#include "contact/contact_law.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace berm::contact::this_file {
namespace {

/// A number between two others; the ends are likely.
Real number_between(Real min, Real max)
{
  return min + (max - min) * *rc::gen::inRange(0, 10001) / 10000;
}

/// Velocities up to 2 m/s, a unit normal and an interface.
template <int dim>
struct NodeNeighbourhood {
  Vec<dim> relative, normal;
  Interface interface;

  NodeNeighbourhood()
  {
    for (int d = 0; d < dim; ++d) relative[d] = number_between(-2, 2), normal[d] = number_between(-1, 1);
    RC_PRE(normal.norm() > 1e-2);
    normal.normalize();
    interface = {number_between(0, 1.5), *rc::gen::element(0., 0.3), *rc::gen::element(0., 0.1, 1., 10.)};
  }
  /// The change of velocity that one correction makes of a point of 3 kg.
  Vec<dim> change() const { return contact_impulse<dim>(relative, normal, {3, 3}, interface, Vec<dim>::Zero()) / 3; }
  Vec<dim> along(const Vec<dim>& v) const { return v - v.dot(normal) * normal; }
  Real approach() const { return -relative.dot(normal); }
};

constexpr Real round_off = 1e-14;  // of velocities of a few m/s

template <int dim>
void approach_never_grows_and_ends_at_what_is_allowed()
{
  const NodeNeighbourhood<dim> m;
  const Real after = -(m.relative + m.change()).dot(m.normal);
  RC_ASSERT(after <= m.approach() + round_off);
  if (m.approach() > m.interface.allowed_approach)
    RC_ASSERT(std::abs(after - m.interface.allowed_approach) < round_off);
  else
    RC_ASSERT(m.change().isZero(0));
}

template <int dim>
void there_is_no_tension()
{
  const NodeNeighbourhood<dim> m;
  RC_ASSERT(m.change().dot(m.normal) >= -round_off);
}

template <int dim>
void friction_stays_below_its_limit_and_is_spent_before_anything_slides()
{
  const NodeNeighbourhood<dim> m;
  const Vec<dim> change = m.change(), slip = m.along(m.relative + change);
  const Real push = change.dot(m.normal), limit = m.interface.friction * push + m.interface.adhesion_impulse / 3;
  RC_ASSERT(m.along(change).norm() <= limit + round_off);
  if (push > round_off) {
    if (m.along(m.relative).norm() <= limit)
      RC_ASSERT(slip.norm() < round_off);  // it sticks: no slip is left
    else
      RC_ASSERT(std::abs(m.along(change).norm() - limit) < round_off);  // it slides: the whole limit acts
    // Friction never turns the slip round.
    RC_ASSERT(slip.dot(m.along(m.relative)) >= -round_off);
    RC_ASSERT(m.along(change).dot(m.along(m.relative)) <= round_off);
  }
}

template <int dim>
void energy_of_the_relative_motion_never_grows()
{
  const NodeNeighbourhood<dim> m;
  RC_ASSERT((m.relative + m.change()).squaredNorm() <= m.relative.squaredNorm() + round_off);
}

template <int dim>
Matrix<dim> random_turn()
{
  // Turns in the planes of two axes after each other.
  Matrix<dim> turn = Matrix<dim>::Identity();
  for (int a = 0; a < dim; ++a)
    for (int b = a + 1; b < dim; ++b) {
      const Real angle = number_between(-pi, pi);
      Matrix<dim> one = Matrix<dim>::Identity();
      one(a, a) = one(b, b) = std::cos(angle);
      one(b, a) = std::sin(angle);
      one(a, b) = -one(b, a);
      turn = one * turn;
    }
  return turn;
}

template <int dim>
void turned_input_gives_the_turned_answer()
{
  NodeNeighbourhood<dim> m;
  // Within rounding of sticking, of touching: either answer is right, and they differ by no more than rounding; so no such case is left out.
  const Vec<dim> change = m.change();
  const Matrix<dim> turn = random_turn<dim>();
  m.relative = turn * m.relative;
  m.normal = turn * m.normal;
  const Real push = std::abs(change.dot(m.normal));
  RC_PRE(std::abs(m.approach() - m.interface.allowed_approach) > 1e-12 || push == 0);
  RC_ASSERT((m.change() - turn * change).norm() < 1e-12);
}

template <int dim>
void size_of_the_velocities_does_not_matter()
{
  NodeNeighbourhood<dim> m;
  const Vec<dim> change = m.change();
  m.relative *= 4;  // a power of two scales without rounding
  m.interface.adhesion_impulse *= 4;
  m.interface.allowed_approach *= 4;
  RC_ASSERT((m.change() - 4 * change).norm() == 0);
}

#define BERM_IN_PLANE_AND_SPACE(claim)                                                                                                     \
  RC_GTEST_PROP(ContactCorrection, claim##_in_plane, ())                                                                                   \
  {                                                                                                                                        \
    claim<2>();                                                                                                                            \
  }                                                                                                                                        \
  RC_GTEST_PROP(ContactCorrection, claim##_in_space, ())                                                                                   \
  {                                                                                                                                        \
    claim<3>();                                                                                                                            \
  }
BERM_IN_PLANE_AND_SPACE(approach_never_grows_and_ends_at_what_is_allowed)
BERM_IN_PLANE_AND_SPACE(there_is_no_tension)
BERM_IN_PLANE_AND_SPACE(friction_stays_below_its_limit_and_is_spent_before_anything_slides)
BERM_IN_PLANE_AND_SPACE(energy_of_the_relative_motion_never_grows)
BERM_IN_PLANE_AND_SPACE(turned_input_gives_the_turned_answer)
BERM_IN_PLANE_AND_SPACE(size_of_the_velocities_does_not_matter)

TEST(ContactCorrection, of_known_meetings)
{
  const Vec<2> up(0, 1), none_yet(0, 0);
  const auto change = [&](const Vec<2>& relative, const Interface& interface) {
    return Vec<2>(contact_impulse<2>(relative, up, {2, 2}, interface, none_yet) / 2);
  };
  // Falls at 3 m/s, slides at 2 m/s, mu = 0.5: stopped, and slowed by 1.5 m/s.
  EXPECT_NEAR((change(Vec<2>(2, -3), {0.5, 0, 0}) - Vec<2>(-1.5, 3)).norm(), 0, 1e-15);
  // 0.2 N s of adhesion more, on 2 kg.
  EXPECT_NEAR((change(Vec<2>(2, -3), {0.5, 0.2, 0}) - Vec<2>(-1.6, 3)).norm(), 0, 1e-15);
  // A gap allows 2 m/s of the approach: only the rest is stopped, and only it makes friction.
  EXPECT_NEAR((change(Vec<2>(2, -3), {0.5, 0, 2}) - Vec<2>(-0.5, 1)).norm(), 0, 1e-15);
  // Parting surfaces leave each other alone, adhesion or not.
  EXPECT_EQ(change(Vec<2>(2, 1e-9), {0.5, 1, 0}).norm(), 0);
  // Without friction and adhesion the slip stays.
  EXPECT_NEAR((change(Vec<2>(2, -3), {0, 0, 0}) - Vec<2>(0, 3)).norm(), 0, 1e-15);
  EXPECT_EQ(change(Vec<2>(0, -3), {0.5, 0, 0}), Vec<2>(0, 3));
  // Welded: all of the motion is taken, parting too.
  EXPECT_EQ(change(Vec<2>(2, 3), {0, 0, 0, true}), Vec<2>(-2, -3));
}

template <int dim>
void an_impulse_that_is_right_already_stays()
{
  const NodeNeighbourhood<dim> m;
  const Vec<dim> impulse = contact_impulse<dim>(m.relative, m.normal, {3, 3}, m.interface, Vec<dim>::Zero());
  const Vec<dim> after = m.relative + impulse / 3;
  const Vec<dim> again = contact_impulse<dim>(after, m.normal, {3, 3}, m.interface, impulse);
  RC_ASSERT((again - impulse).norm() < 1e-13);
}

template <int dim>
void an_impulse_that_is_too_large_is_taken_back()
{
  // The point carries far too much, and flies off with it: the law finds the impulse of the first correction again.
  const NodeNeighbourhood<dim> m;
  const Vec<dim> right = contact_impulse<dim>(m.relative, m.normal, {3, 3}, m.interface, Vec<dim>::Zero());
  const Vec<dim> too_much = right + 50 * m.normal;
  const Vec<dim> found = contact_impulse<dim>(m.relative + too_much / 3, m.normal, {3, 3}, m.interface, too_much);
  RC_ASSERT((found - right).norm() < 1e-12);
}

template <int dim>
void held_points_keep_their_distance_and_stuck_ones_their_place()
{
  const NodeNeighbourhood<dim> m;
  for (const ContactStatus status : {ContactStatus::slipping, ContactStatus::sticking}) {
    const Vec<dim> held = m.relative + bilateral_impulse<dim>(m.relative, m.normal, {3, 3}, m.interface, status, Vec<dim>::Zero()) / 3;
    RC_ASSERT(std::abs(held.dot(m.normal) + m.interface.allowed_approach) < 1e-13);
    RC_ASSERT((m.along(held) - (status == ContactStatus::sticking ? Vec<dim>(Vec<dim>::Zero()) : m.along(m.relative))).norm() < 1e-13);
  }
}

/// The neighbourhood with a bond.
template <int dim>
struct BondedNeighbourhood : NodeNeighbourhood<dim> {
  BondedNeighbourhood() { this->interface.tension_impulse = *rc::gen::element(0.1, 2., infinity); }
};

template <int dim>
void a_bond_holds_what_parts_up_to_its_tension()
{
  const BondedNeighbourhood<dim> m;
  const Vec<dim> impulse = 3 * m.change();
  const Real normal = impulse.dot(m.normal), most = m.interface.tension_impulse, parting = m.relative.dot(m.normal);
  RC_ASSERT(normal >= -most - round_off);
  if (parting > 0) RC_ASSERT(std::abs(normal + std::min(most, 3 * parting)) < 1e-13);
  // Within the speed at which a gap may close nothing acts along the normal.
  if (parting <= 0 && -parting <= m.interface.allowed_approach) RC_ASSERT(std::abs(normal) < round_off);
  // What is pulled at has no friction, but adhesion.
  if (normal < 0) RC_ASSERT((impulse - normal * m.normal).norm() <= m.interface.adhesion_impulse + 1e-13);
  const Vec<dim> again = contact_impulse<dim>(m.relative + impulse / 3, m.normal, {3, 3}, m.interface, impulse);
  RC_ASSERT((again - impulse).norm() < 1e-12);
}

template <int dim>
void energy_never_grows_where_points_are_bonded()
{
  const BondedNeighbourhood<dim> m;
  RC_ASSERT((m.relative + m.change()).squaredNorm() <= m.relative.squaredNorm() + round_off);
}

TEST(ContactCorrection, of_bonded_points)
{
  const Vec<2> up(0, 1), none_yet(0, 0);
  const auto impulse = [&](const Vec<2>& relative, const Interface& interface) {
    return contact_impulse<2>(relative, up, {2, 2}, interface, none_yet);
  };
  // Parts at 3 m/s: held, or slowed by the 4 N s that it bears; adhesion of 0.2 N s acts along the surface, and no friction.
  EXPECT_NEAR((impulse(Vec<2>(0, 3), {0.5, 0, 0, false, infinity}) - Vec<2>(0, -6)).norm(), 0, 1e-15);
  EXPECT_NEAR((impulse(Vec<2>(2, 3), {0.5, 0.2, 0, false, 4}) - Vec<2>(-0.2, -4)).norm(), 0, 1e-15);
  // Pressed on, it is as any other.
  EXPECT_EQ(impulse(Vec<2>(2, -3), {0.5, 0.2, 0, false, 4}), impulse(Vec<2>(2, -3), {0.5, 0.2, 0}));
  EXPECT_EQ(status_of<2>(Vec<2>(0, -4), up, {0.5, 0.2, 0, false, 4}), ContactStatus::sticking);
  EXPECT_EQ(status_of<2>(Vec<2>(-0.2, -4), up, {0.5, 0.2, 0, false, 4}), ContactStatus::slipping);
}

TEST(ContactStatus, follows_from_the_impulse)
{
  const Vec<2> up(0, 1);
  const Interface interface {
    0.5, 0, 0
  };
  EXPECT_EQ(status_of<2>(Vec<2>(0, 0), up, interface), ContactStatus::open);
  EXPECT_EQ(status_of<2>(Vec<2>(0.4, 1), up, interface), ContactStatus::sticking);
  EXPECT_EQ(status_of<2>(Vec<2>(-0.5, 1), up, interface), ContactStatus::slipping);
  EXPECT_EQ(status_of<2>(Vec<2>(0.5, 1), up, {0.5, 0.1, 0}), ContactStatus::sticking);
  // What the law gives to a point that slides is at the limit, whatever the rounding.
  EXPECT_EQ(status_of<2>(contact_impulse<2>(Vec<2>(2.1, -3.3), up, {0.7, 0.7}, interface, Vec<2>(0, 0)), up, interface),
            ContactStatus::slipping);
}

TEST(ContactLaw, has_friction_on_what_the_water_leaves)
{
  const Vec<2> up(0, 1), none_yet(0, 0);
  const auto impulse = [&](const Vec<2>& relative, Real part, Real suction) {
    return contact_impulse<2>(relative, up, {2, 2}, {0.5, 0.2, 0, false, 4, part, suction}, none_yet);
  };
  // 6 N s along the normal, of which the water carries two thirds, or all; or suction adds 2.
  EXPECT_NEAR((impulse(Vec<2>(9, -3), 2. / 3, 0) - Vec<2>(-1.2, 6)).norm(), 0, 1e-14);
  EXPECT_NEAR((impulse(Vec<2>(9, -3), 1, 0) - Vec<2>(-0.2, 6)).norm(), 0, 1e-14);
  EXPECT_NEAR((impulse(Vec<2>(9, -3), 0, 2) - Vec<2>(-4.2, 6)).norm(), 0, 1e-14);
  // A bond that is pulled at with 3 N s: suction of 5 still presses the grains with 2; one of 1 does not.
  EXPECT_NEAR((impulse(Vec<2>(9, 1.5), 0, 5) - Vec<2>(-1.2, -3)).norm(), 0, 1e-14);
  EXPECT_NEAR((impulse(Vec<2>(9, 1.5), 0, 1) - Vec<2>(-0.2, -3)).norm(), 0, 1e-14);
  EXPECT_EQ(status_of<2>(Vec<2>(-1.2, 6), up, {0.5, 0.2, 0, false, 0, 2. / 3}), ContactStatus::slipping);
  EXPECT_EQ(status_of<2>(Vec<2>(-1.2, 6), up, {0.5, 0.2, 0, false, 0, 0.5}), ContactStatus::sticking);
}

TEST(ContactLaw, works_with_a_mass_along_the_surface_of_its_own)
{
  const Vec<2> impulse = contact_impulse<2>(Vec<2>(0.5, -3), Vec<2>(0, 1), {2, 10}, {1, 0, 0}, Vec<2>::Zero());
  EXPECT_EQ(impulse, Vec<2>(-5, 6));
}

BERM_IN_PLANE_AND_SPACE(an_impulse_that_is_right_already_stays)
BERM_IN_PLANE_AND_SPACE(an_impulse_that_is_too_large_is_taken_back)
BERM_IN_PLANE_AND_SPACE(a_bond_holds_what_parts_up_to_its_tension)
BERM_IN_PLANE_AND_SPACE(energy_never_grows_where_points_are_bonded)
BERM_IN_PLANE_AND_SPACE(held_points_keep_their_distance_and_stuck_ones_their_place)
#undef BERM_IN_PLANE_AND_SPACE

}  // namespace
}  // namespace berm::contact::this_file
