// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
#include "core/ranks.hpp"

namespace berm {

Ranks& Ranks::of_run()
{
  static Ranks ranks;
  return ranks;
}

void Ranks::divide(std::vector<Index> first_chunk, const std::vector<Index>& cell_chunks, const std::vector<Index>& node_chunks)
{
  first_chunk_ = std::move(first_chunk);
  first_cell_.clear();
  first_node_.clear();
  for (const Index chunk : first_chunk_) {
    first_cell_.push_back(cell_chunks[chunk]);
    first_node_.push_back(node_chunks[chunk]);
  }
}

void Ranks::share_chunks(void* chunks, std::size_t bytes)
{
  if (!divided()) return;
  first_.clear();
  for (const Index chunk : first_chunk_) first_.push_back(static_cast<std::size_t>(chunk) * bytes);
  auto* all = static_cast<std::byte*>(chunks);
  own_.assign(all + first_[rank()], all + first_[rank() + 1]);
  messenger_->gather(own_.data(), all, first_);
}

const std::vector<std::size_t>& Ranks::firsts_of(std::size_t bytes)
{
  next_.clear();
  for (int r = 0; r <= count(); ++r) next_.push_back(static_cast<std::size_t>(r) * sizeof(std::size_t));
  first_.assign(static_cast<std::size_t>(count()) + 1, 0);
  messenger_->gather(reinterpret_cast<const std::byte*>(&bytes), reinterpret_cast<std::byte*>(first_.data() + 1), next_);
  for (int r = 0; r < count(); ++r) first_[r + 1] += first_[r];
  return first_;
}

std::string Ranks::text_of_largest(Real number, const std::string& text)
{
  if (!divided()) return text;
  const Real most = largest(number);
  const bool mine = !(number < most);
  std::vector<int> able;
  gather(std::vector<int>{mine ? rank() : count()}, able);
  const int chosen = *std::min_element(able.begin(), able.end());
  std::vector<char> all;
  gather(rank() == chosen ? std::vector<char>(text.begin(), text.end()) : std::vector<char>(), all);
  return {all.begin(), all.end()};
}

}  // namespace berm
