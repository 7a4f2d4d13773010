// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// What a rank tells all others of its particles: for each class of sizes (radii with the same binary exponent) a box
// that holds the centres, and the range of the radii. Enough to know which particles may meet any of them.
#pragma once

#include "mpi/cell.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hgrid::mpi {

// Sent between ranks as bytes. In two dimensions it is flat: 0 along the third.
struct SizeBox {
  Box box;
  double smallest, largest;  // radius
};

// The particles of a rank by size. On a periodic axis they stand at images that lie close together: around the shortest
// arc that holds all of them, or nearly so.
struct SizeClasses {
  std::vector<SizeBox> boxes;      // of each class that there is
  std::vector<uint16_t> class_of;  // [count]
  std::vector<double> places;      // [count][3]
};

// centers: [count][dimension].
SizeClasses make_size_classes(const Cell &cell, size_t count, const double *centers, const double *radii);

// All classes as one. Without any, nothing is smaller and nothing in reach.
SizeBox box_around(const SizeBox *boxes, size_t count);

// How near two particles must come to meet, until all have used up the skin.
class ReachRule {
 public:
  ReachRule(const hg_grid_def &def)
      : cell_(def), max_range_(def.interaction == HG_MAX_RANGE), margin_(def.margin), skin_(def.skin) {}

  const Cell &cell() const { return cell_; }
  double reach(double larger, double smaller) const {
    return (max_range_ ? larger : larger + smaller) + margin_ + skin_;
  }

 private:
  Cell cell_;
  bool max_range_;
  double margin_, skin_;
};

}  // namespace hgrid::mpi
