// SPDX-License-Identifier: BSD-3-Clause
#include "user_law/library.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

namespace berm::user_law::this_file {
namespace {

std::string message_of(const std::function<void()>& act)
{
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(Library, that_is_missing_says_how_to_build_it)
{
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "law.so";
  EXPECT_EQ(message_of([&] { open_library(file); }), "there is no " + file.string() + "; build it first");
  std::ofstream(folder.path() / "Makefile") << "all:\n";
  EXPECT_NE(message_of([&] { open_library(file); }).find("build it first: make -C "), std::string::npos);
}

TEST(Library, that_is_none_says_what_the_loader_says)
{
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "law.so";
  std::ofstream(file) << "no library at all, but a text that is longer than the header of one would be, or so it seems to be";
  EXPECT_NE(message_of([&] { open_library(file); }).find("does not load: "), std::string::npos);
  EXPECT_TRUE(functions_in(file).empty());
}

TEST(Library, finds_the_first_name_that_is_there)
{
  void* const library = open_library(BERM_TRIAL_LAWS).handle;
  EXPECT_EQ(find_function(library, BERM_TRIAL_LAWS, {"no_such", "patient", "fails"}).name, "patient");
}

TEST(Library, is_another_where_its_bytes_are)
{
  const TemporaryFolder folder;
  const std::filesystem::path other = folder.path() / "other.so";
  std::filesystem::copy_file(BERM_TRIAL_LAWS, other);
  std::ofstream(other, std::ios::app) << '\n';
  const Library first = open_library(BERM_TRIAL_LAWS), second = open_library(other);
  EXPECT_NE(first.handle, second.handle);
  EXPECT_NE(first.sha256, second.sha256);
  EXPECT_EQ(open_library(other).handle, second.handle);
}

TEST(Library, that_is_not_the_one_that_was_looked_at_is_refused)
{
  EXPECT_NE(message_of([&] { open_library(BERM_TRIAL_LAWS, std::string(64, '0')); }).find("does not have the SHA-256"), std::string::npos);
}

TEST(Library, without_the_function_lists_those_it_has)
{
  void* const library = open_library(BERM_TRIAL_LAWS).handle;
  const std::string message = message_of([&] { find_function(library, BERM_TRIAL_LAWS, {"umat_", "umat"}); });
  EXPECT_NE(message.find("has no function umat_ or umat; it has aborts, berm_law, "), std::string::npos) << message;
}

TEST(Library, that_is_cut_off_anywhere_is_read_without_a_crash)
{
  std::ifstream whole(BERM_TRIAL_LAWS, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "part.so";
  const std::size_t all = functions_in(BERM_TRIAL_LAWS).size();
  EXPECT_GE(all, 10u);
  for (std::size_t size = 0; size < bytes.size(); size += bytes.size() / 37) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes.substr(0, size);
    EXPECT_LE(functions_in(file).size(), all);
  }
}

}  // namespace
}  // namespace berm::user_law::this_file
