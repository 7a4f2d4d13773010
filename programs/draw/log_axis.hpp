// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A logarithmic axis: its range, its ticks, and where a value lies.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace draw {

class LogAxis {
 public:
  // `values` > 0, at least one. `from` and `to` are the pixels of the two ends.
  LogAxis(const std::vector<double> &values, double from, double to) : from_(from), to_(to) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    low_ = std::log10(*least);
    high_ = std::log10(*most);
    // At least a decade, so that there are ticks and small differences look small.
    const double room = std::max(0.07 * (high_ - low_) + 0.06, 0.5 * (1 - (high_ - low_)));
    low_ -= room;
    high_ += room;
  }

  double place(double value) const { return from_ + (to_ - from_) * (std::log10(value) - low_) / (high_ - low_); }

  // Powers of ten, every second or third of them on long axes; on short ones 2 and 5 times these too.
  std::vector<double> ticks() const {
    const double decades = high_ - low_;
    const int stride = std::max(1, static_cast<int>(std::ceil(decades / 6)));
    std::vector<double> result;
    for (int power = static_cast<int>(std::floor(low_)); power <= high_; power++) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit > 1 ? decades > 2.5 : power % stride != 0) continue;
        const double value = digit * std::pow(10.0, power), logarithm = std::log10(value);
        if (logarithm >= low_ && logarithm <= high_) result.push_back(value);
      }
    }
    return result;
  }

 private:
  double from_, to_, low_ = 0, high_ = 1;
};

}  // namespace draw
