// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/problem/ledger_test.cpp
#pragma once

#include "contact/contact_sums.hpp"
#include "core/archive.hpp"

#include <tuple>

namespace berm::problem {

/// Of the deformable bodies. kinetic + internal + damping + filter + friction = external + what the method itself adds or loses.
template <int dim>
struct Totals {
  Real internal = 0;                           ///< work stored and dissipated by the material
  Real viscosity = 0;                          ///< of it dissipated by the bulk viscosity
  Real external = 0;                           ///< work of gravity, of tractions and of the driven rigid bodies
  Real damping = 0;                            ///< taken out by local damping
  Real filter = 0;                             ///< taken out of particle velocities that the nodes cannot carry
  Real friction = 0;                           ///< taken out at the contacts
  Vec<dim> first_momentum = Vec<dim>::Zero();  ///< at the start; then the impulses given to the bodies since
  Vec<dim> gravity_impulse = Vec<dim>::Zero();
  Vec<dim> traction_impulse = Vec<dim>::Zero();
  Vec<dim> contact_impulse = Vec<dim>::Zero();
  Vec<dim> support_impulse = Vec<dim>::Zero();
  Vec<dim> damping_impulse = Vec<dim>::Zero();
  Vec<dim> flow_impulse = Vec<dim>::Zero();  ///< of water whose flux changes
};

/// What has been given and taken since the start, per metre run (in space: in all): the difference of two moments is what was between them.
/// Whoever gives an impulse adds to its member; what goes over all of them loops over their rows (for_each_sum).
template <int dim>
struct Ledger {
  Totals<dim> totals;
  std::vector<contact::ContactSums<dim>> contact_sums;  ///< by rigid body
  std::vector<std::vector<Real>> slice_impulses;        ///< by rigid body and slice (DepthSlices): given to the soil along the bed
  std::vector<std::vector<Real>> slice_shaft_impulses;  ///< the same: given to the soil upwards by sides that are upright
  std::vector<Vec<dim>> pair_impulses;                  ///< by contact: what the other body gave to the body; zero at rigid bodies
  std::vector<Vec<dim>> rigid_impulses;                 ///< by contact of rigid bodies: what the other body gave to the first
  std::vector<Vec<dim>> support_impulses;               ///< by support that is reported: given to the soil
};

/// Of what each there is a sum.
enum class Owner { run, rigid_body, slices, contact, rigid_contact, support };
constexpr const char* words_of_owners[] = {"run", "rigid_body", "slices", "contact", "rigid_contact", "support"};

/// The balance of the deformable bodies that a row enters.
enum class Balance {
  none,
  energy,        ///< together with their kinetic energy
  energy_given,  ///< the other side of it
  momentum       ///< an impulse that they are given
};

/// A row of the ledger: a sum, whose it is, its unit in the plane (in space: times m), and the member that has it, a number or a vector.
template <class Of, class Member>
struct LedgerRow {
  const char* name;
  Owner owner;
  const char* unit;
  Balance balance;
  Member Of::*member;
};

template <int dim>
constexpr auto rows_of_run = std::tuple{LedgerRow{"internal", Owner::run, "J/m", Balance::energy, &Totals<dim>::internal},
                                        LedgerRow{"viscosity", Owner::run, "J/m", Balance::none, &Totals<dim>::viscosity},
                                        LedgerRow{"damping", Owner::run, "J/m", Balance::energy, &Totals<dim>::damping},
                                        LedgerRow{"filter", Owner::run, "J/m", Balance::energy, &Totals<dim>::filter},
                                        LedgerRow{"friction", Owner::run, "J/m", Balance::energy, &Totals<dim>::friction},
                                        LedgerRow{"external", Owner::run, "J/m", Balance::energy_given, &Totals<dim>::external},
                                        LedgerRow{"first_momentum", Owner::run, "N s/m", Balance::none, &Totals<dim>::first_momentum},
                                        LedgerRow{"gravity", Owner::run, "N s/m", Balance::momentum, &Totals<dim>::gravity_impulse},
                                        LedgerRow{"traction", Owner::run, "N s/m", Balance::momentum, &Totals<dim>::traction_impulse},
                                        LedgerRow{"contact", Owner::run, "N s/m", Balance::momentum, &Totals<dim>::contact_impulse},
                                        LedgerRow{"support", Owner::run, "N s/m", Balance::momentum, &Totals<dim>::support_impulse},
                                        LedgerRow{"damping_impulse", Owner::run, "N s/m", Balance::momentum, &Totals<dim>::damping_impulse},
                                        LedgerRow{"flow", Owner::run, "N s/m", Balance::momentum, &Totals<dim>::flow_impulse}};

template <int dim, class Sums = contact::ContactSums<dim>>
constexpr auto rows_of_rigid_bodies =
    std::tuple{LedgerRow{"impulse", Owner::rigid_body, "N s/m", Balance::none, &Sums::impulse},
               LedgerRow{"torque_impulse", Owner::rigid_body, "N s", Balance::none, &Sums::torque_impulse},
               LedgerRow{"second_impulse", Owner::rigid_body, "N s/m", Balance::none, &Sums::second_impulse},
               LedgerRow{"impulse_sum", Owner::rigid_body, "N s/m", Balance::none, &Sums::impulse_sum},
               LedgerRow{"impulse_times_gap", Owner::rigid_body, "N s", Balance::none, &Sums::impulse_times_gap},
               LedgerRow{"shaft_impulse", Owner::rigid_body, "N s/m", Balance::none, &Sums::shaft_impulse},
               LedgerRow{"effective_impulse", Owner::rigid_body, "N s/m", Balance::none, &Sums::effective_impulse}};

/// The members of these are lists, by owner.
template <int dim>
constexpr auto rows_of_others =
    std::tuple{LedgerRow{"impulses", Owner::slices, "N s/m", Balance::none, &Ledger<dim>::slice_impulses},
               LedgerRow{"shaft_impulses", Owner::slices, "N s/m", Balance::none, &Ledger<dim>::slice_shaft_impulses},
               LedgerRow{"impulse", Owner::contact, "N s/m", Balance::none, &Ledger<dim>::pair_impulses},
               LedgerRow{"impulse", Owner::rigid_contact, "N s/m", Balance::none, &Ledger<dim>::rigid_impulses},
               LedgerRow{"impulse", Owner::support, "N s/m", Balance::none, &Ledger<dim>::support_impulses}};

/// Calls visit(row) for the rows of a list.
template <class Rows, class Visit>
void for_each_row(const Rows& rows, const Visit& visit)
{
  std::apply([&](const auto&... row) { (visit(row), ...); }, rows);
}

/// Calls act(row, owner, sum) for all sums: the number of the owner, and what it has in the ledger, a number, a vector or a list of numbers;
/// then in others with the same owners.
template <int dim, class Act, class L, class... Others>
void for_each_sum(const Act& act, L& ledger, Others&... others)
{
  for_each_row(rows_of_run<dim>, [&](const auto& row) { act(row, 0, ledger.totals.*row.member, others.totals.*row.member...); });
  for_each_row(rows_of_rigid_bodies<dim>, [&](const auto& row) {
    for (std::size_t r = 0; r < ledger.contact_sums.size(); ++r)
      act(row, r, ledger.contact_sums[r].*row.member, others.contact_sums[r].*row.member...);
  });
  for_each_row(rows_of_others<dim>, [&](const auto& row) {
    for (std::size_t k = 0; k < (ledger.*row.member).size(); ++k) act(row, k, (ledger.*row.member)[k], (others.*row.member)[k]...);
  });
}

/// What has been given and taken from one moment to another.
template <int dim>
Ledger<dim> difference(const Ledger<dim>& before, Ledger<dim> after)
{
  const auto subtract = [](const auto&, std::size_t, auto& sum, const auto& earlier) {
    if constexpr (requires { sum -= earlier; })
      sum -= earlier;
    else
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] -= earlier[k];
  };
  for_each_sum<dim>(subtract, after, before);
  return after;
}

/// What a restart needs of it.
template <int dim>
void archive(Archive& k, Ledger<dim>& ledger);

}  // namespace berm::problem
