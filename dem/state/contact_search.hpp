// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs that may touch soon, from the library.
#pragma once

#include "dem/effects/contact_law.hpp"
#include "dem/setup/setup.hpp"

#include <hgrid/hgrid.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace dem {

using PairView = hgrid::View<hg_pair>;

// The rounding of a distance between particles of the setup in these numbers, many times over: added to every reach,
// for those who decide whether they touch.
template <class Real>
double rounding_slack(const Setup &setup) {
  double longest = 2 * contact_range(setup);
  visit_particles(
      setup, [&](const ParticleArrays &particles, size_t i) { longest = std::max(longest, 4 * particles.radii[i]); });
  for (int axis = 0; axis < setup.dimension; axis++) {
    if (setup.periodic[axis]) longest += setup.box_max[axis] - setup.box_min[axis];
  }
  return 32 * static_cast<double>(std::numeric_limits<Real>::epsilon()) * longest;
}

// What of the setup's skin is of use: a periodic box must have room for it, and long before it is as wide as the
// smallest particle it does not pay.
double usable_skin(const Setup &setup, double slack);

// Of a grid that finds all pairs up to this margin beyond touching.
hg_grid_def contact_grid_def(const Setup &setup, double margin);

// Pairs come ascending, (a, b) with a < b. Which of them touch is decided later, by the positions alone: so their order
// among themselves, and every sum of forces, depends neither on threads nor on the skin.
class ContactSearch {
 public:
  ContactSearch(const Setup &setup, double slack);

  double skin() const { return skin_; }

  // The pairs that act on each other or could after each has moved and grown by half the skin; radii null if they and
  // the number of particles have not changed. `offset` is how far the images above have moved along x (shear): the tilt
  // of the periodic cell. The result lasts until the next call.
  PairView find(size_t count, const hg_array *centers, const hg_array *radius, double offset);

  // Particles that a ball acts on, or could after half the skin of either side; for the places of the last search.
  hgrid::View<int32_t> near_ball(const double *center, double radius) const {
    return grid_.query_sphere(center, radius);
  }

  // Particles that triangles, [count][3 corners][3], act on or could after half the skin of either side; for the places
  // of the last search, as long as that of others is not asked for.
  hgrid::Rows near_triangles(const std::vector<double> &corners) const;

  hg_grid_stats stats() const { return grid_.get_stats(); }

 private:
  double skin_;
  hg_grid_def def_;
  hgrid::Grid grid_;
  size_t count_;
  bool sheared_;
};

}  // namespace dem
