// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/ranks/run
#include "simulation/run_of_ranks.hpp"

#include "core/bytes.hpp"
#include "core/ranks.hpp"
#include "core/vector_unit.hpp"
#include "os/error.hpp"
#include "os/threads.hpp"

#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace berm::simulation {
namespace {

constexpr Real patience = 10;  // s, that ranks which fail together may be apart

int messages = STDERR_FILENO;   ///< where a rank that fails alone says why
bool ends_with_others = false;  ///< it is known that all come to their end, however long the first one writes results

bool several(const char* variable)
{
  const char* value = std::getenv(variable);
  return value != nullptr && std::atoi(value) > 1;
}

/// Open MPI, MPICH and its kin, and Slurm with PMIx.
bool started_by_launcher()
{
  return several("OMPI_COMM_WORLD_SIZE") || several("PMI_SIZE") || (std::getenv("PMIX_RANK") != nullptr && several("SLURM_STEP_NUM_TASKS"));
}

/// Programs that this one starts, such as Gmsh, are no ranks.
void hide_launcher()
{
  std::vector<std::string> names;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string name = std::string(*entry).substr(0, std::string(*entry).find('='));
    for (const char* kind : {"OMPI_", "PMIX_", "PMI_"})
      if (name.starts_with(kind)) names.push_back(name);
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

bool is_another(const char* variable)
{
  const char* value = std::getenv(variable);
  return value != nullptr && std::atoi(value) != 0;
}

/// What one rank must know of another before a run.
struct Place {
  char machine[256];
  cpu_set_t processors;
  char vector_unit[16];
};

/// Ranks of one machine that may use the same processors share them out. Throws RunError where some compute on other vector units than others.
void share_machine(Ranks& ranks)
{
  Place own{};
  gethostname(own.machine, sizeof own.machine - 1);
  sched_getaffinity(0, sizeof own.processors, &own.processors);
  std::strncpy(own.vector_unit, vector_unit(), sizeof own.vector_unit - 1);
  std::vector<Place> all;
  ranks.gather_from_all(std::vector<Place>{own}, all);
  int here = 0, sharing = 0, index = 0;
  for (int r = 0; r < ranks.count(); ++r) {
    const Place& other = all[r];
    if (std::strcmp(other.vector_unit, all[0].vector_unit) != 0)
      throw RunError(fmt::format("rank 0 computes on the vector unit {} and rank {} on {}, which round otherwise: use machines of one kind",
                                 all[0].vector_unit, r, other.vector_unit));
    if (std::strcmp(other.machine, own.machine) != 0) continue;
    ++here;
    if (CPU_EQUAL(&other.processors, &own.processors) == 0) continue;
    if (r < ranks.rank()) ++index;
    ++sharing;
  }
  ranks.set_count_here(here);
  bind_to_cores(index, sharing);
}

void print_nothing()
{
  messages = dup(STDERR_FILENO);
  fcntl(messages, F_SETFD, FD_CLOEXEC);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

/// The numbers and texts that visit() names, as bytes.
class Bytes final : public Archive {
public:
  explicit Bytes(std::vector<std::byte>& bytes, bool reads) : bytes_(bytes), reads_(reads) {}

  bool reads() const override { return reads_; }
  [[noreturn]] void refuse(const std::string& why) const override { throw RunError("the first rank's state does not fit: " + why); }

protected:
  void list(const std::string&, std::vector<Real>& numbers) override { carry(numbers); }
  void list(const std::string&, std::vector<Index>& numbers) override { carry(numbers); }
  void list(const std::string&, std::vector<BigIndex>& numbers) override { carry(numbers); }
  void list(const std::string&, std::string& text) override { carry(text); }

private:
  template <class List>
  void carry(List& list)
  {
    std::size_t count = list.size();
    if (!reads_) {
      put_bytes(bytes_, &count);
      put_bytes(bytes_, list.data(), count);
      return;
    }
    const std::byte* at = get_bytes(bytes_.data() + read_, &count);
    list.resize(count);
    read_ = static_cast<std::size_t>(get_bytes(at, list.data(), count) - bytes_.data());
  }

  std::vector<std::byte>& bytes_;
  bool reads_;
  std::size_t read_ = 0;
};

/// Long messages are counted in pages.
void fill_page(std::vector<std::byte>& bytes)
{
  constexpr std::size_t page = 4096;
  bytes.resize((bytes.size() + page - 1) / page * page);
}

}  // namespace

void join_ranks()
{
  if (!started_by_launcher()) return;
  for (const char* rank : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
    if (is_another(rank)) {
      print_nothing();
      break;
    }
  void* const library = dlopen("libberm_mpi.so", RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr)
    throw RunError(fmt::format("an MPI launcher started several processes of berm, which was built without MPI ({}): install MPI and build "
                               "berm again, or start it without the launcher",
                               dlerror()));
  const auto make = reinterpret_cast<Messenger* (*)()>(dlsym(library, "berm_messenger"));
  Ranks& ranks = Ranks::of_run();
  ranks.join(std::unique_ptr<Messenger>(make()));
  hide_launcher();
  share_machine(ranks);
}

int leave_ranks(int status, const std::string& why)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() > 1 && status != 0 && !ranks.messenger()->meet(ends_with_others ? infinity : patience)) {
    if (!ranks.is_first() && !why.empty()) dprintf(messages, "berm: %s (rank %d of %d)\n", why.c_str(), ranks.rank(), ranks.count());
    ranks.messenger()->abort(status);
  }
  ranks.leave();
  return status;
}

bool on_any_rank(bool of_rank)
{
  Ranks& ranks = Ranks::of_run();
  return ranks.count() == 1 ? of_rank : ranks.messenger()->largest(of_rank ? 1 : 0) > 0;
}

bool ends_on_any_rank_with(bool of_rank)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() > 1) ends_with_others = true;
  return on_any_rank(of_rank);
}

void on_first_rank(const std::function<void()>& act)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return act();
  if (ranks.is_first()) try {
      act();
    } catch (...) {
      ranks.messenger()->largest(1);
      throw;
    }
  if (ranks.messenger()->largest(0) > 0) throw InputError("the first rank refuses");
}

void abort_ranks(const std::string& why)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return;
  ends_with_others = ranks.messenger()->meet(patience);
  if (ends_with_others) return;
  dprintf(messages, "berm: %s (rank %d of %d)\n", why.c_str(), ranks.rank(), ranks.count());
  ranks.messenger()->abort(1);
}

bool broadcast(bool has_it, const std::function<void(Archive&)>& visit)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return has_it;
  std::vector<std::byte> own, all;
  if (ranks.is_first() && has_it) {
    Bytes written(own, false);
    visit(written);
    fill_page(own);
  }
  ranks.gather_from_all(own, all);
  if (ranks.is_first() || all.empty()) return !all.empty();
  Bytes read(all, true);
  visit(read);
  return true;
}

void gather_on_first_rank(const std::function<void(Archive&, int)>& visit)
{
  Ranks& ranks = Ranks::of_run();
  if (ranks.count() == 1) return;
  for (int rank = 1; rank < ranks.count(); ++rank) {
    std::vector<std::byte> own, all;
    if (ranks.rank() == rank) {
      Bytes written(own, false);
      visit(written, rank);
      fill_page(own);
    }
    ranks.gather_from_all(own, all);
    if (!ranks.is_first()) continue;
    Bytes read(all, true);
    visit(read, rank);
  }
}

}  // namespace berm::simulation
