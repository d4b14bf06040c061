// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint with anything wrong is refused with a reason, and the one before it is used.
#include "samples/temporary_folder.hpp"

#include "run_folder/checkpoint_folder.hpp"

#include <csignal>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace berm::run_folder::this_file {
namespace {

namespace fs = std::filesystem;

/// Something of every kind.
struct Thing {
  Real real = 0.1, nan = std::numeric_limits<Real>::quiet_NaN();
  Index index = -7;
  BigIndex big = BigIndex(1) << 40;
  bool yes = true, no = false;
  std::optional<Real> given = -0., absent;
  Vec<3> vec{1, 2, -3};
  std::vector<Real> reals = {1e-310, -infinity, 3}, nothing;
  std::vector<Index> indices = {5, 4};
  std::string text = "a = \"b\"\n", no_text;

  void archive(Archive& k)
  {
    k("real", real);
    k("nan", nan);
    k("index", index);
    k("big", big);
    k("yes", yes);
    k("no", no);
    k.table("inner", [&] {
      k("given", given);
      k("absent", absent);
      k.table("most", [&] { k("vec", vec); });
    });
    k("reals", reals);
    k("nothing", nothing);
    k("indices", indices);
    k("text", text);
    k("no_text", no_text);
  }
};

/// A thing of which nothing is as it should be.
Thing other_thing()
{
  Thing t;
  t.real = t.nan = 5;
  t.index = 0, t.big = 0;
  t.yes = false, t.no = true;
  t.given.reset();
  t.absent = 7;
  t.vec.setZero();
  t.reals.clear();
  t.nothing = {1, 2};
  t.indices = {0};
  t.text = "", t.no_text = "some";
  return t;
}

void expect_same(const Thing& a, const Thing& b)
{
  EXPECT_EQ(a.real, b.real);
  EXPECT_TRUE(std::isnan(b.nan));
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.big, b.big);
  EXPECT_EQ(a.yes, b.yes);
  EXPECT_EQ(a.no, b.no);
  ASSERT_TRUE(b.given.has_value());
  EXPECT_TRUE(*b.given == 0 && std::signbit(*b.given));
  EXPECT_FALSE(b.absent.has_value());
  EXPECT_EQ(a.vec, b.vec);
  EXPECT_EQ(a.reals, b.reals);
  EXPECT_EQ(a.nothing, b.nothing);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.text, b.text);
  EXPECT_EQ(a.no_text, b.no_text);
}

/// What reading says; "" where the file is taken.
std::string refusal(const fs::path& file, Thing& thing)
{
  try {
    read_checkpoint(file, [&](Archive& k) { thing.archive(k); });
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}
std::string refusal(const fs::path& file)
{
  Thing thing;
  return refusal(file, thing);
}

class Checkpoint : public testing::Test {
protected:
  Checkpoint()
  {
    Thing thing;
    write_checkpoint(file_, [&](Archive& k) { thing.archive(k); });
    content_ = folder_.read("sample.h5");
  }
  std::string refusal_of(const std::string& content) const { return refusal(folder_.write("changed.h5", content)); }
  std::string with_header(const std::string& from, const std::string& to) const
  {
    std::string changed = content_;
    changed.replace(changed.find(from), from.size(), to);
    return changed;
  }

  TemporaryFolder folder_;
  fs::path file_ = folder_ / "sample.h5";
  std::string content_;
};

TEST_F(Checkpoint, gives_back_what_was_kept)
{
  Thing thing = other_thing();
  EXPECT_EQ(refusal(file_, thing), "");
  expect_same(Thing(), thing);
  EXPECT_FALSE(fs::exists(folder_ / "sample.h5.part"));
}

TEST_F(Checkpoint, is_refused_with_any_byte_damaged)
{
  const int bit_sets[] = {0x01, 0xff};
  for (std::size_t at = 0; at < content_.size(); ++at)
    for (const int bits : bit_sets) {
      std::string damaged = content_;
      damaged[at] = static_cast<char>(damaged[at] ^ bits);
      ASSERT_NE(refusal_of(damaged), "") << "byte " << at << " of " << content_.size();
    }
}

TEST_F(Checkpoint, is_refused_at_any_other_length)
{
  for (std::size_t length = 0; length < content_.size(); ++length) ASSERT_NE(refusal_of(content_.substr(0, length)), "") << length;
  EXPECT_NE(refusal_of(content_ + '\0'), "");
  EXPECT_NE(refusal_of(content_ + content_), "");
}

TEST_F(Checkpoint, that_cannot_be_used_is_refused_with_the_reason)
{
  std::string damaged = content_;
  damaged.back() = static_cast<char>(damaged.back() ^ 4);
  EXPECT_EQ(refusal_of(damaged), "it is damaged");
  EXPECT_EQ(refusal_of("time_s,stage\n"), "it is not a checkpoint of berm");
  EXPECT_EQ(refusal_of(content_.substr(512)), "it is not a checkpoint of berm") << "an HDF5 file of somebody else";
  EXPECT_EQ(refusal_of(""), "it is not a checkpoint of berm");
  const std::string own = fmt::format("format {}\n", checkpoint_format), reads = fmt::format("this one reads format {}", checkpoint_format);
  const int newer = checkpoint_format + 1;
  EXPECT_EQ(refusal_of(with_header(own, fmt::format("format {}\n", newer))),
            fmt::format("it has format {}, that of a newer berm; {}", newer, reads));
  EXPECT_EQ(refusal_of(with_header(own, "format 3\n")),
            "it has format 3, that of an older berm; " + reads + ": finish the run with that version, or start it again");
  const std::string other = refusal_of(with_header("berm 0.", "berm 7."));
  EXPECT_EQ(other.find("it was written by berm 7."), 0u) << other;
  for (const char* odd : {"berm \x1b.", "berm \x7f.", "berm \xff."}) EXPECT_EQ(refusal_of(with_header("berm 0.", odd)), "it is damaged");
  EXPECT_EQ(refusal(folder_ / "missing.h5"), "it cannot be read: No such file or directory");
}

TEST_F(Checkpoint, of_other_contents_is_refused)
{
  const auto reading = [&](const Contents& contents) {
    try {
      read_checkpoint(file_, contents);
    } catch (const RunError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  Real real = 0;
  Index index = 0;
  Vec<2> vec = Vec<2>::Zero();
  EXPECT_EQ(reading([&](Archive& k) { k("density", real); }), "it has no density");
  EXPECT_EQ(reading([&](Archive& k) { k("index", real); }), "index has the wrong type");
  EXPECT_EQ(reading([&](Archive& k) { k("real", index); }), "real has the wrong type");
  EXPECT_EQ(reading([&](Archive& k) { k("inner", real); }), "it has no inner");
  EXPECT_EQ(reading([&](Archive& k) { k("reals", real); }), "reals has 3 numbers instead of 1");
  EXPECT_EQ(reading([&](Archive& k) { k.table("inner", [&] { k.table("most", [&] { k("vec", vec); }); }); }),
            "inner/most/vec has 3 numbers instead of 2");
}

TEST_F(Checkpoint, with_control_characters_in_a_text_is_refused)
{
  for (const char c : {'\0', '\x1b', '\r', '\x7f'}) {
    Thing thing;
    thing.text = std::string("a") + c + "b";
    write_checkpoint(folder_ / "odd.h5", [&](Archive& k) { thing.archive(k); });
    EXPECT_EQ(refusal(folder_ / "odd.h5"), "text is not text");
  }
}

TEST_F(Checkpoint, that_cannot_be_written_leaves_the_one_before_it_alone)
{
  rlimit limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &limit), 0);
  std::signal(SIGXFSZ, SIG_IGN);
  for (std::size_t max = 0; max < content_.size(); max += 97) {
    const rlimit small = {max, limit.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    Thing thing = other_thing();
    EXPECT_THROW(write_checkpoint(file_, [&](Archive& k) { thing.archive(k); }), RunError) << "a file of at most " << max << " bytes";
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
    EXPECT_FALSE(fs::exists(folder_ / "sample.h5.part"));
  }
  Thing thing = other_thing();
  EXPECT_EQ(refusal(file_, thing), "");
  expect_same(Thing(), thing);
}

/// A folder with checkpoints of one number.
class InCheckpointFolder : public testing::Test {
protected:
  void write(BigIndex step)
  {
    Real value = static_cast<Real>(step);
    folder_.begin(step, [&](Archive& k) { k("value", value); })();
  }
  /// The number that is read, and what was said before.
  Real read(CheckpointFolder folder)
  {
    Real value = -1;
    const fs::path file =
        folder.read([&](Archive& k) { k("value", value); },
                    [&](const fs::path& refused, const std::string& why) { said_ += refused.filename().string() + ": " + why + "\n"; });
    return file.empty() ? -1 : value;
  }
  std::string names() const
  {
    std::string all;
    for (const fs::path& file : folder_.files()) all += file.filename().string() + " ";
    return all;
  }
  void damage(const std::string& name) const { base_.write("run/" + name, fmt::format("berm checkpoint, format {}\n", checkpoint_format)); }

  TemporaryFolder base_;
  CheckpointFolder folder_{base_ / "run"};
  std::string said_;
};

TEST_F(InCheckpointFolder, the_last_two_are_kept)
{
  EXPECT_EQ(read(folder_), -1);
  for (const int step : {7, 99, 100, 1234}) write(step);
  EXPECT_EQ(names(), "step_1234.h5 step_100.h5 ");
  EXPECT_EQ(read(CheckpointFolder(base_ / "run")), 1234);
  EXPECT_EQ(said_, "");
}

TEST_F(InCheckpointFolder, the_older_is_used_where_the_newer_is_damaged)
{
  write(99);
  write(100);
  damage("step_100.h5");
  CheckpointFolder later(base_ / "run");
  EXPECT_EQ(read(later), 99);
  EXPECT_EQ(said_, "step_100.h5: it is damaged\n");
}

TEST_F(InCheckpointFolder, the_one_that_was_used_stays_beside_the_next_and_the_damaged_goes)
{
  write(99);
  write(500);
  damage("step_500.h5");
  Real value = 0;
  folder_ = CheckpointFolder(base_ / "run");
  folder_.read([&](Archive& k) { k("value", value); }, [](const fs::path&, const std::string&) {});
  write(200);
  EXPECT_EQ(names(), "step_200.h5 step_99.h5 ");
}

TEST_F(InCheckpointFolder, it_is_an_error_where_all_are_damaged)
{
  write(99);
  write(100);
  damage("step_99.h5");
  damage("step_100.h5");
  try {
    read(folder_);
    FAIL() << "is taken";
  } catch (const RunError& error) {
    EXPECT_EQ(std::string(error.what()).find("none of the checkpoints in"), 0u) << error.what();
  }
  EXPECT_EQ(said_, "step_100.h5: it is damaged\nstep_99.h5: it is damaged\n");
}

TEST_F(InCheckpointFolder, other_files_are_left_alone)
{
  write(5);
  for (const char* name : {"run/step_x.h5", "run/step_.h5", "run/step_6.h5.part", "run/notes.txt", "run/step_7.h"})
    base_.write(name, "mine");
  EXPECT_EQ(names(), "step_5.h5 ");
  write(6);
  write(7);
  for (const char* name : {"step_x.h5", "step_.h5", "notes.txt"}) EXPECT_TRUE(fs::exists(base_ / "run" / name)) << name;
}

}  // namespace
}  // namespace berm::run_folder::this_file
