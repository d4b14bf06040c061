// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/desk/desk_test.cpp
#include "desk/questions.hpp"

#include "desk/refusal.hpp"
#include "io/atomic_file.hpp"
#include "os/threads.hpp"

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace berm::desk {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes longest{10};
constexpr std::uintmax_t most_output_bytes = 64 << 20;

/// Files that a question gave have their names alone: where they lay is nothing to the reader.
void leave_out(const std::string& folder, std::string& text)
{
  for (std::size_t at; (at = text.find(folder)) != std::string::npos;) text.erase(at, folder.size());
}

}  // namespace

Questions::Questions(fs::path folder) : folder_(std::move(folder)), free_(processor_count()) {}

CommandOutput Questions::ask(const Question& question)
{
  std::unique_lock lock(mutex_);
  if (const auto last = about_.find(question.about); last != about_.end() && last->second) {
    last->second->send(SIGKILL);  // which makes room for this one
    last->second.reset();
  }
  ended_.wait(lock, [&] { return free_ > 0 || ending_; });
  if (ending_) throw Refusal(503, "berm desk is closing");
  --free_;
  const fs::path place = scratch_.path() / std::to_string(number_++), messages = place / "messages";
  int in = -1, out = -1;
  std::shared_ptr<Process> process;
  const auto leave = [&] {  // with the lock
    asked_.erase(process);
    for (const int file : {in, out})
      if (file >= 0) ::close(file);
    std::error_code none;
    fs::remove_all(place, none);
    ++free_;
    ended_.notify_one();
  };
  try {
    io::make_folder(place);
    if (question.text) {
      io::write_atomically(place / "text", *question.text);
      in = ::open((place / "text").c_str(), O_RDONLY | O_CLOEXEC);
      if (in < 0) io::throw_errno("cannot read a text");
    }
    std::vector<std::string> words = question.words;
    for (const auto& [name, text] : question.given) {
      io::write_atomically(place / name, text);
      std::replace(words.begin(), words.end(), name, (place / name).string());
    }
    if (!question.made.empty()) words.push_back((place / question.made).string());
    out = io::open_to_write(messages, O_WRONLY);
    process = std::make_shared<Process>(std::move(words), folder_, out, false, in);
    asked_.insert(process);
    if (!question.about.empty()) {
      std::shared_ptr<Process>& last = about_[question.about];
      if (last) last->send(SIGKILL);
      last = process;
    }
    lock.unlock();
    const auto begin = std::chrono::steady_clock::now();
    CommandOutput told{process->wait(longest), {}, io::read_text_file(messages, most_output_bytes)};
    told.text = question.made.empty() ? told.messages : io::read_text_file(place / question.made, most_output_bytes);
    if (!question.given.empty())
      for (std::string* words_of : {&told.text, &told.messages}) leave_out(place.string() + "/", *words_of);
    lock.lock();
    const auto last = about_.find(question.about);
    const bool stands = last == about_.end() || last->second == process;
    if (last != about_.end() && stands) about_.erase(last);
    if (!stands) throw Refusal(409, "replaced by a later request");
    if (std::chrono::steady_clock::now() - begin > longest) throw Refusal(504, fmt::format("berm {} took too long", question.words[0]));
    leave();
    return told;
  } catch (...) {
    if (!lock.owns_lock()) lock.lock();
    leave();
    throw;
  }
}

void Questions::end()
{
  const std::lock_guard lock(mutex_);
  ending_ = true;
  for (const auto& process : asked_) process->send(SIGKILL);
  ended_.notify_all();
}

}  // namespace berm::desk
