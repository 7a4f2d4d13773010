// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Where pairs come from: a search of an index, or stored candidates. Cut into tasks, whose order is that of the pairs.
#pragma once

#include "src/kernels/kernel.hpp"

#include <cstddef>

namespace hg {

class PairSource {
 public:
  virtual size_t task_count() const = 0;
  // Makes a sink ready for the pairs of this source.
  virtual void prepare(PairSink &sink) const = 0;
  // Sends the pairs of one task to the sink. False if the sink stopped.
  virtual bool run(size_t task, PairSink &sink) const = 0;

 protected:
  ~PairSource() = default;
};

}  // namespace hg
