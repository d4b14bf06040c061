// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/springs/design_test.cpp
#include "study/study_rows.hpp"

#include "io/atomic_file.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "run_folder/json_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <new>
#include <nlohmann/json.hpp>

namespace berm::study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// In the order of RowKind.
const std::vector<std::string> kinds = {"row", "best", "low", "high", "draw"};

RowKind kind_named(const std::string& name)
{
  const auto found = std::find(kinds.begin(), kinds.end(), name);
  if (found == kinds.end()) throw RunError(fmt::format("\"kind\" is none of {}", text_of_list(kinds, ", ")));
  return static_cast<RowKind>(found - kinds.begin());
}

RowKind kind_of(const StudyRow& row, const Study& study)
{
  const StudyAxis* axis = sample_of(study);
  if (axis == nullptr) return RowKind::row;
  const std::size_t place = row.choice[static_cast<std::size_t>(axis - study.axis.data()) + 1];
  if (place >= *axis->sample_from) return RowKind::draw;
  return place == 0 ? RowKind::best : place % 2 == 1 ? RowKind::low : RowKind::high;
}

}  // namespace

void write_rows(const StudyPlan& plan, const fs::path& output)
{
  const StudyAxis* axis = sample_of(plan.study);
  Json rows = Json::array();
  for (const StudyRow& row : plan.rows) {
    std::vector<std::string> names = row.names;
    if (axis != nullptr) names.erase(names.begin() + (axis - plan.study.axis.data()) + 1);
    rows.push_back({{"names", names},
                    {"kind", kinds[static_cast<std::size_t>(kind_of(row, plan.study))]},
                    {"run", row.job.folder.lexically_relative(output).generic_string()},
                    {"finished", row.end.kind == jobs::JobEnd::Kind::finished}});
  }
  const Json root = {{"title", plan.study.title}, {"rows", rows}};
  io::write_atomically(output / "study.json", root.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

std::optional<std::vector<SavedRow>> read_rows(const fs::path& output)
{
  const fs::path file = output / "study.json";
  if (!fs::exists(file)) return std::nullopt;
  const Json root = run_folder::read_json(file);
  try {
    std::vector<SavedRow> rows;
    for (const Json& row : root.at("rows"))
      rows.push_back({row.at("names").get<std::vector<std::string>>(), kind_named(row.at("kind").get<std::string>()),
                      output / row.at("run").get<std::string>(), row.at("finished").get<bool>()});
    return rows;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw RunError(fmt::format("{} is damaged: {}", file.string(), error.what()));
  }
}

}  // namespace berm::study
