// SPDX-License-Identifier: BSD-3-Clause
#include "input/read_case.hpp"
#include "library/message_sink.hpp"
#include "library/particle_views.hpp"
#include "os/error.hpp"
#include "os/text_of_list.hpp"
#include "problem/stages.hpp"
#include "simulation/open_run.hpp"
#include "simulation/run_place.hpp"
#include "structures/after_run/after_run.hpp"

#include <berm/berm.hpp>

#include <fmt/format.h>

namespace berm {
namespace {

namespace fs = std::filesystem;

/// Without a folder of the user's the run has one that goes when it ends.
fs::path folder_for(const RunOptions& options, const io::ScratchFolder& scratch)
{
  if (options.folder.empty()) return scratch.path() / "run";
  if (!options.replace && simulation::has_begun(options.folder))
    throw InputError(fmt::format("{} holds a run: replace it (the option `replace`), resume it, or name another folder", options.folder));
  return options.folder;
}

simulation::RunRequest request_for(const std::string& case_file, const RunOptions& options, const io::ScratchFolder& scratch)
{
  auto [settings, places] = input::case_of(case_file, options.set);
  return {std::move(settings), case_file, folder_for(options, scratch), false, std::move(places), options.laws, options.set};
}

simulation::RunRequest request_to_resume(const std::string& folder, const RunOptions& options)
{
  if (!options.set.empty() || !options.folder.empty() || options.replace)
    throw InputError("a run is resumed as it was begun: without set, folder and replace");
  std::optional<simulation::RunRequest> request = simulation::run_to_resume(folder);
  if (!request) throw InputError(fmt::format("the run in {} is finished", folder));
  request->laws = options.laws;
  return *std::move(request);
}

/// By its place among those of the geometry: two displacements and a rotation, or three of each.
int place_of(Freedom freedom, int dim)
{
  const int k = static_cast<int>(freedom);
  if (freedom == Freedom::x || freedom == Freedom::y) return k;
  if (dim == 2 && freedom == Freedom::rotation) return 2;
  if (dim == 3 && freedom == Freedom::z) return 2;
  if (dim == 3 && freedom > Freedom::rotation) return k - 1;
  throw InputError(dim == 2 ? "drive: is not a degree of freedom in plane strain: x, y and rotation are"
                            : "drive: is not a degree of freedom in space: x, y, z and rotation_x, _y, _z are");
}

/// With its checkpoints; the lock is each folder's own.
void copy_run(const fs::path& from, const fs::path& to)
{
  std::error_code error;
  fs::create_directories(to, error);
  if (!error) fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::copy_symlinks, error);
  if (error) throw RunError(fmt::format("the run in {} cannot be copied to {}: {}", from.string(), to.string(), error.message()));
}

/// A clone begins in an empty folder, and not in that of its run, which is copied.
void refuse_for_clone(const fs::path& folder, const fs::path& of_run)
{
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_empty(folder, error))
    throw InputError(fmt::format("clone: {} {}: name another folder", folder.string(),
                                 simulation::has_begun(folder) ? "holds a run" : "is not an empty folder"));
  const fs::path inner = fs::weakly_canonical(folder, error).lexically_relative(fs::weakly_canonical(of_run, error));
  if (!inner.empty() && *inner.begin() != "..")
    throw InputError(fmt::format("clone: {} lies in the folder of its run: name another one", folder.string()));
}

int threads_of(const RunOptions& options)
{
  constexpr int most = 1024;
  if (options.threads < 0 || options.threads > most)
    throw InputError(fmt::format("threads: {}: from 1 to {}, or 0 for one for each processor", options.threads, most));
  return options.threads;
}

}  // namespace

/// In the order in which they need each other.
struct Run::Parts {
  /// act(OpenRun&), whatever the method.
  template <class Act>
  auto visit(const Act& act) const
  {
    return std::visit([&](const auto& open) { return act(*open); }, run);
  }

  /// While it lives the run has the calling thread and the process's messages.
  class AtWork {
  public:
    explicit AtWork(Parts& parts) : parts_(parts)
    {
      if (!parts_.context) return;
      parts_.context->go_on();
      parts_.visit([](auto& open) { open.take_over(); });
    }
    ~AtWork()
    {
      parts_.visit([](auto& open) { open.step_aside(); });
      if (parts_.context) parts_.context->pause();
    }
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;

  private:
    Parts& parts_;
  };

  Parts(const RunOptions& options, const std::function<simulation::RunRequest(const io::ScratchFolder&)>& request)
      : keeps(!options.folder.empty()),
        options(options),
        context(
            std::in_place, threads_of(options), [this] { return asked_to_stop; }, std::make_shared<MessageSink>(options.message),
            after_run::answers_and_drawings()),
        run(simulation::open_run(request(scratch), *context))
  {
    const AtWork at_work(*this);
    visit([](auto& open) { open.begin(); });
  }

  /// Returns whether the run goes on. One that failed has ended.
  bool advance()
  {
    if (ended) return false;
    const AtWork at_work(*this);
    try {
      if (visit([](auto& open) { return open.advance(); })) return true;
      finished = visit([this](auto& open) { return keeps ? open.end() : open.end_without_results(); });
    } catch (...) {
      leave();
      throw;
    }
    leave();
    return false;
  }

  /// What it has found can still be looked at.
  void leave()
  {
    ended = true;
    context.reset();
  }

  BigIndex rows() const
  {
    return visit([](const auto& open) { return open.run().rows(); });
  }

  /// A drive of the caller's, or a limit of the time step: act(MpmMethod&).
  template <class Act>
  void change(const char* what, const Act& act)
  {
    if (ended) throw InputError(fmt::format("{}: the run has ended", what));
    visit([&](auto& open) {
      if constexpr (simulation::FiniteElements<std::decay_t<decltype(open.method())>>)
        throw InputError(fmt::format("{}: is for method = \"mpm\": finite elements go from one equilibrium to the next", what));
      else
        act(open.method());
    });
  }

  bool keeps, asked_to_stop = false, ended = false, finished = false;
  RunOptions options;
  io::ScratchFolder scratch;
  std::optional<simulation::Context> context;  ///< until the run ends: then another may begin
  simulation::AnyOpenRun run;
  mutable std::vector<HistoryColumn> columns;
};

std::string version()
{
  return BERM_VERSION;
}

Run::Run(const std::string& case_file, const RunOptions& options)
    : parts_(std::make_unique<Parts>(options, [&](const io::ScratchFolder& scratch) { return request_for(case_file, options, scratch); }))
{
}

Run::Run(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Run::~Run() = default;
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;

Run Run::resume(const std::string& folder, const RunOptions& options)
{
  auto parts = std::make_unique<Parts>(options, [&](const io::ScratchFolder&) { return request_to_resume(folder, options); });
  parts->keeps = true;
  return Run(std::move(parts));
}

bool Run::step(long long count)
{
  if (count < 0) throw InputError(fmt::format("step: {} steps: it must be 0 or more", count));
  while (count-- > 0 && parts_->advance()) {
  }
  return !parts_->ended;
}

bool Run::step_to_row()
{
  const BigIndex before = parts_->rows();
  while (parts_->rows() == before && parts_->advance()) {
  }
  return !parts_->ended;
}

void Run::finish()
{
  while (parts_->advance()) {
  }
}

void Run::stop()
{
  parts_->asked_to_stop = true;
  finish();
}

Run Run::clone(const std::string& folder)
{
  if (parts_->ended) throw InputError("clone: the run has ended");
  if (!folder.empty()) refuse_for_clone(folder, parts_->visit([](auto& open) { return open.folder(); }));
  {
    const Parts::AtWork at_work(*parts_);
    parts_->visit([](auto& open) { open.keep(); });
  }
  RunOptions options = parts_->options;
  options.set.clear();
  options.folder.clear();
  options.replace = false;
  auto parts = std::make_unique<Parts>(options, [&](const io::ScratchFolder& scratch) {
    const fs::path copy = folder.empty() ? scratch.path() / "run" : fs::path(folder);
    parts_->visit([&](auto& open) { copy_run(open.folder(), copy); });
    return request_to_resume(copy.string(), options);
  });
  parts->keeps = !folder.empty();
  return Run(std::move(parts));
}

void Run::drive_by_velocity(Freedom freedom, double velocity)
{
  parts_->change("drive", [&](auto& method) { method.drive(place_of(freedom, std::decay_t<decltype(method)>::dim), false, velocity); });
}

void Run::drive_by_force(Freedom freedom, double force)
{
  parts_->change("drive", [&](auto& method) { method.drive(place_of(freedom, std::decay_t<decltype(method)>::dim), true, force); });
}

void Run::limit_time_step(double longest)
{
  if (!(longest > 0)) throw InputError(fmt::format("limit_time_step: {} s: it must be more than 0", longest));
  parts_->change("limit_time_step", [&](auto& method) { method.limit_time_step(longest); });
}

bool Run::ended() const
{
  return parts_->ended;
}

bool Run::finished() const
{
  return parts_->finished;
}

long long Run::steps() const
{
  return parts_->visit([](auto& open) { return static_cast<long long>(open.method().state().step); });
}

double Run::time() const
{
  return parts_->visit([](auto& open) { return open.method().state().time; });
}

double Run::time_step() const
{
  return parts_->visit([](auto& open) { return open.method().state().dt; });
}

std::string Run::stage() const
{
  return parts_->visit([](auto& open) { return open.method().model().stages[open.method().state().stage.index].name; });
}

const std::vector<HistoryColumn>& Run::columns() const
{
  if (parts_->columns.empty())
    for (const run_folder::Column& column : parts_->visit([](auto& open) { return open.method().recorder().row().columns(); }))
      parts_->columns.push_back({column.name, column.unit, column.meaning});
  return parts_->columns;
}

const std::vector<double>& Run::row() const
{
  return *parts_->visit([](auto& open) { return &open.method().recorder().row().values(); });
}

int Run::dimension() const
{
  return parts_->visit([](auto& open) { return std::decay_t<decltype(open.method())>::dim; });
}

bool Run::is_axisymmetric() const
{
  return parts_->visit([](auto& open) { return open.method().model().mesh.metric == mesh::Metric::axisymmetric; });
}

double Run::contact_mass() const
{
  return parts_->visit([](auto& open) -> double {
    if constexpr (simulation::FiniteElements<std::decay_t<decltype(open.method())>>)
      return 0;
    else
      return open.method().contact_mass();
  });
}

std::vector<std::string> Run::bodies() const
{
  return parts_->visit([](auto& open) {
    std::vector<std::string> names;
    const auto& model = open.method().model();
    for (std::size_t b = 0; b < open.method().state().particles.size(); ++b) names.push_back(model.bodies[b].name);
    return names;
  });
}

std::vector<ParticleField> Run::particles(const std::string& body) const
{
  const std::vector<std::string> names = bodies();
  const auto found = std::find(names.begin(), names.end(), body);
  if (found == names.end())
    throw InputError(fmt::format("there is no body \"{}\" of particles: {}", body, names.empty() ? "none" : text_of_list(names, ", ")));
  const auto b = static_cast<std::size_t>(found - names.begin());
  return parts_->visit([&](auto& open) { return views_of(open.method().state().particles[b]); });
}

std::vector<RigidBodyNow> Run::rigid_bodies() const
{
  return parts_->visit([](auto& open) {
    constexpr int dim = std::decay_t<decltype(open.method())>::dim;
    const auto& model = open.method().model();
    const auto& states = open.method().state().rigid_bodies;
    std::vector<RigidBodyNow> all;
    for (std::size_t r = 0; r < states.size(); ++r) {
      RigidBodyNow now{};
      now.name = model.rigid_bodies[r].name;
      const auto& all_sums = open.method().state().ledger.contact_sums;
      const contact::ContactSums<dim> sums = r < all_sums.size() ? all_sums[r] : contact::ContactSums<dim>{};
      now.embedment = travel_of(model, open.method().state(), static_cast<Index>(r)).w;
      const Vec<dim> centre = center_now(model.rigid_bodies[r], states[r]);
      for (int d = 0; d < dim; ++d) {
        now.centre[d] = centre[d];
        now.displacement[d] = states[r].displacement[d];
        now.velocity[d] = states[r].velocity[d];
        now.force[d] = states[r].reaction[d];
        now.impulse[d] = -sums.impulse[d];
      }
      const auto about = [](double(&numbers)[3], const auto& angular, double sign) {
        if constexpr (dim == 2)
          numbers[2] = sign * angular;
        else
          for (int d = 0; d < 3; ++d) numbers[d] = sign * angular[d];
      };
      about(now.angular_velocity, states[r].angular_velocity, 1);
      about(now.torque, states[r].torque, 1);
      about(now.angular_impulse, sums.torque_impulse, -1);
      all.push_back(now);
    }
    return all;
  });
}

}  // namespace berm
