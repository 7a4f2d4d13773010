// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Averages over the box: stress, fabric, coordination, granular temperature.
//
//   stress    V s = sum over contacts of (force on b) (branch from a to b) + sum over particles of m c c
//             walls: the branch reaches from the centre to the contact (Love 1927; Weber 1966)
//   c         velocity less the mean of all that can move; with shear less the profile of it instead
//   rattlers  particles with fewer than D + 1 contacts, D with friction, and then those that these leave so
#pragma once

#include "dem/engine/contact_loads.hpp"

#include <cstdint>
#include <vector>

namespace dem {

// Two particles that overlap, or a particle and a wall.
struct TouchingPair {
  static constexpr uint32_t kWall = static_cast<uint32_t>(-1);

  uint32_t a, b;
};

template <int D>
class BulkMeasure {
 public:
  void add(const ContactLoad<D> &load);

  // Of those contacts and the particles of a state. Without a box on all axes there is no volume: the stress is then
  // multiplied by it.
  Bulk of(const Setup &setup, const Snapshot &state) const;

 private:
  using Tensor = Eigen::Matrix<double, D, D, Eigen::DontAlign>;

  Tensor stress_ = Tensor::Zero(), fabric_ = Tensor::Zero();
  double pairs_ = 0;
  std::vector<TouchingPair> touching_;
};

}  // namespace dem
