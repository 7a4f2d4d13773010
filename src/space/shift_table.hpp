// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The shifts through which particles may meet: all that take the box near itself, numbered. An Image is such a number.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/domain.hpp"
#include "src/space/fixed_point.hpp"

#include <cstdint>

namespace hg {

class ShiftTable {
 public:
  explicit ShiftTable(Memory &memory) : shift_(memory), quanta_(memory) {}

  // All by which a place in the box comes within `reach` of the box, on every axis. Ascending by c, then b, then a, so
  // that opposite ones stand opposite of each other: what comes after the middle is forward.
  void list(const Domain &domain, const FixedPoint &map, double reach);
  // The same shifts in another cell.
  void set_cell(const Domain &domain, const FixedPoint &map);

  Image count() const { return count_; }
  Image middle() const { return count_ / 2; }  // none at all
  Shift operator[](Image image) const { return image == kNoImage ? Shift{} : shift_[image]; }
  // In whole quanta, as places or added to coordinates.
  double quanta(Image image, int axis) const { return quanta_[image].place[axis]; }
  int32_t coordinate(Image image, int axis) const { return quanta_[image].coordinate[axis]; }

  // All steps by -1, 0 or 1 in a cell of right angles: an Image is that of make_image.
  bool steps_by_one() const { return steps_by_one_; }

 private:
  struct Quanta {
    double place[3];
    int32_t coordinate[3];
  };

  void list_steps();
  void list_near(const Domain &domain, double reach);

  Buffer<Shift> shift_;
  Buffer<Quanta> quanta_;
  Image count_ = 0;
  bool steps_by_one_ = false;
};

// How many shifts a table would have at most, for a reach.
double most_shifts(const Domain &domain, double reach);
// False if they are too many, or if so many edges cancel in one that its rounding would tell.
bool may_list(const Domain &domain, double reach);

}  // namespace hg
