// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "record/run_record.hpp"

namespace berm::report {

/// Project, client, revision and who made and checked it, of [report] in the first run's case, as HTML for the head of the page; "" where none is given.
std::string document_lines(const record::RunRecord& run);

/// What stands at the foot of each printed page: project, document and revision; "" where none is given.
std::string document_foot(const record::RunRecord& run);

/// The section "Record": documents, what each run is made from and by which program with SHA-256, dates, units, editions of the codes that are quoted.
std::string origin_section(const std::vector<record::RunRecord>& runs);

}  // namespace berm::report
