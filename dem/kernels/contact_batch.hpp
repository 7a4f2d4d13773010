// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Of the pairs that may touch those that do, in batches with their geometry.
#pragma once

#include "dem/state/bodies.hpp"
#include "dem/state/boundary.hpp"

#include <hgrid/hgrid.h>

#include <cstddef>
#include <cstdint>

namespace dem {

// Arrays of numbers, so that vectors of any width fill them; small enough for the first cache.
template <class Real>
struct ContactBatch {
  static constexpr size_t kMost = 512, kWidest = 16;  // contacts, and what one step may write beyond the last

  size_t count = 0;
  uint32_t place[kMost + kWidest];  // of the pair in its list
  Real normal[3][kMost + kWidest];  // from a to the image of b that it meets, of length 1
  Real distance[kMost + kWidest];
  Real touching[kMost + kWidest];     // r_a + r_b
  Real image_speed[kMost + kWidest];  // along x, that b has besides its own with this image (shear)
};

// First particles of a list follow one another in memory; second ones do not, and are asked for in time. The place of
// the pair to ask for at contact p of those before `end`.
template <class Real>
[[gnu::always_inline]] inline size_t place_ahead(const ContactBatch<Real> &batch, size_t p, size_t end) {
  constexpr size_t kContactsAhead = 12;
  return batch.place[p + kContactsAhead < end ? p + kContactsAhead : p];
}

template <int D, class Real>
struct BatchTask {
  const Row<Real> *places;
  const Boundary<D, Real> *boundary;
  const hg_pair *pairs;
  Real range;  // how far surfaces act beyond touching
};

// Fills the batch from pairs next .. last - 1; returns the next one to look at.
template <int D, class Real>
using BatchFiller = size_t (*)(const BatchTask<D, Real> &task, size_t next, size_t last, ContactBatch<Real> &batch);

// For the effects on images, with the vectors that this machine has and HGRID_ISA allows: all give the same bits.
template <int D, class Real>
BatchFiller<D, Real> find_batch_filler(EffectSet effects);

}  // namespace dem
