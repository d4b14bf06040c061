// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/simulation/run_test.cpp
#include "simulation/open_run.hpp"

#include "core/ranks.hpp"
#include "io/log.hpp"
#include "os/error.hpp"
#include "simulation/good_sense.hpp"
#include "simulation/run_of_ranks.hpp"
#include "simulation/with_method.hpp"
#include "user_law/load.hpp"

#include <fmt/format.h>

namespace berm::simulation {
namespace {

template <class Method>
std::vector<std::string> warnings_about(const RunRequest& request, Method& method, const Context& context)
{
  return request.resume && !request.shorter ? noted_warnings(request.folder) : warnings_of(method.scene(request, context.threads()));
}

}  // namespace

template <class Method>
OpenRun<Method>::OpenRun(const RunRequest& request, Context& context)
    : request_(request),
      method_(request_, scratch_),
      warnings_(warnings_about(request_, method_, context)),
      place_(std::in_place, request_, context, scratch_, fmt::format("{}, {}", method_.size_words(), words_of_workers(context)), warnings_),
      run_(request_, context, method_, place_->folder(), place_->log(), warnings_)
{
  if constexpr (!FiniteElements<Method>)
    if (request_.shorter) method_.lengthen(std::make_unique<Method>(*request_.shorter, io::ScratchFolder()));
}

/// An error in writing the results of a run that failed is only logged.
template <class Method>
template <class Act>
auto OpenRun<Method>::leaving_results(const Act& act)
{
  try {
    return act();
  } catch (const KeyError& error) {
    throw input::LocatedError(request_.places.located(error));
  } catch (const RunError& error) {
    run_.come_to_rest();
    abort_ranks(error.what());
    try {
      run_.leave_results();
    } catch (const RunError& another) {
      io::warn("{}", another.what());
    }
    place_->log().info_to_file(error.what());
    place_.reset();
    throw;
  }
}

template <class Method>
void OpenRun<Method>::begin()
{
  leaving_results([&] {
    run_.begin();
    if (request_.shorter)
      place_->lengthen(request_, scratch_, warnings_, [&](const std::filesystem::path& folder) { run_.keep_in(folder); });
  });
}

template <class Method>
bool OpenRun<Method>::advance()
{
  return leaving_results([&] { return run_.advance(); });
}

template <class Method>
void OpenRun<Method>::keep()
{
  run_.keep();
}

template <class Method>
void OpenRun<Method>::step_aside()
{
  if (place_) place_->log().step_aside();
}

template <class Method>
void OpenRun<Method>::take_over()
{
  if (place_) place_->log().take_over();
}

template <class Method>
bool OpenRun<Method>::end_without_results()
{
  run_.end();
  place_.reset();
  return run_.finished();
}

template <class Method>
bool OpenRun<Method>::end()
{
  leaving_results([&] { run_.end(); });
  try {
    run_.leave_results();
    run_.remove_checkpoints();
    place_->log().check();
  } catch (const RunError& error) {
    place_->log().info_to_file(error.what());
    throw;
  }
  place_.reset();
  return run_.finished();
}

template <class Method>
bool OpenRun<Method>::to_the_end()
{
  begin();
  while (advance()) {
  }
  return end();
}

AnyOpenRun open_run(const RunRequest& request, Context& context)
{
  return with_method(request, [&](const auto& kind, const RunRequest& loaded) -> AnyOpenRun {
    using Method = typename std::decay_t<decltype(kind)>::type;
    return std::make_unique<OpenRun<Method>>(loaded, context);
  });
}

template class OpenRun<MpmMethod<2>>;
template class OpenRun<MpmMethod<3>>;
template class OpenRun<FemMethod>;
template class OpenRun<SpaceFemMethod>;
template class OpenRun<PipelineMethod>;

}  // namespace berm::simulation
