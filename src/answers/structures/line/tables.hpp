// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "structures/line/answers.hpp"

namespace berm::line {

/// The key results of a run as tables of its log; "" where its line has not been loaded.
std::string log_tables(const record::RunRecord& run);

/// The same for the page, HTML; `id` begins the names of the tables.
std::string page_tables(const record::RunRecord& run, const std::string& id);

/// What Hobbs' theory and springs give beside a run at the ends of its heated stages, HTML; "" where there is neither.
std::string tables_beside(const record::RunRecord& run, const std::string& id);

}  // namespace berm::line
