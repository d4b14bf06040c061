// SPDX-License-Identifier: BSD-3-Clause
#include "contact/friction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace berm {
namespace {

/// A number between two others; the ends are likely.
Real number_between(Real least, Real most)
{
  return least + (most - least) * *rc::gen::inRange(0, 10001) / 10000;
}

/// Velocities up to 2 m/s, a unit normal and an interface.
template <int dim>
struct Meeting {
  Vec<dim> relative, normal;
  Interface interface;

  Meeting()
  {
    for (int d = 0; d < dim; ++d) relative[d] = number_between(-2, 2), normal[d] = number_between(-1, 1);
    RC_PRE(normal.norm() > 1e-2);
    normal.normalize();
    interface = {number_between(0, 1.5), *rc::gen::element(0., 0.3), *rc::gen::element(0., 0.1, 1., 10.)};
  }
  Vec<dim> change() const { return contact_correction<dim>(relative, normal, interface); }
  Vec<dim> along(const Vec<dim>& v) const { return v - v.dot(normal) * normal; }
  Real approach() const { return -relative.dot(normal); }
};

constexpr Real round_off = 1e-14;  // of velocities of a few m/s

template <int dim>
void approach_never_grows_and_ends_at_what_is_allowed()
{
  const Meeting<dim> m;
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
  const Meeting<dim> m;
  RC_ASSERT(m.change().dot(m.normal) >= -round_off);
}

template <int dim>
void friction_stays_below_its_limit_and_is_spent_before_anything_slides()
{
  const Meeting<dim> m;
  const Vec<dim> change = m.change(), slip = m.along(m.relative + change);
  const Real push = change.dot(m.normal), limit = m.interface.friction * push + m.interface.adhesion_speed;
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
  const Meeting<dim> m;
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
  Meeting<dim> m;
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
  Meeting<dim> m;
  const Vec<dim> change = m.change();
  m.relative *= 4;  // a power of two scales without rounding
  m.interface.adhesion_speed *= 4;
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
#undef BERM_IN_PLANE_AND_SPACE

TEST(ContactCorrection, of_known_meetings)
{
  const Vec<2> up(0, 1);
  // Falls at 3 m/s, slides at 2 m/s, mu = 0.5: stopped, and slowed by 1.5 m/s.
  EXPECT_NEAR((contact_correction<2>(Vec<2>(2, -3), up, {0.5, 0, 0}) - Vec<2>(-1.5, 3)).norm(), 0, 1e-15);
  // 0.1 m/s of adhesion more.
  EXPECT_NEAR((contact_correction<2>(Vec<2>(2, -3), up, {0.5, 0.1, 0}) - Vec<2>(-1.6, 3)).norm(), 0, 1e-15);
  // A gap allows 2 m/s of the approach: only the rest is stopped, and only it makes friction.
  EXPECT_NEAR((contact_correction<2>(Vec<2>(2, -3), up, {0.5, 0, 2}) - Vec<2>(-0.5, 1)).norm(), 0, 1e-15);
  // Parting surfaces leave each other alone, adhesion or not.
  EXPECT_EQ(contact_correction<2>(Vec<2>(2, 1e-9), up, {0.5, 1, 0}).norm(), 0);
  // Without friction and adhesion the slip stays.
  EXPECT_NEAR((contact_correction<2>(Vec<2>(2, -3), up, {0, 0, 0}) - Vec<2>(0, 3)).norm(), 0, 1e-15);
  EXPECT_EQ(contact_correction<2>(Vec<2>(0, -3), up, {0.5, 0, 0}), Vec<2>(0, 3));
}

}  // namespace
}  // namespace berm
