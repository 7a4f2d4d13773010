// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The vectors of packings. In two dimensions the third component is 0 throughout.
#pragma once

#include <Eigen/Core>

namespace packing {

using Vector = Eigen::Vector3d;

// Sums in one written order: Eigen's own reductions add in an order that depends on the instruction set, and with it
// the last bit.
inline double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double square(const Vector &a) { return dot(a, a); }

}  // namespace packing
