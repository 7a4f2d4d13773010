// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The contacts of a batch that rub and remember, some at a time: between what all of them have in common, side by side,
// stand the laws.
#pragma once

#include "dem/kernels/contact_kernel.hpp"
#include "dem/kernels/pair_contact.hpp"
#include "dem/kernels/rough_batch.hpp"

#include <algorithm>

namespace dem {

template <EffectSet E, int D, class Real>
class RoughContacts {
 public:
  RoughContacts(const ContactTask<D, Real> &task, const PairRun<D, Real> &run) : task_(task), run_(run) {}

  void add_forces(const ContactBatch<Real> &batch) {
    for (size_t first = 0; first < batch.count; first += RoughBatch<Real>::kMost) {
      const size_t count = std::min(RoughBatch<Real>::kMost, batch.count - first);
      const RoughTask<D, Real> task{task_.bodies, run_.pairs, run_.first_body, run_.last_body, run_.history,
                                    task_.step,   &batch,     first,           count};
      task_.rough_kernels.gather(task, rough_);
      for (size_t k = 0; k < count; k++) press(batch, first + k, k);
      task_.rough_kernels.rub(task, rough_);
    }
  }

 private:
  // Contact p, the k-th here.
  void press(const ContactBatch<Real> &batch, size_t p, size_t k) {
    const hg_pair &pair = run_.pairs[batch.place[p]];
    const auto a = static_cast<size_t>(pair.a), b = static_cast<size_t>(pair.b);
    const ContactLaw<Real> &law = pair_law<E>(task_, a, b);
    NormalContact<Real> contact = normal_contact<E>(*task_.bodies, law, batch, p, a, b);
    Real *velocity = rough_.velocity[k].numbers;
    if constexpr (has(E, kShear)) velocity[0] -= batch.image_speed[p];
    if constexpr (has(E, kDissipation)) {
      contact.closing_speed = 0;
      for (int axis = 0; axis < D; axis++) contact.closing_speed += velocity[axis] * batch.normal[axis][p];
    }
    const NormalForce<Real> normal = normal_force<E, Real>(law, contact);
    rough_.pressing[k] = normal.value;
    put(friction_slider(law, normal), k, rough_.friction);
    if constexpr (has(E, kRolling)) {
      rough_.radius[k] = 1 / contact.inverse_radius;
      put(rolling_slider(law, normal), k, rough_.rolling);
    }
  }

  template <class Columns>
  static void put(const Slider<Real> &slider, size_t k, Columns &sliders) {
    sliders.stiffness[k] = slider.stiffness;
    sliders.damping[k] = slider.damping;
    sliders.limit[k] = slider.limit;
  }

  const ContactTask<D, Real> &task_;
  const PairRun<D, Real> &run_;
  RoughBatch<Real> rough_;
};

}  // namespace dem
