// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/expectations/expectation_test.cpp
#include "structures/base/published_point.hpp"

namespace berm::base {
namespace {

const std::vector<const char*> chart_words = {"V_w", "H_u", "w_u"};

}  // namespace

void describe(Describe& d, PublishedPoint& point)
{
  d.choice("chart", point.chart, chart_words, {.meaning = "chart that it stands in", .required = true});
  d.value("x", point.x, {.meaning = "w or u; absent: a level over the whole chart", .unit = "m"});
  d.value("y", point.y, {.meaning = "V, H or w", .unit = point.chart == PublishedPoint::Chart::w_u ? "m" : "N/m", .required = true});
  d.value("label", point.label, {.meaning = "what is written beside it", .required = true});
}

const char* word_of(PublishedPoint::Chart chart)
{
  return chart_words[static_cast<std::size_t>(chart)];
}

}  // namespace berm::base
