// SPDX-License-Identifier: BSD-3-Clause
// What the page says of the mesh below its measures of trust.
#include "structures/structures.hpp"

#include "samples/made_run.hpp"

#include <gtest/gtest.h>

namespace berm::driven::this_file {
namespace {

std::string note_of(const MadeRun& made)
{
  const record::RunRecord run = made.record();
  return structures::structure_of(run.settings).quality_note({{&run, 0}});
}

TEST(QualityNote, warns_of_sand_that_localises_and_of_no_other_soil)
{
  MadeRun made;
  made.law.dilation_angle = 0;
  EXPECT_NE(note_of(made).find("sand with psi below phi localises in bands as wide as the cells"), std::string::npos);
  EXPECT_EQ(note_of(MadeRun{}), "") << "psi = phi";
  made.method = settings::Method::fem;
  EXPECT_EQ(note_of(made), "") << "small strains and no particles";
  MadeRun clay;
  clay.law = MadeRun::clay_law();
  EXPECT_EQ(note_of(clay), "");
}

}  // namespace
}  // namespace berm::driven::this_file
