// SPDX-License-Identifier: BSD-3-Clause
#include "io/sha256.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

namespace berm::io::this_file {
namespace {

/// Of the examples of FIPS 180-2, appendix B.
TEST(sha256, gives_the_published_digests)
{
  const TemporaryFolder place;
  EXPECT_EQ(sha256_of_file(place.write("abc", "abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_file(place.write("empty", "")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_file(place.write("million", std::string(1'000'000, 'a'))),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(sha256, of_what_cannot_be_read_is_an_error)
{
  const TemporaryFolder place;
  EXPECT_THROW(sha256_of_file(place / "nothing"), RunError);
  EXPECT_THROW(sha256_of_file(place.path()), RunError) << "a folder";
}

TEST(program_files, hold_the_program_and_the_libraries_that_are_asked_for)
{
  const std::vector<ProgramFile> files = program_files("libstdc++");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name, "test_io");
  EXPECT_EQ(sha256_of_file(files[0].path), sha256_of_file(std::filesystem::read_symlink("/proc/self/exe")));
  EXPECT_TRUE(files[1].name.starts_with("libstdc++"));
  EXPECT_EQ(files[1].path.filename(), files[1].name);
  EXPECT_EQ(program_files("libnothing").size(), 1u);
}

/// A library is loaded from a copy, which is then removed, as a new build does.
TEST(program_files, has_no_path_to_a_library_that_was_replaced)
{
  const TemporaryFolder place;
  const std::filesystem::path copy = place / "libreplaced.so";
  std::filesystem::copy_file(program_files("libstdc++").at(1).path, copy);
  void* const library = ::dlopen(copy.c_str(), RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << ::dlerror();
  EXPECT_EQ(program_files("libreplaced").at(1).path, copy);
  std::filesystem::remove(copy);
  place.write("libreplaced.so", "another one");
  const std::vector<ProgramFile> files = program_files("libreplaced");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[1].name, "libreplaced.so");
  EXPECT_EQ(files[1].path, "");
  ::dlclose(library);
}

std::string output_of(const std::string& command)
{
  std::string words;
  FILE* const pipe = ::popen(command.c_str(), "r");
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) words += static_cast<char>(c);
  return ::pclose(pipe) == 0 ? words : "failed: " + words;
}

/// This program again, which removes its own file first.
TEST(program_files, read_the_program_also_where_its_file_is_gone)
{
  if (const char* copy = std::getenv("BERM_TEST_COPY"); copy != nullptr) {
    std::filesystem::remove(copy);
    const ProgramFile program = program_files("libnothing").at(0);
    std::ofstream(std::string(copy) + ".digest") << program.name << ' ' << sha256_of_file(program.path);
    return;
  }
  const TemporaryFolder place;
  const std::filesystem::path copy = place / "program";
  std::filesystem::copy_file("/proc/self/exe", copy);
  const std::string libraries = program_files("libberm").at(1).path.parent_path().string();  // which it finds beside itself else
  const std::string words = output_of(fmt::format(
      "BERM_TEST_COPY='{0}' LD_LIBRARY_PATH='{1}' '{0}' --gtest_filter='*where_its_file_is_gone' 2>&1", copy.string(), libraries));
  EXPECT_EQ(place.read("program.digest"), "program " + sha256_of_file("/proc/self/exe")) << words;
}

}  // namespace
}  // namespace berm::io::this_file
