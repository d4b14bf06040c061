// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/archive.hpp"

#include <functional>

namespace berm::simulation {

/// Where an MPI launcher started several processes of this program, makes them the ranks of one run; all but the first print nothing. Throws RunError where
/// the library that they need, libberm_mpi.so, is not there.
void join_ranks();

/// Ends the part of this process in the run, which failed for this reason where it says one, and returns the status. Does not return where others do not end,
/// too: then all are ended.
int leave_ranks(int status, const std::string& why);

/// Does what only the first rank may do before a run. Where that throws, the others throw, too.
void on_first_rank(const std::function<void()>& act);

/// Returns where all ranks have failed, or where there is one. Where the others do not come here, this one has failed alone: it says why, and all are ended.
void abort_ranks(const std::string& why);

/// Whether it holds on some rank.
bool on_any_rank(bool of_rank);

/// Whether it holds on some rank, at the end of a run that all ranks end: from here on they wait for each other as long as it takes.
bool ends_on_any_rank_with(bool of_rank);

/// Gives the others what the first rank has; visit(k) names it, and may throw RunError. False, and nothing, where `has_it` is false there.
bool broadcast(bool has_it, const std::function<void(Archive&)>& visit);

/// Gives the first rank what each of the others has: visit(k, rank) names what that rank has, on it and on the first.
void gather_on_first_rank(const std::function<void(Archive&, int)>& visit);

}  // namespace berm::simulation
