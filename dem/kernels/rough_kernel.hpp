// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contacts of a batch that rub and remember: looked at one by one up to what rubs, that side by side, and added to
// their particles one by one again. Rows move whole: numbers put together from parts would wait for each other.
#pragma once

#include "dem/kernels/contact_kernel.hpp"
#include "dem/kernels/pair_contact.hpp"
#include "dem/kernels/rough_batch.hpp"

#include <algorithm>

namespace dem {

template <EffectSet E, int D, class Real>
class RoughContacts {
  using Batch = RoughBatch<D, Real>;
  using Sliders = SliderColumns<D, Real, Batch::kMost>;
  using Four = typename Row<Real>::Four;

 public:
  RoughContacts(const ContactTask<D, Real> &task, const PairRun<D, Real> &run) : task_(task), run_(run) {}

  void add_forces(const ContactBatch<Real> &batch) {
    for (size_t first = 0; first < batch.count; first += Batch::kMost) {
      const size_t count = std::min(Batch::kMost, batch.count - first);
      for (size_t k = 0; k < count; k++) gather(batch, first + k, k);
      recall(batch.place + first, count);
      const Real *const normal[3] = {batch.normal[0] + first, batch.normal[1] + first, batch.normal[2] + first};
      task_.rough_kernel(rough_, normal, count, task_.step);
      keep(batch.place + first, count);
      for (size_t k = 0; k < count; k++) spread(run_.pairs[batch.place[first + k]], k);
    }
  }

 private:
  // Of contact p, the k-th here: what presses it and how it moves.
  void gather(const ContactBatch<Real> &batch, size_t p, size_t k) {
    Bodies<D, Real> &bodies = *task_.bodies;
    fetch_ahead<E>(bodies, run_.pairs, batch, p);
    const hg_pair &pair = run_.pairs[batch.place[p]];
    const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    const ContactLaw<Real> &law = pair_law<E>(task_, a, b);
    NormalContact<Real> contact = normal_contact<E>(bodies, law, batch, p, a, b);
    Four velocity = bodies.moves[a].speed.four() - bodies.moves[b].speed.four();
    if constexpr (has(E, kShear)) velocity -= Four{batch.image_speed[p], 0, 0, 0};
    rough_.velocity[k].four() = velocity;
    if constexpr (has(E, kDissipation)) {
      contact.closing_speed = 0;
      for (int axis = 0; axis < D; axis++) contact.closing_speed += velocity[axis] * batch.normal[axis][p];
    }
    const NormalForce<Real> normal = normal_force<E, Real>(law, contact);
    rough_.pressing[k] = normal.value;
    put(friction_slider(law, normal), k, rough_.friction);
    // From the centres to the middle of the overlap.
    for (int side = 0; side < 2; side++) arm_[side][k] = bodies.radius(side == 0 ? a : b) - contact.overlap / 2;
    const Four spin_a = bodies.turns[a].speed.four(), spin_b = bodies.turns[b].speed.four();
    rough_.turning[k].four() = arm_[0][k] * spin_a + arm_[1][k] * spin_b;
    if constexpr (has(E, kRolling)) {
      rough_.radius[k] = 1 / contact.inverse_radius;
      rough_.spin[k].four() = spin_a - spin_b;
      put(rolling_slider(law, normal), k, rough_.rolling);
    }
  }

  static void put(const Slider<Real> &slider, size_t k, Sliders &sliders) {
    sliders.stiffness[k] = slider.stiffness;
    sliders.damping[k] = slider.damping;
    sliders.limit[k] = slider.limit;
  }

  // visit(row of what is remembered, columns)
  template <class Visit>
  void for_sliders(Visit visit) {
    visit(history_of(kFriction), rough_.friction);
    if constexpr (has(E, kRolling)) visit(history_of(kRolling), rough_.rolling);
  }

  // What the contacts at these places of the list remember; new ones nothing.
  void recall(const uint32_t *places, size_t count) {
    History<D, Real> &history = *run_.history;
    const size_t known = history.before.places.size();
    for (size_t k = 0; k < count; k++) former_[k] = history.find(places[k]);
    for_sliders([&](size_t row, Sliders &sliders) {
      const Vec<D, Real> *rows = history.before.rows[row].data();
      for (size_t k = 0; k < count; k++) {
        for (int axis = 0; axis < D; axis++)
          sliders.stretch[axis][k] = former_[k] < known ? rows[former_[k]][axis] : Real(0);
      }
    });
  }

  void keep(const uint32_t *places, size_t count) {
    Remembered<D, Real> &now = run_.history->now;
    const size_t first = now.places.size();
    now.places.insert(now.places.end(), places, places + count);
    for_sliders([&](size_t row, const Sliders &sliders) {
      now.rows[row].resize(first + count);
      Vec<D, Real> *rows = now.rows[row].data() + first;
      for (size_t k = 0; k < count; k++) {
        for (int axis = 0; axis < D; axis++) rows[k][axis] = sliders.stretch[axis][k];
      }
    });
  }

  void spread(const hg_pair &pair, size_t k) {
    Bodies<D, Real> &bodies = *task_.bodies;
    const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    const Four force = rough_.velocity[k].four(), moment = rough_.turning[k].four();
    Four torque_a = arm_[0][k] * moment, torque_b = arm_[1][k] * moment;
    if constexpr (has(E, kRolling)) {
      torque_a += rough_.spin[k].four();
      torque_b -= rough_.spin[k].four();
    }
    if (a >= run_.first_body) {
      bodies.moves[a].push.four() += force;
      bodies.turns[a].push.four() += torque_a;
    }
    if (b < run_.last_body) {
      bodies.moves[b].push.four() -= force;
      bodies.turns[b].push.four() += torque_b;
    }
  }

  const ContactTask<D, Real> &task_;
  const PairRun<D, Real> &run_;
  RoughBatch<D, Real> rough_;
  Real arm_[2][Batch::kMost];
  size_t former_[Batch::kMost];  // among the contacts of the pass before
};

}  // namespace dem
