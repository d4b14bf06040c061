// SPDX-License-Identifier: BSD-3-Clause
// The printing itself is tested with a browser in tests/browser.
#include "report/page/report.hpp"

#include "os/error.hpp"
#include "samples/temporary_folder.hpp"

#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>

namespace berm::report::this_file {
namespace {

namespace fs = std::filesystem;

/// Environment variables that are as before when this ends.
class Environment {
public:
  void set(const char* name, const std::string& value)
  {
    const char* before = std::getenv(name);
    before_.emplace_back(name, before == nullptr ? "" : before);
    ::setenv(name, value.c_str(), 1);
  }
  ~Environment()
  {
    for (auto entry = before_.rbegin(); entry != before_.rend(); ++entry)
      entry->second.empty() ? ::unsetenv(entry->first) : ::setenv(entry->first, entry->second.c_str(), 1);
  }

private:
  std::vector<std::pair<const char*, std::string>> before_;
};

/// A program in the folder that says where it was asked to print to.
fs::path program(const TemporaryFolder& place, const std::string& name, const std::string& text)
{
  const fs::path file = place.write(name, "#!/bin/sh\n" + text);
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

std::string message_of(const std::function<void()>& act)
{
  try {
    act();
  } catch (const RunError& error) {
    return error.what();
  }
  return "";
}

TEST(print_pdf, needs_a_browser_and_says_what_to_install)
{
  const TemporaryFolder place;
  Environment environment;
  environment.set("BERM_BROWSER", "");
  environment.set("PATH", place.path().string());
  const std::string message = message_of([] { printing_browser(); });
  for (const char* part : {"google-chrome", "apt-get install chromium", "BERM_BROWSER"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  const fs::path found = program(place, "google-chrome", "exit 0\n");
  EXPECT_EQ(printing_browser(), found);
  environment.set("BERM_BROWSER", "/no/such/program");
  EXPECT_NE(message_of([] { printing_browser(); }).find("/no/such/program"), std::string::npos);
}

TEST(print_pdf, takes_what_the_browser_prints_and_refuses_what_is_no_pdf)
{
  const TemporaryFolder place;
  const std::string takes = "for word; do case \"$word\" in --print-to-pdf=*) to=\"${word#*=}\";; file://*) page=\"$word\";; esac; done\n";
  const fs::path good = program(place, "good", takes + "printf '%%PDF-1.4 %s' \"$page\" > \"$to\"\n");
  print_pdf(good, place / "a page.html", place / "a.pdf");
  EXPECT_NE(place.read("a.pdf").find("/a%20page.html"), std::string::npos) << place.read("a.pdf");
  const fs::path bad = program(place, "bad", takes + "echo no display; exit 3\n");
  const std::string message = message_of([&] { print_pdf(bad, place / "a page.html", place / "a.pdf"); });
  for (const char* part : {"exit status 3", "no display"}) EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_TRUE(place.read("a.pdf").starts_with("%PDF-1.4")) << "an older file stays";
  const fs::path empty = program(place, "empty", takes + ": > \"$to\"\n");
  EXPECT_NE(message_of([&] { print_pdf(empty, place / "a page.html", place / "a.pdf"); }), "");
}

}  // namespace
}  // namespace berm::report::this_file
