// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The edges of a periodic cell, in the numbers that a rule computes with.
#pragma once

#include "oracle/rule.hpp"

namespace oracle {

// Column e is the edge a, b or c: (lx, 0, 0), (xy, ly, 0), (xz, yz, lz). That of an open axis is 0.
template <class Number>
struct Cell {
  Number edge[3][3];

  explicit Cell(const hg_grid_def &def)
      : edge{{length(def, 0), Number(def.tilt[0]), Number(def.tilt[1])},
             {Number(0), length(def, 1), Number(def.tilt[2])},
             {Number(0), Number(0), length(def, 2)}} {}

 private:
  static Number length(const hg_grid_def &def, int axis) {
    const bool open = axis >= def.dimension || def.periodic[axis] == 0;
    return open ? Number(0) : Number(Number(def.box_max[axis]) - Number(def.box_min[axis]));
  }
};

}  // namespace oracle
