// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The knobs of the search.
#pragma once

#include "programs/accuracy/trade.hpp"

#include <vector>

namespace accuracy {

// In the order of the report.
const std::vector<Knob> &search_knobs();

}  // namespace accuracy
