// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Pairs as an index sees them: particles in the box, one of them perhaps through an image.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/particles/particle_store.hpp"

namespace hg {

// Do the particles of two slots interact, the first seen through an image? Decided on the caller's doubles.
inline bool interact(const Index &index, const ParticleStore &store, const Overlap &overlap, uint32_t a, uint32_t b,
                     Image image, int64_t &exact) {
  const Domain &domain = index.domain;
  if (!domain.any_periodic) return overlap.is_pair(store.ball(a), store.ball(b), Shift{}, exact);
  // An image of itself is a partner only where all are.
  if (a == b && !domain.all_images) return false;
  const Shift shift = index.shifts[image] + domain.boxes(store.center(b)) - domain.boxes(store.center(a));
  return overlap.is_pair(store.ball(a), store.ball(b), shift, exact);
}

}  // namespace hg
