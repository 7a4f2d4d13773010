// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where pairs come from: a search of an index, or stored candidates. Cut into tasks, whose order is that of the pairs.
#pragma once

#include "src/kernels/pair_stream.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

class PairSource {
 public:
  virtual size_t task_count() const = 0;
  // Decides what the kernels leave undecided in the streams that it is given to.
  virtual PairJudge judge() const = 0;
  // Sends the pairs of one task to the stream, all decided. False if the output stopped.
  virtual bool send(size_t task, PairStream &stream) const = 0;

 protected:
  ~PairSource() = default;
};

// What a search did, for hg_grid_stats.
struct SearchCounts {
  int64_t candidates = 0, undecided = 0, exact = 0;
  void add(const PairStream &stream) {
    candidates += stream.candidate_total;
    undecided += stream.undecided_total;
    exact += stream.exact_total;
  }
};

}  // namespace hg
