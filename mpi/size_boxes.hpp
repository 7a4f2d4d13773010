// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a rank tells all others of its particles: for each class of sizes (radii with the same binary exponent) a box
// that holds the centres, and the range of the radii. Enough to know which particles may meet any of them.
#pragma once

#include "mpi/cell.hpp"

#include <cstddef>
#include <vector>

namespace hgrid::mpi {

// Sent between ranks as bytes.
struct SizeBox {
  Box box;
  double smallest, largest;  // radius
};

// centers: [count][dimension]. On a periodic axis the box may stand wherever an image of the particles is: it is drawn
// around the shortest arc that holds all of them, or nearly so.
std::vector<SizeBox> make_size_boxes(const Cell &cell, size_t count, const double *centers, const double *radii);

// What of particles may have to be where others are.
class ReachRule {
 public:
  ReachRule(const hg_grid_def &def)
      : cell_(def), max_range_(def.interaction == HG_MAX_RANGE), margin_(def.margin), skin_(def.skin) {}

  const Cell &cell() const { return cell_; }
  // Whether a particle may meet, as the larger of the two, one of those in the box, until all have used up the skin.
  bool may_meet(const SizeBox &others, const double *center, double radius) const;
  // Whether any particle of one box may so meet one of the other.
  bool may_meet(const SizeBox &others, const SizeBox &mine) const;

 private:
  double reach(double larger, double smaller) const;

  Cell cell_;
  bool max_range_;
  double margin_, skin_;
};

}  // namespace hgrid::mpi
