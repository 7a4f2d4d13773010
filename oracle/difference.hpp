// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// How a list of pairs differs from the truth.
#pragma once

#include "oracle/exact_set.hpp"

#include <algorithm>
#include <iterator>

namespace oracle {

struct Difference {
  Pairs missing, extra;  // ascending
};

// `truth` is ascending, `found` in any order. A pair that is found twice counts as extra.
inline Difference difference(const Pairs &truth, Pairs found) {
  std::sort(found.begin(), found.end());
  Difference result;
  std::set_difference(truth.begin(), truth.end(), found.begin(), found.end(), std::back_inserter(result.missing));
  std::set_difference(found.begin(), found.end(), truth.begin(), truth.end(), std::back_inserter(result.extra));
  return result;
}

}  // namespace oracle
