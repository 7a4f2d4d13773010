// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The size laws of Ogarko & Luding (2012), sampled systematically: r_i = F^-1((i + 1/2) / N), r_min = 1.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace hgtest {

// p(r) = 1 / (omega - 1)
inline double uniform_size(double F, double omega) { return 1 + (omega - 1) * F; }
// p(r) ~ r^-3: each class of sizes holds the same volume
inline double uniform_volume(double F, double omega) { return 1 / std::sqrt(1 - F * (1 - 1 / (omega * omega))); }

using InverseCdf = double(double F, double omega);

inline std::vector<double> sample(InverseCdf *law, double omega, size_t count) {
  std::vector<double> radii(count);
  for (size_t i = 0; i < count; i++) {
    radii[i] = law((static_cast<double>(i) + 0.5) / static_cast<double>(count), omega);
  }
  return radii;
}

// Two sizes with equal total volumes, up to rounding the number of large ones.
inline std::vector<double> two_sizes(double omega, size_t count) {
  const size_t large = static_cast<size_t>(std::lround(static_cast<double>(count) / (1 + omega * omega * omega)));
  std::vector<double> radii(count - large, 1.0);
  radii.resize(count, omega);
  return radii;
}

}  // namespace hgtest
