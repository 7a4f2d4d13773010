// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Periodic boxes for programs that know open axes only: they get the images that their users would make.
#pragma once

#include "programs/bench/search.hpp"

#include <cstdint>
#include <vector>

namespace bench {

bool is_periodic(const particles::ParticleSet &set);

// The particles wrapped into their box, and behind them, one box farther, images of those that a partner across a face
// can reach: of each pair across a face one particle is near the low side of it.
class Images {
 public:
  // `set` must outlive the images; the box is at least two of the largest diameters long.
  explicit Images(const particles::ParticleSet &set);

  // Makes all anew, in the same memory, as each search has to.
  void refresh();
  // Particles by their numbers, then images; all axes open.
  const particles::ParticleSet &all() const { return all_; }
  // The pairs of particles that pairs in `all` stand for, each once.
  void fold(PairView found, std::vector<hg_pair> &pairs) const;

 private:
  struct Origin {
    int32_t particle;
    uint32_t shifts;  // a bit for each axis along which it is moved
  };

  uint32_t axes_near_low_side(const double *center, double radius) const;

  const particles::ParticleSet *set_;
  double largest_radius_;
  particles::ParticleSet all_;
  std::vector<Origin> origins_;
};

// The contestant with images, which are made within its time.
Contestant with_images(Contestant contestant);

}  // namespace bench
