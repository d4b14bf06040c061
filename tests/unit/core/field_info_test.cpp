// SPDX-License-Identifier: BSD-3-Clause
#include "core/field_info.hpp"

#include <gtest/gtest.h>

namespace berm::this_file {
namespace {

TEST(FieldInfo, components_are_named_as_numbers_vectors_and_tensors_are)
{
  const auto name = [](int components, int component, int dim) { return component_name({"f", "", "", components}, component, dim); };
  EXPECT_EQ(name(1, 0, 2), "f");
  EXPECT_EQ(name(2, 1, 2), "f_y");
  EXPECT_EQ(name(3, 2, 3), "f_z");
  EXPECT_EQ(name(4, 3, 2), "f_xy");
  EXPECT_EQ(name(6, 5, 3), "f_zx");
  EXPECT_EQ(name(3, 2, 2), "f_2");
}

TEST(FieldInfo, goes_where_its_set_says)
{
  const FieldInfo field{"f", "", "", 1, to_checkpoint | with_particle};
  EXPECT_TRUE(field.goes(to_checkpoint) && field.goes(with_particle));
  EXPECT_FALSE(field.goes(to_frame) || field.goes(must_be_finite));
}

}  // namespace
}  // namespace berm::this_file
