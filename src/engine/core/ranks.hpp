// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/types.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace berm {

/// What a rank has sent and got so far.
struct Traffic {
  Real seconds = 0;         ///< that it took, waiting included
  BigIndex letters = 0;     ///< sent to single ranks
  Real letter_bytes = 0;    ///< in them
  BigIndex gathers = 0;     ///< calls in which all ranks tell all others something
  Real gathered_bytes = 0;  ///< that all ranks told in them
};

/// Carries bytes between the processes of one run, its ranks. All but abort() are called by all ranks in the same order.
class Messenger {
public:
  /// What goes to one other rank and comes from it.
  struct Letter {
    int rank;
    std::vector<std::byte> out, in;
  };

  virtual ~Messenger() = default;
  virtual int rank() const = 0;
  virtual int count() const = 0;
  /// Sends each letter's `out`, and fills `in`. If a has a letter for b, b has one for a.
  virtual void exchange(std::vector<Letter>& letters) = 0;
  /// Lays the bytes of all ranks end to end, on each of them: those of rank r go to all[first[r]] ... all[first[r + 1] - 1].
  virtual void gather(const std::byte* own, std::byte* all, const std::vector<std::size_t>& first) = 0;
  virtual Real largest(Real of_rank) = 0;
  virtual const Traffic& traffic() const = 0;
  /// Whether all ranks come here within so many seconds.
  virtual bool meet(Real seconds) = 0;
  /// Ends all ranks.
  [[noreturn]] virtual void abort(int status) = 0;
};

/// The processes of this run and how its cells are divided among them: each owns a range of chunks (core/chunks.hpp), and so of cells and of nodes. One
/// process by itself owns all, and sends nothing. A process has one of them, as it has one run at a time.
class Ranks {
public:
  static Ranks& of_run();

  void join(std::unique_ptr<Messenger> messenger) { messenger_ = std::move(messenger); }
  void leave() { messenger_.reset(); }
  int count() const { return messenger_ ? messenger_->count() : 1; }
  int rank() const { return messenger_ ? messenger_->rank() : 0; }
  /// How many of them are on this machine.
  int count_here() const { return count_here_; }
  void set_count_here(int count) { count_here_ = count; }
  bool is_first() const { return rank() == 0; }
  Messenger* messenger() { return messenger_.get(); }

  /// Divides what has these chunks: those from first_chunk[r] to before first_chunk[r + 1] go to rank r.
  void divide(std::vector<Index> first_chunk, const std::vector<Index>& cell_chunks, const std::vector<Index>& node_chunks);
  /// From now on each rank has all again.
  void unite() { first_chunk_.clear(); }
  bool divided() const { return !first_chunk_.empty(); }
  int owner_of_cell(Index cell) const { return owner(first_cell_, cell); }
  int owner_of_node(Index node) const { return owner(first_node_, node); }
  bool owns_cell(Index cell) const { return !divided() || (first_cell_[rank()] <= cell && cell < first_cell_[rank() + 1]); }
  bool owns_node(Index node) const { return !divided() || (first_node_[rank()] <= node && node < first_node_[rank() + 1]); }
  const std::vector<Index>& first_cell() const { return first_cell_; }
  const std::vector<Index>& first_chunk() const { return first_chunk_; }

  /// Gives each chunk, of as many bytes, what its owner has of it. Nothing where all is one.
  void share_chunks(void* chunks, std::size_t bytes);

  /// Gives all ranks the values that the owners of entries 0 ... count - 1 have: get(i, T&) is called for a rank's own, set(i, const T&) for others'.
  /// Nothing where all is one. T is copied by its bytes.
  template <class T, class Owner, class Get, class Set>
  void share(Index count, const Owner& owner, const Get& get, const Set& set)
  {
    if (!divided()) return;
    first_.assign(static_cast<std::size_t>(this->count()) + 1, 0);
    for (Index i = 0; i < count; ++i) first_[owner(i) + 1] += sizeof(T);
    for (int r = 0; r < this->count(); ++r) first_[r + 1] += first_[r];
    if (first_.back() == 0) return;
    own_.resize(first_[rank() + 1] - first_[rank()]);
    all_.resize(first_.back());
    std::byte* to = own_.data();
    for (Index i = 0; i < count; ++i)
      if (owner(i) == rank()) {
        T value{};
        get(i, value);
        std::memcpy(to, static_cast<const void*>(&value), sizeof(T));
        to += sizeof(T);
      }
    messenger_->gather(own_.data(), all_.data(), first_);
    next_ = first_;
    for (Index i = 0; i < count; ++i) {
      const int r = owner(i);
      T value{};
      std::memcpy(static_cast<void*>(&value), all_.data() + next_[r], sizeof(T));
      next_[r] += sizeof(T);
      if (r != rank()) set(i, value);
    }
  }

  /// The lists of all ranks end to end; where each of them has all, what it has. T is copied by its bytes.
  template <class T>
  void gather(const std::vector<T>& own, std::vector<T>& all)
  {
    if (divided())
      gather_from_all(own, all);
    else
      all = own;
  }
  /// The same whether or not each rank has all. Needs more than one.
  template <class T>
  void gather_from_all(const std::vector<T>& own, std::vector<T>& all)
  {
    const std::vector<std::size_t>& first = firsts_of(own.size() * sizeof(T));
    all.resize(first.back() / sizeof(T));
    messenger_->gather(reinterpret_cast<const std::byte*>(own.data()), reinterpret_cast<std::byte*>(all.data()), first);
  }
  /// The number of each rank, also where each has all.
  std::vector<Real> all_of(Real of_rank)
  {
    std::vector<Real> all{of_rank};
    if (count() > 1) gather_from_all(std::vector<Real>{of_rank}, all);
    return all;
  }
  /// The largest of the ranks' numbers.
  Real largest(Real of_rank) { return divided() ? messenger_->largest(of_rank) : of_rank; }
  bool any(bool of_rank) { return largest(of_rank ? 1 : 0) > 0; }
  /// Does what may throw RunError on some ranks: then all throw, with the words of the first of them.
  template <class Act>
  void together(const Act& act)
  {
    if (!divided()) return act();
    std::string why;
    bool failed = false;
    try {
      act();
    } catch (const RunError& error) {
      why = error.what();
      failed = true;
    }
    if (any(failed)) throw RunError(text_of_largest(failed ? 1 : 0, why));
  }
  /// The text of the rank whose number is largest; of several, of the first.
  std::string text_of_largest(Real number, const std::string& text);

private:
  static int owner(const std::vector<Index>& first, Index i)
  {
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), i) - first.begin()) - 1;
  }
  /// Where each rank's bytes begin, of which this one has so many.
  const std::vector<std::size_t>& firsts_of(std::size_t bytes);

  std::unique_ptr<Messenger> messenger_;
  int count_here_ = 1;
  std::vector<Index> first_chunk_, first_cell_, first_node_;
  std::vector<std::size_t> first_, next_;
  std::vector<std::byte> own_, all_;
};

}  // namespace berm
