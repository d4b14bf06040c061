// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/quality/judgement.hpp"

namespace berm::report {

/// Energy balance, quasi-static indicators, contact and mesh of all runs of the page, as HTML, with warnings in words.
std::string quality_section(const std::vector<record::RunRecord>& runs, const std::vector<Judgement>& judgements);

}  // namespace berm::report
