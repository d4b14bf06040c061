// SPDX-License-Identifier: BSD-3-Clause
#include "study/sample.hpp"

#include "samples/temporary_folder.hpp"
#include "study/table_axis.hpp"

#include <gtest/gtest.h>

namespace berm::study::this_file {
namespace {

using Words = std::vector<std::string>;

StudySample strength_and_factor()
{
  SampleParameter strength, factor;
  strength.name = "strength";
  strength.keys = {"a.b", "c.*.d"};
  strength.distribution = {DistributionKind::uniform, 1000, 3000, {}, {}, {}, "Pa"};
  factor.name = "factor";
  factor.times = {{"e.f", "2 kPa/m"}, {"g", "3"}};
  factor.distribution = {DistributionKind::normal, 0.5, 1.5, {}, {}, {}, ""};
  return {12, 3, {strength, factor}};
}

TEST(Sample, begins_with_the_medians_and_each_parameter_in_turn_at_its_5_and_95_percent)
{
  const StudyAxis axis = sample_axis(strength_and_factor());
  ASSERT_EQ(axis.value.size(), 5u + 12u);
  EXPECT_EQ(axis.sample_from, std::optional<std::size_t>(5));
  Words names;
  for (const StudyValue& value : axis.value) names.push_back(value.name);
  EXPECT_EQ(Words(names.begin(), names.begin() + 6), (Words{"best", "strength low", "strength high", "factor low", "factor high", "1"}));
  EXPECT_EQ(names.back(), "12");
  EXPECT_EQ(axis.value[0].set, (Words{"a.b=2000 Pa", "c.*.d=2000 Pa", "e.f=2000 Pa/m", "g=3"}));
  EXPECT_EQ(axis.value[1].set, (Words{"a.b=1100 Pa", "c.*.d=1100 Pa", "e.f=2000 Pa/m", "g=3"}));
  EXPECT_EQ(axis.value[4].set, (Words{"a.b=2000 Pa", "c.*.d=2000 Pa", "e.f=3000 Pa/m", "g=4.5"}));
}
TEST(Sample, has_a_row_in_each_part_of_every_parameter)
{
  const StudyAxis axis = sample_axis(strength_and_factor());
  std::vector<int> in_part(12);
  for (std::size_t k = 5; k < axis.value.size(); ++k) ++in_part.at(static_cast<std::size_t>((axis.value[k].number[0] - 1000) / 2000 * 12));
  EXPECT_EQ(in_part, std::vector<int>(12, 1));
}
TEST(Sample, is_another_with_another_seed)
{
  StudySample sample = strength_and_factor();
  const StudyAxis one = sample_axis(sample);
  EXPECT_EQ(samples_csv(sample_axis(sample)), samples_csv(one));
  sample.seed = 4;
  EXPECT_NE(samples_csv(sample_axis(sample)), samples_csv(one));
}
TEST(Sample, gives_each_row_a_seed_of_its_own_and_none_to_best_low_and_high)
{
  StudySample sample = strength_and_factor();
  sample.seeds = {"random_field.*.seed"};
  const StudyAxis axis = sample_axis(sample);
  EXPECT_EQ(axis.value[0].set.size(), 4u);
  EXPECT_EQ(axis.value[5].set.back(), "random_field.*.seed=25");  // the third sample of 12 rows
  EXPECT_EQ(axis.value.back().set.back(), "random_field.*.seed=36");
  EXPECT_NE(samples_csv(axis).find("random_field.*.seed"), std::string::npos);
}
TEST(Sample, of_seeds_alone_has_its_rows_alone)
{
  StudySample sample;
  sample.size = 5;
  sample.seeds = {"a.seed", "b.seed"};
  const StudyAxis axis = sample_axis(sample);
  EXPECT_EQ(axis.sample_from, std::optional<std::size_t>(0));
  ASSERT_EQ(axis.value.size(), 5u);
  EXPECT_EQ(axis.value[4].set, (Words{"a.seed=5", "b.seed=5"}));
  EXPECT_TRUE(axis.parameter.empty());
}
TEST(Sample, as_a_table_is_the_same_rows)
{
  const TemporaryFolder folder;
  const StudyAxis axis = sample_axis(strength_and_factor()), table = read_table(folder.write("samples.csv", samples_csv(axis)), "again");
  ASSERT_EQ(table.value.size(), 12u);
  EXPECT_EQ(table.sample_from, std::optional<std::size_t>(0));
  for (std::size_t k = 0; k < 12; ++k) {
    EXPECT_EQ(table.value[k].name, axis.value[5 + k].name);
    EXPECT_EQ(table.value[k].set, axis.value[5 + k].set);
  }
}

}  // namespace
}  // namespace berm::study::this_file
