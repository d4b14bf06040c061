// SPDX-License-Identifier: BSD-3-Clause
// JSON that programs of berm leave for others. The first byte of an input says what the rest is: s summary.json, h history.schema.json, o origin.json, r study.json.
// Refused in one line, or without a text that could end a line of what is made from it.
#include "target.hpp"

#include "os/control_characters.hpp"
#include "run_folder/history.hpp"
#include "run_folder/origin.hpp"
#include "run_folder/summary_file.hpp"
#include "study/study_rows.hpp"

using namespace berm;

namespace {

void promise_plain(const std::string& text)
{
  promise(!has_control_character(text), "texts have no control characters", text);
}

void look_at(const run_folder::RunSummary& summary)
{
  summary.finished();
  for (const auto& [name, text] : summary.text) promise_plain(name), promise_plain(text);
  for (const run_folder::Quantity& q : summary.quantities) promise_plain(q.name), promise_plain(q.unit), promise_plain(q.meaning);
  for (const std::string& warning : summary.warnings) promise_plain(warning);
  for (const std::string& why : summary.invalid) promise_plain(why);
}

void look_at(const run_folder::Origin& origin)
{
  origin.begins();
  for (const auto& [name, hash] : origin.input) promise_plain(name), promise_plain(hash);
  for (const run_folder::RunSession& session : origin.sessions) {
    promise_plain(session.begun), promise_plain(session.version), promise_plain(session.build);
    for (const auto& [name, hash] : session.program) promise_plain(name), promise_plain(hash);
  }
  promise_plain(origin.case_file);
  for (const std::string& set : origin.set) promise_plain(set);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const MemoryFolder folder;
  const auto [kind, text] = kind_and_text(data, size, 's');
  const char* const name = kind == 'h' ? "history.schema.json" : kind == 'o' ? "origin.json" : kind == 'r' ? "study.json" : "summary.json";
  folder.hold(name, text);
  may_be_refused([&, &kind = kind] {
    if (kind == 'h') {
      for (const run_folder::Column& column : run_folder::read_schema(folder.path() / "history.csv"))
        promise_plain(column.name), promise_plain(column.label), promise_plain(column.unit), promise_plain(column.meaning);
    } else if (kind == 'o') {
      look_at(run_folder::read_origin(folder.path()).value());
    } else if (kind == 'r') {
      const auto rows = study::read_rows(folder.path());
      for (const study::SavedRow& row : rows.value())
        for (const std::string& part : row.names) promise_plain(part);
    } else {
      look_at(run_folder::read_summary(folder.path()).value());
    }
  });
  return 0;
}
