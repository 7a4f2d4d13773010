// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause

// The cube root with the same bits on every machine.
#ifndef HGRID_SIM_CUBE_ROOT_HPP
#define HGRID_SIM_CUBE_ROOT_HPP

namespace hgrid_sim {

// x^(1/3), x > 0, by Newton's iteration from above. std::cbrt may differ in its last bit between C libraries, and with
// it every coordinate of a packing.
inline double cube_root(double x) {
  double root = x > 1 ? x : 1;
  for (;;) {
    const double next = root - (root - x / (root * root)) / 3;
    if (!(next < root)) return root;
    root = next;
  }
}

}  // namespace hgrid_sim

#endif
