// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Whether a periodic cell is long enough for the particles in it: two of them shall not meet twice, unless all images
// count, and no particle shall reach across more cells than can be listed.
#pragma once

#include "src/exact/domain.hpp"
#include "src/exact/interaction.hpp"
#include "src/exact/lattice.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// The two largest of some particles, by their places among them.
struct TwoLargest {
  size_t count = 0;  // how many there are, 2 at most
  size_t place[2] = {0, 0};
  double radius[2] = {0, 0};

  void include(size_t at, double r) {
    if (count == 0 || r > radius[0]) {
      place[1] = place[0];
      radius[1] = radius[0];
      place[0] = at;
      radius[0] = r;
    } else if (count == 1 || r > radius[1]) {
      place[1] = at;
      radius[1] = r;
    }
    if (count < 2) count++;
  }
};

class ShortCell {
 public:
  ShortCell(const Domain &domain, const Interaction &interaction)
      : domain_(domain), interaction_(interaction), short_(find_short_vectors(domain)) {}

  // True if a cell needs no closer look, whatever the sizes of particles up to that radius.
  bool is_long_for(double radius) const;
  // Throws an Error that names particles by their ids if the cell is too short for them.
  void check(const TwoLargest &largest, const int32_t (&ids)[2]) const;
  // The same of those particles that count; `greatest`: no radius is larger. O(1) in a long cell.
  template <class Counts, class IdOf>
  void check(const double *radii, size_t count, double greatest, Counts &&counts, IdOf &&id_of) const {
    if (is_long_for(greatest)) return;
    TwoLargest largest;
    for (size_t k = 0; k < count; k++) {
      if (counts(k)) largest.include(k, radii[k]);
    }
    check(largest, {id_of(largest.place[0]), id_of(largest.place[1])});
  }

 private:
  Domain domain_;
  Interaction interaction_;
  ShortVectors short_;
};

}  // namespace hg
