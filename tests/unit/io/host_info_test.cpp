// SPDX-License-Identifier: BSD-3-Clause
#include "io/host_info.hpp"

#include <gtest/gtest.h>
#include <regex>

namespace berm::io::this_file {
namespace {

TEST(machine, processor_is_read_from_cpuinfo)
{
  EXPECT_EQ(processor_model("processor\t: 0\nvendor_id\t: X\nmodel\t\t: 17\nmodel name\t: AMD EPYC  9B14 \nstepping\t: 1\n"),
            "AMD EPYC 9B14");
}

TEST(machine, processor_without_a_name_is_left_out)
{
  EXPECT_EQ(processor_model(""), "");
  EXPECT_EQ(processor_model("processor\t: 0\nBogoMIPS\t: 50.00\n"), "");
}

TEST(machine, line_tells_processors_and_system)
{
  const std::string words = host_description();
  EXPECT_TRUE(std::regex_match(words, std::regex("(.+, )?[1-9][0-9]* processors?, Linux [0-9]+(\\.[0-9]+)? \\w+"))) << words;
}

TEST(machine, date_is_iso_in_utc)
{
  EXPECT_EQ(utc_date(std::chrono::system_clock::from_time_t(0)), "1970-01-01T00:00:00Z");
  EXPECT_EQ(utc_date(std::chrono::system_clock::from_time_t(1769860800)), "2026-01-31T12:00:00Z");
}

}  // namespace
}  // namespace berm::io::this_file
