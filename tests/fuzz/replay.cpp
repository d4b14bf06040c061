// SPDX-License-Identifier: BSD-3-Clause
// Runs a target without libFuzzer: on every file that is named or lies in a folder that is named, and then on damaged copies of them, the same
// at every run.
//
//   TARGET [--damaged COUNT] FILE_OR_FOLDER...
#include "target.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string whole(const fs::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void add(std::vector<std::string>& inputs, const fs::path& path)
{
  if (!fs::is_directory(path)) return inputs.push_back(whole(path));
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) inputs.push_back(whole(file));
}

/// A copy with one to four changes: a byte changed, one put in, some taken out, a part copied from another input, or a number made odd.
std::string damaged(std::string text, const std::string& other, std::mt19937& random)
{
  constexpr const char* words[] = {"1e999", "nan",    "-inf", "-0", "99999999999999999999", "1e-320",
                                   "[[",    "\"\"\"", "..",   "\n", "0x7fffffffffffffff"};
  const auto any = [&](std::size_t count) { return count == 0 ? 0 : random() % count; };
  for (auto changes = 1 + any(4); changes > 0; --changes) {
    const std::size_t place = any(text.size());
    const char byte = static_cast<char>(any(4) == 0 ? any(256) : "[]{}\"'=.,#\n -0123456789eE"[any(25)]);
    switch (any(5)) {
    case 0:
      if (!text.empty()) text[place] = byte;
      break;
    case 1:
      text.insert(place, 1, byte);
      break;
    case 2:
      text.erase(place, 1 + any(20));
      break;
    case 3:
      text.insert(place, other.substr(any(other.size()), any(60)));
      break;
    default:
      if (const std::size_t digit = text.find_first_of("0123456789", place); digit != std::string::npos)
        text.replace(digit, 1 + any(3), words[any(std::size(words))]);
    }
  }
  return text;
}

void run(const std::string& input)
{
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace

int main(int count, char** arguments)
{
  std::vector<std::string> inputs;
  int damages = 0;
  for (int k = 1; k < count; ++k)
    if (std::string(arguments[k]) == "--damaged" && k + 1 < count)
      damages = std::stoi(arguments[++k]);
    else
      add(inputs, arguments[k]);
  if (inputs.empty()) {
    fmt::print(stderr, "no inputs\n");
    return 2;
  }
  for (const std::string& input : inputs) run(input);
  std::mt19937 random(1);
  for (int k = 0; k < damages; ++k) {
    const std::string& input = inputs[random() % inputs.size()];
    run(damaged(input, inputs[random() % inputs.size()], random));
  }
  fmt::print("{} inputs and {} damaged ones\n", inputs.size(), damages);
  return 0;
}
