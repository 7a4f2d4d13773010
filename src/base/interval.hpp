// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The least and the greatest of many numbers.
#pragma once

namespace hg {

struct Interval {
  double least, greatest;
};

}  // namespace hg
