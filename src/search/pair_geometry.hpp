// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What leads from one particle of a pair to the other: the shift of the image that it meets, and the vector.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/particles/particle_store.hpp"

#include <cstddef>
#include <vector>

namespace hg {

class PairGeometry {
 public:
  // `largest_reach`: of all pairs.
  PairGeometry(const Domain &domain, const ParticleStore &store, const Overlap &overlap, double largest_reach);

  // True if two particles may be several pairs.
  bool many_images() const { return many_images_; }

  // Of a pair, given by slots, that has one image only: its shift, and x_b + shift - x_a, each component rounded once.
  // Most pairs do not meet through a face.
  Shift find(size_t a, size_t b, double *components) const {
    return domain_.dimension == 3 ? find<3>(a, b, components) : find<2>(a, b, components);
  }
  template <int D>
  Shift find(size_t a, size_t b, double *components) const {
    const double *from = store_.centers() + a * D, *to = store_.centers() + b * D;
    double distance2 = 0;
    for (int axis = 0; axis < D; axis++) {
      components[axis] = to[axis] - from[axis];
      distance2 += components[axis] * components[axis];
    }
    return distance2 < sure2_ ? Shift{} : find_far(a, b, components);
  }
  // Of a pair that may have several: all of them, by x, then y, then z; of a particle with itself one of two opposite.
  void list_shifts(size_t a, size_t b, std::vector<Shift> &shifts) const;
  void vector(size_t a, size_t b, const Shift &shift, double *components) const;
  double reach(size_t a, size_t b) const { return overlap_.interaction().reach(store_.radius(a), store_.radius(b)); }

 private:
  template <class Visit>
  void visit_near(size_t a, size_t b, Visit &&visit) const;
  Shift find_far(size_t a, size_t b, double *components) const;
  Shift far_shift(size_t a, size_t b) const;
  Shift nearest(const double *a, const double *b, double &distance2) const;

  const Domain &domain_;
  const ParticleStore &store_;
  const Overlap &overlap_;
  double sure2_ = 0;  // squared: an image nearer than that is the only one
  bool many_images_;
};

}  // namespace hg
