// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows of four numbers, which move whole: what belongs together in the loops stands together in memory.
#pragma once

#include "dem/base/vector.hpp"

namespace dem {

// A vector and a number; in two dimensions the third number is 0.
template <class Real>
struct alignas(4 * sizeof(Real)) Row {
  typedef Real Four __attribute__((vector_size(4 * sizeof(Real)), may_alias));  // NOLINT: no `using` for attributes

  Real numbers[4];

  // All of them.
  Four &four() { return *reinterpret_cast<Four *>(numbers); }
  const Four &four() const { return *reinterpret_cast<const Four *>(numbers); }

  // The first numbers.
  template <int width>
  Eigen::Map<Vec<width, Real>> vector() {
    return Eigen::Map<Vec<width, Real>>(numbers);
  }
  template <int width>
  Eigen::Map<const Vec<width, Real>> vector() const {
    return Eigen::Map<const Vec<width, Real>>(numbers);
  }
};

}  // namespace dem
