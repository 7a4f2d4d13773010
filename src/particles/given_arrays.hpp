// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Particles that a caller keeps in arrays of any stride and type, gathered into the rows that a grid takes.
#pragma once

#include "src/base/error.hpp"
#include "src/base/memory.hpp"

#include <hgrid/types.h>

#include <cstdint>
#include <cstring>

namespace hg {

// Kept from call to call, so that steps allocate nothing.
class GivenArrays {
 public:
  explicit GivenArrays(Memory &memory) : centers_(memory), radii_(memory) {}

  // Rows of `count` particles; radius may be NULL.
  void gather(size_t count, size_t dimension, const hg_array *centers, const hg_array *radius) {
    if (count == 0) return;
    if (centers == nullptr) fail(HG_ERR_NULL, "centers is NULL");
    check(centers[0], "centers[0]");
    check(centers[1], "centers[1]");
    if (dimension == 3) check(centers[2], "centers[2]");
    if (radius != nullptr) check(*radius, "radius");
    centers_.require_room(array_bytes(count, dimension));
    for (size_t axis = 0; axis < dimension; axis++) copy(centers[axis], count, centers_.data() + axis, dimension);
    if (radius == nullptr) return;
    radii_.require_room(count);
    copy(*radius, count, radii_.data(), 1);
  }

  const double *centers() const { return centers_.data(); }
  const double *radii() const { return radii_.data(); }

 private:
  static void check(const hg_array &array, const char *name) {
    if (array.data == nullptr) fail(HG_ERR_NULL, "%s.data is NULL", name);
    if (array.type != HG_REAL64 && array.type != HG_REAL32) {
      fail(HG_ERR_ARGUMENT, "%s.type = %d is neither HG_REAL64 nor HG_REAL32", name, static_cast<int>(array.type));
    }
    if (array.reserved != 0) {
      fail(HG_ERR_ARGUMENT, "%s.reserved = %d is not 0", name, static_cast<int>(array.reserved));
    }
  }

  static void copy(const hg_array &array, size_t count, double *to, size_t width) {
    if (array.type == HG_REAL32) {
      copy_as<float>(array, count, to, width);
    } else {
      copy_as<double>(array, count, to, width);
    }
  }

  template <class T>
  static void copy_as(const hg_array &array, size_t count, double *to, size_t width) {
    const char *from = static_cast<const char *>(array.data);
    for (size_t row = 0; row < count; row++) {
      T value;
      std::memcpy(&value, from + static_cast<int64_t>(row) * array.stride, sizeof value);
      to[row * width] = static_cast<double>(value);
    }
  }

  Buffer<double> centers_, radii_;
};

}  // namespace hg
