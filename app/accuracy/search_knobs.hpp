// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The knobs of the search.
#ifndef APP_ACCURACY_SEARCH_KNOBS_HPP
#define APP_ACCURACY_SEARCH_KNOBS_HPP

#include "accuracy/trade.hpp"

#include <vector>

namespace accuracy {

// In the order of the report.
const std::vector<Knob> &search_knobs();

}  // namespace accuracy

#endif
