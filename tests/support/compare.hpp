// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Grids filled at once, and comparisons that throw a text which says what differs.
//
// cmocka leaves a failed assertion by longjmp, which skips destructors. Checks therefore run inside holds(), which
// turns a Failure into a message with the seed and a plain bool for assert_true.
#pragma once

#include "tests/support/oracle.hpp"

#include <hgrid/hgrid.h>
#include <hgrid/hgrid.hpp>

#include <stdexcept>
#include <string>

namespace hgtest {

class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require(bool condition, const std::string &what);
void require_same(const char *what, const Pairs &got, const Pairs &expected);
void require_same(const char *what, const std::vector<int32_t> &got, const std::vector<int32_t> &expected);

// The status with which the library refuses a call; HG_OK if it does not.
template <class Call>
hg_status status_of(Call call) {
  try {
    call();
    return HG_OK;
  } catch (const hgrid::Error &error) {
    return error.status();
  }
}

using hgrid::Grid;
Grid make_grid(const hg_grid_def &def, const Particles &particles);

// The pairs in the order of the library, and sorted by id.
Pairs pairs_of(const Grid &grid);
Pairs sorted_pairs_of(const Grid &grid);
Pairs sorted(Pairs pairs);

// Prints the seed and the text of the Failure; true if there was none.
void report(uint64_t seed, const char *text);
template <class Check>
bool holds(uint64_t seed, Check check) {
  try {
    check(seed);
    return true;
  } catch (const std::exception &e) {
    report(seed, e.what());
    return false;
  }
}

}  // namespace hgtest
