// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/actions.hpp"

#include "desk/http.hpp"
#include "desk/live.hpp"
#include "desk/runs.hpp"
#include "io/atomic_file.hpp"
#include "os/control_characters.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <sstream>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

/// A name that is no option and no path.
std::string plain_word(const std::string& word, const char* key)
{
  const bool right = !word.empty() && word.size() < 200 && std::isalnum(static_cast<unsigned char>(word[0])) != 0 &&
                     std::all_of(word.begin(), word.end(),
                                 [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == ',' || c == '.'; });
  if (!right) throw Refusal(400, fmt::format("{} is not allowed for \"{}\"", one_line(word), key), {{"key", key}});
  return word;
}

/// --KEY and the word or number that the body gives it; nothing where it gives none.
void append_options(std::vector<std::string>& words, const Json& body, const std::vector<const char*>& keys)
{
  for (const char* key : keys) {
    const auto found = body.find(key);
    if (found == body.end() || found->is_null()) continue;
    if (!found->is_string() && !found->is_number())
      throw Refusal(400, fmt::format("\"{}\" is neither text nor a number", key), {{"key", key}});
    words.insert(words.end(), {fmt::format("--{}", key), found->is_string() ? plain_word(found->get<std::string>(), key) : found->dump()});
  }
}

void append(std::vector<std::string>& words, const std::vector<std::string>& more)
{
  words.insert(words.end(), more.begin(), more.end());
}

/// The last line of a message that a command ends with, without its name.
std::string reason_in(const std::string& messages)
{
  std::istringstream lines(messages);
  std::string reason = "the command failed and does not say why";
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("berm: ")) reason = line.substr(6);
  return one_line(reason);
}

/// The JSON that a command printed; its messages may stand before and behind it.
Json json_in(const std::string& text)
{
  for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) == std::string::npos ? text.size() : text.find('\n', at) + 1) {
    const char open = text[at];
    if (open != '[' && open != '{') continue;
    const std::size_t end = text.rfind(open == '[' ? ']' : '}');
    if (end == std::string::npos || end < at) continue;
    Json found =
        Json::parse(text.begin() + static_cast<std::ptrdiff_t>(at), text.begin() + static_cast<std::ptrdiff_t>(end) + 1, nullptr, false);
    if (!found.is_discarded()) return found;
  }
  throw Refusal(422, reason_in(text));
}

/// Of a command that answers at once; those of runs have its name before them.
Json warnings_in(const std::string& messages)
{
  constexpr std::string_view before = "warning: ";
  Json warnings = Json::array();
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(before)) warnings.push_back(line.substr(before.size()));
  return warnings;
}

/// The name of a file with a sounding, without its folder and what no name needs.
std::string sounding_name(const std::string& name)
{
  std::string plain = fs::path(name).filename().string();
  std::replace_if(
      plain.begin(), plain.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '.' && c != '_' && c != '-'; }, '_');
  if (plain.size() > 100 || plain.starts_with('-') || fs::path(plain).stem().empty() || plain.find_first_not_of('.') == std::string::npos)
    throw Refusal(400, fmt::format("{} is not a name of a file", one_line(name)), {{"key", "cpt"}});
  return plain;
}

/// A location of AGS may have any letters: as one word, so that it is no option.
std::string location_option(const std::string& location)
{
  if (location.size() > 200 || has_control_character(location))
    throw Refusal(400, fmt::format("{} is not a location", one_line(location)), {{"key", "location"}});
  return "--location=" + location;
}

constexpr const char* shown_types[] = {".html", ".pdf", ".svg", ".png", ".csv", ".json", ".txt"};

std::vector<fs::path> made_in(const fs::path& folder)
{
  std::vector<fs::path> files;
  std::error_code none;
  for (auto entry = fs::directory_iterator(folder, none); !none && entry != fs::end(entry) && files.size() < 200; entry.increment(none))
    if (entry->is_regular_file() &&
        std::find(std::begin(shown_types), std::end(shown_types), entry->path().extension()) != std::end(shown_types))
      files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

/// The options of a job that a client may give.
struct JobKind {
  const char* name;
  std::vector<const char*> options;
};

const std::vector<JobKind>& job_kinds()
{
  static const std::vector<JobKind> kinds = {{"study", {}},
                                             {"envelope", {"points", "turns", "travel"}},
                                             {"safety", {"low", "high", "tolerance"}},
                                             {"element", {}},
                                             {"fit", {}},
                                             {"cyclic", {}},
                                             {"sea", {}},
                                             {"route", {}},
                                             {"uncertainty", {}}};
  return kinds;
}

/// Whether a job computes no runs: it has one thread, and replaces earlier results with --force.
bool is_quick(const std::string& kind)
{
  return kind == "element" || kind == "fit" || kind == "cyclic" || kind == "sea" || kind == "route";
}

}  // namespace

std::string Actions::answer_of(const Question& question)
{
  const CommandOutput told = questions_.ask(question);
  if (told.status != 0) throw Refusal(422, reason_in(told.messages));
  return told.text;
}

Json Actions::printed(const std::vector<std::string>& words)
{
  return json_in(answer_of({.words = words}));
}

Json Actions::schema(const std::string& of)
{
  return printed({"params", "--json-schema", plain_word(of, "of")});
}

CommandOutput Actions::written(const Json& body)
{
  Question question{.words = {"new", plain_word(text_in(body, "kind"), "kind")}, .made = "case.toml"};
  append_options(question.words, body, {"size", "soil"});
  if (const auto cpt = body.find("cpt"); cpt != body.end() && !cpt->is_null()) {
    if (!cpt->is_object()) throw Refusal(400, "\"cpt\" has a name and a text", {{"key", "cpt"}});
    const std::string name = sounding_name(text_in(*cpt, "name"));
    question.given[name] = text_in(*cpt, "text");
    append(question.words, {"--cpt", name});
    if (const std::string location = text_in(body, "location", ""); !location.empty()) question.words.push_back(location_option(location));
  }
  CommandOutput told = questions_.ask(question);
  if (told.status != 0) throw Refusal(422, reason_in(told.messages));
  return told;
}

Json Actions::new_case(const Json& body)
{
  const std::string path = text_in(body, "path");
  const CommandOutput told = written(body);
  Json answer = folder_.write(path, {{"text", told.text}});
  answer["path"] = path;
  answer["text"] = told.text;
  answer["doubts"] = warnings_in(told.messages);
  return answer;
}

std::string Actions::drawn(const std::string& text, const std::string& path)
{
  std::vector<std::string> words = {"draw", "--stdin", path};
  append(words, more_);
  words.emplace_back("-o");
  return answer_of({.words = words, .text = text, .about = "draw " + path, .made = "model.svg"});
}

std::string Actions::picture(const std::string& kind)
{
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = pictures_.find(kind); known != pictures_.end()) return known->second;
  }
  std::string svg = drawn(written({{"kind", kind}}).text, kind + ".toml");
  const std::lock_guard lock(mutex_);
  return pictures_[kind] = std::move(svg);
}

Json Actions::check(const Json& body)
{
  const std::string path = folder_.name_of(folder_.input(text_in(body, "path")));
  std::vector<std::string> words = {"check", "--json", "--stdin", path};
  append(words, changes_in(body));
  append(words, more_);
  const CommandOutput told = questions_.ask({.words = words, .text = text_in(body, "text"), .about = "check " + path});
  Json found = json_in(told.text);
  return found.is_array() && !found.empty() ? found[0] : found;
}

std::string Actions::draw(const Json& body)
{
  return drawn(text_in(body, "text"), folder_.name_of(folder_.input(text_in(body, "path"))));
}

std::vector<std::string> Actions::runs_in(const Json& body) const
{
  std::vector<std::string> runs;
  for (const std::string& name : texts_in(body, "runs")) {
    const fs::path folder = folder_.inside(name);
    if (folder == folder_.root() || !fs::is_directory(folder)) throw Refusal(404, fmt::format("{} is not a folder of runs", name));
    folder_.refuse_links_out(folder);
    runs.push_back(folder_.name_of(folder));
  }
  if (runs.empty()) throw Refusal(400, "no runs are named", {{"key", "runs"}});
  return runs;
}

/// For a page of several runs: no page replaces another.
fs::path Actions::free_page() const
{
  for (int k = 1;; ++k) {
    const fs::path page = folder_.inside(k == 1 ? "out/compared.html" : fmt::format("out/compared_{}.html", k));
    if (!fs::exists(fs::symlink_status(page))) return page;
  }
}

Json Actions::report(const Json& body)
{
  const std::vector<std::string> runs = runs_in(body);
  const fs::path page = runs.size() == 1 ? folder_.inside(runs[0] + "/report.html") : free_page();
  std::vector<std::string> words = {"report"};
  append(words, runs);
  append(words, {"-o", folder_.name_of(page)});
  const bool pdf = body.contains("pdf") && body["pdf"] == true;
  if (pdf) words.emplace_back("--pdf");
  answer_of({.words = words});
  Json answer = {{"path", folder_.name_of(page)}};
  if (pdf) answer["pdf"] = folder_.name_of(fs::path(page).replace_extension(".pdf"));
  return answer;
}

Json Actions::export_springs(const Json& body)
{
  const std::vector<std::string> runs = runs_in(body);
  const fs::path out = folder_.inside(runs.size() == 1 ? runs[0] + "/export" : "out/export");
  std::vector<std::string> words = {"export"};
  append(words, runs);
  append_options(words, body, {"to", "state", "travels"});
  append(words, {"-o", folder_.name_of(out)});
  const Json warnings = warnings_in(answer_of({.words = words}));
  Json files = Json::array();
  std::error_code none;
  for (auto entry = fs::recursive_directory_iterator(out, none); !none && entry != fs::end(entry) && files.size() < 1000;
       entry.increment(none))
    if (entry->is_regular_file()) files.push_back(folder_.name_of(entry->path()));
  std::sort(files.begin(), files.end());
  return {{"files", files}, {"warnings", warnings}};
}

bool Actions::is_job(const std::string& kind)
{
  return std::any_of(job_kinds().begin(), job_kinds().end(), [&](const JobKind& one) { return one.name == kind; });
}

Json Actions::start(const std::string& kind, const Json& body)
{
  const auto found = std::find_if(job_kinds().begin(), job_kinds().end(), [&](const JobKind& one) { return one.name == kind; });
  Work work;
  work.kind = kind;
  work.threads = threads_in(body, queue_->threads());
  if (kind == "uncertainty") {
    work.folder = folder_.run(text_in(body, "path"));
    work.words = {"run", "--resume", folder_.name_of(work.folder), "--uncertainty"};
  } else {
    const fs::path file = folder_.input(text_in(body, "path"));
    if (!fs::is_regular_file(file)) throw Refusal(404, fmt::format("there is no {}", text_in(body, "path")));
    const std::string name = folder_.name_of(file);
    work.folder = folder_.inside(fmt::format("out/{}/{}", kind, fs::path(name).replace_extension().generic_string()));
    work.words = {kind, name, "-o", folder_.name_of(work.folder)};
    if (kind != "study") append(work.words, changes_in(body));
    if (is_quick(kind) && body.contains("replace") && body["replace"] == true) work.words.emplace_back("--force");
  }
  folder_.refuse_links_out(work.folder);
  append_options(work.words, body, found->options);
  if (!is_quick(kind)) append(work.words, {"--threads", std::to_string(work.threads)});
  work.name = folder_.name_of(work.folder);
  const Json answer = {{"job", work.name}};
  queue_->add(std::move(work));
  return answer;
}

Json Actions::jobs() const
{
  Json all = Json::array();
  for (const Queue::Entry& entry : queue_->entries()) {
    if (!is_job(entry.work.kind)) continue;
    Json made = Json::array();
    for (const fs::path& file : made_in(entry.work.folder)) made.push_back(folder_.name_of(file));
    all.push_back({{"job", entry.work.name},
                   {"command", entry.work.kind},
                   {"status", word_of(entry.state)},
                   {"log_tail", tail_of(entry.work.messages(), 6000)},
                   {"made", made}});
  }
  return all;
}

}  // namespace berm::desk
