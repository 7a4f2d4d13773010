// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Theory of hard spheres of many sizes in equilibrium at kT = 1: contact values of Boublik (1970) and Mansoori et al.
// (1971), pressure and rates of collisions that follow from them. For one size they are Carnahan & Starling's.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace theory {

constexpr double kPi = 3.14159265358979323846;

class HardSpheres {
 public:
  HardSpheres(std::vector<double> radii, double volume) : radii_(std::move(radii)), volume_(volume) {
    for (const double r : radii_) {
      xi2_ += kPi / 6 * 4 * r * r / volume;
      xi3_ += kPi / 6 * 8 * r * r * r / volume;
    }
  }

  // The density of partners of size b at the surface of one of size a, over their mean density.
  double contact_value(double a, double b) const {
    const double free = 1 - xi3_, s = xi2_ * 2 * a * b / (a + b);
    return 1 / free + 3 * s / (free * free) + 2 * s * s / (free * free * free);
  }

  // p V / (N kT), by the virial.
  double compressibility() const {
    return 1 + sum([](double reach, double g, size_t, size_t) { return reach * reach * reach * g; }) * (2 * kPi / 3);
  }

  // Collisions of a particle per time, on average.
  double rate(const std::vector<double> &masses) const {
    return sum([&](double reach, double g, size_t i, size_t j) {
      return reach * reach * g * std::sqrt(8 * kPi * (1 / masses[i] + 1 / masses[j]));
    });
  }

  // Partners of a particle within so small a gap, on average.
  double neighbours(double gap) const {
    return 4 * kPi * gap * sum([](double reach, double g, size_t, size_t) { return reach * reach * g; });
  }

 private:
  // Over all ordered pairs, per particle and volume.
  template <class Term>
  double sum(const Term &term) const {
    double total = 0;
    for (size_t i = 0; i < radii_.size(); i++) {
      for (size_t j = 0; j < radii_.size(); j++) {
        total += term(radii_[i] + radii_[j], contact_value(radii_[i], radii_[j]), i, j);
      }
    }
    return total / (static_cast<double>(radii_.size()) * volume_);
  }

  std::vector<double> radii_;
  double volume_, xi2_ = 0, xi3_ = 0;
};

}  // namespace theory
