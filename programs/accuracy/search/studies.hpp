// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What is varied of the search, each study in a file of its name.
#pragma once

#include "programs/accuracy/figure.hpp"
#include "programs/accuracy/study.hpp"

#include <vector>

namespace accuracy {

const std::vector<Study> &search_studies();
const Figure &search_figure();

void measure_decision_rules(Recorder &record);
void measure_rebuild_criteria(Recorder &record);
void measure_level_choices(Recorder &record);
void measure_level_counts(Recorder &record);
void measure_prefilter(Recorder &record);

}  // namespace accuracy
