// SPDX-License-Identifier: BSD-3-Clause
#include "problem/ledger.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

namespace berm::problem::this_file {
namespace {

/// Two owners of each kind, and other numbers in all sums.
template <int dim>
Ledger<dim> full_ledger(Real first)
{
  Ledger<dim> ledger;
  ledger.contact_sums.resize(2);
  ledger.slice_impulses = ledger.slice_shaft_impulses = {{0, 0, 0}, {}};
  ledger.pair_impulses = ledger.rigid_impulses = ledger.support_impulses = std::vector<Vec<dim>>(2, Vec<dim>::Zero());
  for_each_sum<dim>(
      [&](const auto&, std::size_t, auto& sum) {
        if constexpr (requires { sum.begin(); })
          for (Real& number : sum) number = first++;
        else
          sum = first++;
      },
      ledger);
  return ledger;
}

template <class Dimension>
class LedgerOf : public testing::Test {
};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(LedgerOf, Dimensions);

TYPED_TEST(LedgerOf, has_every_number_in_a_row_of_its_own)
{
  constexpr int dim = TypeParam::value;
  Ledger<dim> ledger = full_ledger<dim>(1);
  std::set<std::string> names;
  std::size_t rows = 0;
  for_each_sum<dim>(
      [&](const auto& row, std::size_t owner, const auto&) {
        names.insert(fmt::format("{} {} {}", words_of_owners[static_cast<int>(row.owner)], owner, row.name));
        EXPECT_STRNE(row.unit, "");
        ++rows;
      },
      ledger);
  EXPECT_EQ(names.size(), rows);
  const auto* totals = reinterpret_cast<const Real*>(&ledger.totals);
  for (std::size_t k = 0; k < sizeof(Totals<dim>) / sizeof(Real); ++k) EXPECT_NE(totals[k], 0) << "number " << k << " of the totals";
  const auto* sums = reinterpret_cast<const Real*>(&ledger.contact_sums[1]);
  for (std::size_t k = 0; k < sizeof(contact::ContactSums<dim>) / sizeof(Real); ++k)
    EXPECT_NE(sums[k], 0) << "number " << k << " of a body";
}

TYPED_TEST(LedgerOf, difference_is_what_came_between)
{
  constexpr int dim = TypeParam::value;
  const Ledger<dim> between = difference<dim>(full_ledger<dim>(1), full_ledger<dim>(8));
  for_each_sum<dim>(
      [&](const auto& row, std::size_t, const auto& sum) {
        if constexpr (requires { sum.begin(); })
          for (const Real number : sum) EXPECT_EQ(number, 7) << row.name;
        else
          EXPECT_EQ(sum, 7) << row.name;
      },
      between);
}

}  // namespace
}  // namespace berm::problem::this_file
