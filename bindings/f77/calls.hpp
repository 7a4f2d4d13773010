// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The calls of FORTRAN 77, beneath the names that linkers see. docs/guide/f77.md describes them.
#pragma once

#include <cstdint>

namespace hgrid::f77 {

// What one call reads of the particles. Real is double (HGD...) or float (HGS...).
template <class Real>
struct Particles {
  const int32_t *handle, *count;
  const Real *x, *y, *z, *r;
};

void create(int32_t *handle, int32_t dimension, int32_t mode, double margin, const int32_t *periodic,
            const double *box_min, const double *box_max, int32_t *error) noexcept;
template <class Real>
void pairs(const char *name, const Particles<Real> &particles, int32_t capacity, int32_t *count, int32_t *first,
           int32_t *second, int32_t *error) noexcept;
template <class Real>
void lists(const char *name, const Particles<Real> &particles, int32_t capacity, int32_t *point, int32_t *list,
           int32_t *error) noexcept;
void end(int32_t *handle, int32_t *error) noexcept;

// Blanks fill the rest of the text.
void message(char *text, int32_t length) noexcept;

}  // namespace hgrid::f77
