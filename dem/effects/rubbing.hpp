// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What acts along the surfaces of one contact: friction, and the resistance against rolling. Luding, Granul. Matter 10
// (2008) 235, sections 2.3 and 2.4. All in plain numbers without a branch, inlined whatever compilers think, so that
// they take many contacts at once.
#pragma once

#include "dem/base/vector.hpp"

#include <cmath>

namespace dem {

// Spring and dashpot side by side, in series with the slider of Cundall and Strack.
template <class Real>
struct Slider {
  Real stiffness, damping;
  Real limit;  // the most it bears
};

// From the relative velocity in the tangent plane of `normal` the force against the motion; `stretch` is what the
// spring remembers.
template <int D, class Real>
[[gnu::always_inline]] inline void slider_force(const Slider<Real> &slider, const Real *normal, const Real *velocity,
                                                Real step, Real *stretch, Real *force) {
  Real along = 0, square = 0, turned[D], stretched[D], asked[D];
  for (int k = 0; k < D; k++) along += normal[k] * stretch[k];
  for (int k = 0; k < D; k++) {
    turned[k] = stretch[k] - normal[k] * along;  // with the contact, since the last step
    stretched[k] = turned[k] + velocity[k] * step;
    asked[k] = -slider.stiffness * stretched[k] - slider.damping * velocity[k];
    square += asked[k] * asked[k];
  }
  // While the surfaces slide, spring and dashpot bear the limit together, so the spring follows at the rate that the
  // dashpot allows. Were it put where it bears the limit alone, a contact would be wound up further than it has moved,
  // and gain energy. Which contacts slide cannot be foreseen.
  const Real size = std::sqrt(square), share = slider.limit / size;
  const Real firmness = slider.damping + slider.stiffness * step, give = 1 / firmness;
  const bool slides = size > slider.limit, yields = firmness > 0;
  const bool pressed = slider.limit > 0;  // else there is nothing to remember
  for (int k = 0; k < D; k++) {
    const Real borne = slides ? asked[k] * share : asked[k];
    const Real followed = yields ? (slider.damping * turned[k] - step * borne) * give : turned[k];
    const Real left = slides ? followed : stretched[k];
    force[k] = pressed ? borne : Real(0);
    stretch[k] = pressed ? left : Real(0);
  }
}

// Friction: `velocity` is that of the centres, `turning` arm times spin of both together. Its moment is a torque per
// arm.
template <int D, class Real>
[[gnu::always_inline]] inline void rub(const Slider<Real> &slider, const Real *normal, const Real *velocity,
                                       const Real *turning, Real step, Real *stretch, Real *force, Real *moment) {
  Real surface[D], along = 0;
  turn_arm<D>(turning, normal, surface);
  for (int k = 0; k < D; k++) surface[k] += velocity[k];
  for (int k = 0; k < D; k++) along += normal[k] * surface[k];
  for (int k = 0; k < D; k++) surface[k] -= normal[k] * along;
  slider_force<D>(slider, normal, surface, step, stretch, force);
  moment_of<D>(normal, force, moment);
}

// Rolling: `spin` is relative, `radius` reduced.
template <int D, class Real>
[[gnu::always_inline]] inline void roll(const Slider<Real> &slider, const Real *normal, const Real *spin, Real radius,
                                        Real step, Real *stretch, Real *torque) {
  Real rolled[D], force[D];
  turn_arm<D>(spin, normal, rolled);
  for (int k = 0; k < D; k++) rolled[k] *= radius;
  slider_force<D>(slider, normal, rolled, step, stretch, force);
  moment_of<D>(normal, force, torque);
  for (int k = 0; k < (D == 3 ? 3 : 1); k++) torque[k] *= radius;
}

}  // namespace dem
