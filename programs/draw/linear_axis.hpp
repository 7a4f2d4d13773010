// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// An axis with even steps: its range, its ticks, and where a value lies.
#pragma once

#include <cmath>
#include <vector>

namespace draw {

class LinearAxis {
 public:
  // Low <= high; equal ones get some room. `from` and `to` are the pixels of the two ends.
  LinearAxis(double low, double high, double from, double to) : low_(low), high_(high), from_(from), to_(to) {
    if (high_ > low_) return;
    const double room = high_ != 0 ? 0.5 * std::fabs(high_) : 0.5;
    low_ -= room;
    high_ += room;
  }

  double place(double value) const { return from_ + (to_ - from_) * (value - low_) / (high_ - low_); }

  // Multiples of 1, 2 or 5 times a power of ten, six at most.
  std::vector<double> ticks() const {
    const double power = std::pow(10, std::floor(std::log10(high_ - low_)));
    double step = 2 * power;
    for (const double factor : {1.0, 0.5, 0.2}) {
      if ((high_ - low_) / (factor * power) <= 6) step = factor * power;
    }
    std::vector<double> result;
    const auto first = static_cast<long>(std::ceil(low_ / step - 1e-9)),
               last = static_cast<long>(std::floor(high_ / step + 1e-9));
    for (long k = first; k <= last; k++) result.push_back(static_cast<double>(k) * step);
    return result;
  }

 private:
  double low_, high_, from_, to_;
};

}  // namespace draw
