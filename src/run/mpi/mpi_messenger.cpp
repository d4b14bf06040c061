// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
// The library that a program started by an MPI launcher opens, by itself: libmpi takes a third of a second to start.
// All functions are called by their second names, PMPI_...: MUMPS without MPI, which the program has, brings some of the first names, and they do nothing.
#include "core/ranks.hpp"

#include <chrono>
#include <cstdlib>
#include <limits>
#include <mpi.h>
#include <stdexcept>
#include <thread>

namespace berm::mpi {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time for which it lives.
class Stopwatch {
public:
  explicit Stopwatch(Real& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<Real>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  Real& seconds_;
  Clock::time_point start_ = Clock::now();
};

class MpiMessenger final : public Messenger {
public:
  MpiMessenger()
  {
    int provided = 0;
    PMPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    PMPI_Comm_size(MPI_COMM_WORLD, &count_);
    PMPI_Comm_dup(MPI_COMM_WORLD, &meetings_);
  }
  ~MpiMessenger() override { PMPI_Finalize(); }
  MpiMessenger(const MpiMessenger&) = delete;
  MpiMessenger& operator=(const MpiMessenger&) = delete;

  int rank() const override { return rank_; }
  int count() const override { return count_; }

  void exchange(std::vector<Letter>& letters) override
  {
    const Stopwatch stopwatch(traffic_.seconds);
    sent_.clear();
    for (const Letter& letter : letters) {
      ++traffic_.letters;
      traffic_.letter_bytes += static_cast<Real>(letter.out.size());
      for (std::size_t at = 0;; at += page) {  // the last page of a letter is not full
        const std::size_t bytes = std::min(letter.out.size() - at, page);
        PMPI_Isend(letter.out.data() + at, as_int(bytes), MPI_BYTE, letter.rank, tag, MPI_COMM_WORLD, &sent_.emplace_back());
        if (bytes < page) break;
      }
    }
    for (Letter& letter : letters) {
      letter.in.clear();
      int bytes = 0;
      do {
        MPI_Message message;
        MPI_Status status;
        PMPI_Mprobe(letter.rank, tag, MPI_COMM_WORLD, &message, &status);
        PMPI_Get_count(&status, MPI_BYTE, &bytes);
        const std::size_t at = letter.in.size();
        letter.in.resize(at + static_cast<std::size_t>(bytes));
        PMPI_Mrecv(letter.in.data() + at, bytes, MPI_BYTE, &message, MPI_STATUS_IGNORE);
      } while (static_cast<std::size_t>(bytes) == page);
    }
    PMPI_Waitall(static_cast<int>(sent_.size()), sent_.data(), MPI_STATUSES_IGNORE);
  }

  /// In units of the largest power of two that divides all lengths, so that gigabytes can be counted.
  void gather(const std::byte* own, std::byte* all, const std::vector<std::size_t>& first) override
  {
    const Stopwatch stopwatch(traffic_.seconds);
    ++traffic_.gathers;
    traffic_.gathered_bytes += static_cast<Real>(first.back());
    std::size_t bits = 0;
    for (const std::size_t at : first) bits |= at;
    const std::size_t unit = bits == 0 ? 1 : std::min<std::size_t>(bits & ~(bits - 1), 4096);
    counts_.resize(static_cast<std::size_t>(count_));
    begins_.resize(static_cast<std::size_t>(count_));
    for (int r = 0; r < count_; ++r) {
      counts_[r] = as_int((first[r + 1] - first[r]) / unit);
      begins_[r] = as_int(first[r] / unit);
    }
    MPI_Datatype type = MPI_BYTE;
    if (unit > 1) {
      PMPI_Type_contiguous(static_cast<int>(unit), MPI_BYTE, &type);
      PMPI_Type_commit(&type);
    }
    PMPI_Allgatherv(own, counts_[rank_], type, all, counts_.data(), begins_.data(), type, MPI_COMM_WORLD);
    if (unit > 1) PMPI_Type_free(&type);
  }

  Real largest(Real of_rank) override
  {
    const Stopwatch stopwatch(traffic_.seconds);
    ++traffic_.gathers;
    traffic_.gathered_bytes += static_cast<Real>(sizeof of_rank) * count_;
    Real most = of_rank;
    PMPI_Allreduce(&of_rank, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    return most;
  }

  const Traffic& traffic() const override { return traffic_; }

  bool meet(Real seconds) override
  {
    const Clock::time_point start = Clock::now();
    MPI_Request request;
    PMPI_Ibarrier(meetings_, &request);
    int all = 0;
    for (;;) {
      PMPI_Test(&request, &all, MPI_STATUS_IGNORE);
      if (all != 0 || std::chrono::duration<Real>(Clock::now() - start).count() > seconds) return all != 0;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  [[noreturn]] void abort(int status) override
  {
    PMPI_Abort(MPI_COMM_WORLD, status);
    std::_Exit(status);
  }

private:
  static constexpr int tag = 1;
  static constexpr std::size_t page = std::size_t(1) << 30;  // bytes

  static int as_int(std::size_t number)
  {
    if (number > static_cast<std::size_t>(std::numeric_limits<int>::max())) throw std::length_error("a message between ranks is too long");
    return static_cast<int>(number);
  }

  int rank_ = 0, count_ = 1;
  Traffic traffic_;
  MPI_Comm meetings_ = MPI_COMM_NULL;  ///< a rank that waits elsewhere does not take part by mistake
  std::vector<MPI_Request> sent_;
  std::vector<int> counts_, begins_;
};

}  // namespace
}  // namespace berm::mpi

extern "C" berm::Messenger* berm_messenger()
{
  return new berm::mpi::MpiMessenger;
}
