// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What is varied of the simulation, each study in a file of its name.
#pragma once

#include "programs/accuracy/figure.hpp"
#include "programs/accuracy/study.hpp"

#include <vector>

namespace accuracy {

const std::vector<Study> &simulation_studies();
const Figure &simulation_figure();

void measure_time_steps(Recorder &record);
void measure_state_precision(Recorder &record);
void measure_rounding(Recorder &record);
void measure_skin_lengths(Recorder &record);

}  // namespace accuracy
