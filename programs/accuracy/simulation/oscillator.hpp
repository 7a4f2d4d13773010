// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The closed form of a collision with a linear spring and dashpot: half a swing of a damped oscillator.
#pragma once

#include <cmath>

namespace accuracy {

constexpr double kPi = 3.14159265358979323846;

// x'' = -omega^2 x - 2 eta x' from x = 0 until x = 0 again. With w = sqrt(omega^2 - eta^2) that lasts t_c = pi / w, and
// the speed falls to e = exp(-eta t_c).
class Oscillator {
 public:
  // `mass` is the reduced mass.
  Oscillator(double stiffness, double mass, double restitution)
      : omega_(std::sqrt(stiffness / mass)), zeta_(-std::log(restitution) / std::hypot(kPi, std::log(restitution))) {}

  double duration() const { return kPi / (omega_ * std::sqrt(1 - zeta_ * zeta_)); }

  // Where x' = 0, at the phase w t = arctan(w / eta) = arccos(eta / omega).
  double largest_overlap(double speed) const {
    return speed / omega_ * std::exp(-zeta_ / std::sqrt(1 - zeta_ * zeta_) * std::acos(zeta_));
  }

  double damping_ratio() const { return zeta_; }  // eta / omega

 private:
  double omega_, zeta_;
};

}  // namespace accuracy
