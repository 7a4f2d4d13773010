// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What the tests of hgrid.hpp share: a grid with a known answer, expected failures, and the frame of a test.
#pragma once

#include "tests/support/compare.hpp"
#include "tests/support/frame.h"

#include <hgrid/hgrid.hpp>

#include <string>

namespace hgtest {

// Four spheres in a row, each of which meets the next one only.
inline constexpr size_t kChain = 4;
inline constexpr double kCenters[3 * kChain] = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
inline constexpr double kRadii[kChain] = {0.6, 0.6, 0.6, 0.6};

inline hgrid::Grid chain() {
  hg_grid_def def = hg_default_grid_def();
  def.pair_order = HG_ORDER_ID;
  hgrid::Grid grid(def);
  grid.insert(kChain, kCenters, kRadii);
  return grid;
}

inline void require_chain(hgrid::Grid &grid) {
  const hgrid::View<hg_pair> pairs = grid.query_pairs();
  require_same("pairs of the chain", Pairs(pairs.begin(), pairs.end()), {{0, 1}, {1, 2}, {2, 3}});
}

// The call throws hgrid::Error with this status and the text of hg_last_error, in which `word` stands.
template <class Call>
void require_error(hg_status status, const std::string &word, Call call) {
  try {
    call();
  } catch (const hgrid::Error &error) {
    require(error.status() == status, std::string("another status: ") + hg_status_string(error.status()));
    require(error.what() == std::string(hg_last_error()), std::string("another text: ") + error.what());
    require(std::string(error.what()).find(word) != std::string::npos, word + " is not in: " + error.what());
    return;
  }
  throw Failure("nothing was thrown where " + std::string(hg_status_string(status)) + " is due");
}

// A check as cmocka calls it.
template <void (*check)()>
void run(void **) {
  assert_true(holds(0, [](uint64_t) { check(); }));
}

}  // namespace hgtest
