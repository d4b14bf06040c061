// SPDX-License-Identifier: BSD-3-Clause
// A study.toml of `berm study`, and the same text as an expected.toml of `berm verify` and `berm report`.
#include "target.hpp"

#include "expectations/expectation.hpp"
#include "os/error.hpp"
#include "study/study_settings.hpp"

using namespace berm;

namespace {

void promise_file_name(const std::string& name)
{
  const std::string file = study::as_file_name(name);
  const bool inside = !file.empty() && file.find('/') == std::string::npos && file.find_first_not_of('.') != std::string::npos;
  promise(inside, "a name as a file stays in its folder", file);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const MemoryFile file;
  try {
    const study::Study study = study::read_study(file.hold(data, size));
    for (const study::StudyCase& c : study.cases) promise_file_name(c.name);
    for (const study::StudyFigure& figure : study.figure) promise_file_name(figure.name);
  } catch (const InputError& error) {
    promise_one_line(error.what());
  }
  try {
    expectations::read_expectations_text("expected.toml", text_of(data, size));
  } catch (const InputError& error) {
    promise_one_line(error.what());
  }
  return 0;
}
