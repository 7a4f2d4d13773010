// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// One contact of a batch with what the laws ask of its two particles.
#pragma once

#include "dem/kernels/contact_kernel.hpp"

namespace dem {

// What the normal force of contact p of the batch depends on, but for the closing speed.
template <EffectSet E, int D, class Real>
inline NormalContact<Real> normal_contact([[maybe_unused]] const Bodies<D, Real> &bodies,
                                          [[maybe_unused]] const ContactLaw<Real> &law, const ContactBatch<Real> &batch,
                                          size_t p, [[maybe_unused]] size_t a, [[maybe_unused]] size_t b) {
  NormalContact<Real> contact;
  contact.overlap = batch.touching[p] - batch.distance[p];
  if constexpr (has(E, kNeedMass)) contact.inverse_mass = bodies.inverse_mass(a) + bodies.inverse_mass(b);
  if constexpr (has(E, kNeedRadius)) contact.inverse_radius = 1 / bodies.radius(a) + 1 / bodies.radius(b);
  if constexpr (has(E, kModulus) && has(E, kMaterials))
    contact.inverse_length = law.share[0] / bodies.radius(a) + law.share[1] / bodies.radius(b);
  return contact;
}

// The velocity of a relative to the image of b that it meets.
template <EffectSet E, int D, class Real>
inline Vec<D, Real> relative_velocity(const Bodies<D, Real> &bodies, [[maybe_unused]] const ContactBatch<Real> &batch,
                                      [[maybe_unused]] size_t p, size_t a, size_t b) {
  Vec<D, Real> velocity = bodies.velocity(a) - bodies.velocity(b);
  if constexpr (has(E, kShear)) velocity[0] -= batch.image_speed[p];
  return velocity;
}

// Inlined whatever the compiler thinks: to gcc 12 a call that only fetches has no effect, and is left out.
template <int D, class Real>
[[gnu::always_inline]] inline void fetch_ahead(const Bodies<D, Real> &bodies, const hg_pair *pairs,
                                               const ContactBatch<Real> &batch, size_t p) {
#ifdef __GNUC__
  const hg_pair &pair = pairs[place_ahead(batch, p, batch.count)];
  const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
  __builtin_prefetch(&bodies.moves[a], 1);
  __builtin_prefetch(&bodies.moves[b], 1);
#endif
}

}  // namespace dem
