// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/commands/report_test.cpp
#include "os/text_of_list.hpp"
#include "report/page/page.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "picture/stage_words.hpp"
#include "text/base64_zlib.hpp"
#include "text/html.hpp"

#include <fmt/format.h>

namespace berm::report {
namespace {

constexpr std::size_t max_stages = 5;  // in a line

std::string stages_in_a_line(const settings::Case& c)
{
  std::vector<std::string> stages;
  for (const settings::StageSettings& stage : c.stage) {
    if (stages.size() == max_stages) break;
    stages.push_back(text::html_text(picture::stage_words(stage, c.force_dimension())));
  }
  const std::size_t more = c.stage.size() - stages.size();
  return fmt::format("{}{}", text_of_list(stages, "; "), more == 0 ? "" : fmt::format("; {} more", more));
}

/// The picture as a part of the page; "" where there is none.
std::string picture_of(const std::filesystem::path& file)
{
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return "";
  try {
    return text::base64(io::read_text_file(file));
  } catch (const RunError&) {
    return "";
  }
}

}  // namespace

FirstLook first_look(const record::RunRecord& run)
{
  FirstLook look{fmt::format("<p class=\"quiet\">Stages: {}.</p>\n", stages_in_a_line(run.settings)), ""};
  if (const std::string picture = picture_of(run.folder / "soil.png"); !picture.empty())
    look.picture =
        fmt::format("<figure><img src=\"data:image/png;base64,{}\" alt=\"The soil around the driven body at the end, coloured by strain\">"
                    "<figcaption class=\"quiet\">The soil at the end of {}</figcaption></figure>\n",
                    picture, text::html_text(run.name));
  return look;
}

}  // namespace berm::report
