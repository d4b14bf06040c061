// SPDX-License-Identifier: BSD-3-Clause
// What a checkpoint says of other files is compared with them before the run goes on.
#include "samples/temporary_folder.hpp"

#include "simulation/checkpoints.hpp"

#include <gtest/gtest.h>

namespace berm::simulation::this_file {
namespace {

TEST(CheckpointOfHistory, is_refused_with_a_length_that_the_file_has_not)
{
  const TemporaryFolder folder;
  const auto history = folder.write("history.csv", "time_s,stage\n0,rest\n");
  const auto refusal_of = [&](BigIndex bytes, BigIndex crc) {
    run_folder::write_checkpoint(folder / "file.h5", [&](Archive& k) { k("bytes", bytes), k("crc", crc); });
    BigIndex found = 0;
    try {
      run_folder::read_checkpoint(folder / "file.h5", [&](Archive& k) { archive_history(k, history, found); });
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const BigIndex whole = 20, crc_of_whole = *run_folder::crc_of(history, whole);
  EXPECT_EQ(refusal_of(whole, crc_of_whole), "");
  EXPECT_EQ(refusal_of(0, 0), "");
  constexpr BigIndex max = std::numeric_limits<BigIndex>::max();
  for (const BigIndex bytes : {-1, -5, 19, 21}) EXPECT_NE(refusal_of(bytes, crc_of_whole), "") << bytes;
  for (const BigIndex bytes : {BigIndex(-5), BigIndex(-1), BigIndex(21), max, -max - 1})
    for (const BigIndex crc : {-1, 0}) EXPECT_NE(refusal_of(bytes, crc), "") << bytes << " " << crc;
}

TEST(Checkpoints, that_cannot_be_written_end_no_run_and_the_next_one_is_written)
{
  const TemporaryFolder folder;
  Checkpoints checkpoints(folder.path(), 0);
  Real number = 0;
  const auto contents = [&](Archive& k) { k("number", number); };
  io::WriterThread thread;
  const auto write = [&](BigIndex step) {
    checkpoints.write(
        step, contents, thread, [] {}, [] {});
    thread.finish();
    return checkpoints.tell();
  };
  number = 1;
  EXPECT_TRUE(write(1));
  // A folder where the file is to be made.
  std::filesystem::create_directories(checkpoints_in(folder.path()) / "step_2.h5.part/in_the_way");
  number = 2;
  EXPECT_FALSE(write(2));
  ASSERT_TRUE(checkpoints.read(contents));
  EXPECT_EQ(number, 1);
  number = 3;
  EXPECT_TRUE(write(3));
  number = 0;
  ASSERT_TRUE(checkpoints.read(contents));
  EXPECT_EQ(number, 3);
}

}  // namespace
}  // namespace berm::simulation::this_file
