// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which of the sorted particles of a level may lie in a box of places: what queries of single places look at.
#pragma once

#include "src/index/index.hpp"
#include "src/kernels/lanes_scalar.hpp"
#include "src/space/shifts.hpp"

#include <algorithm>

namespace hg {

// The cell of an end of the box, which may lie far outside; `side` says which way it may move.
inline int32_t outer_cell(const Index &index, const CellTable &cells, int axis, double x, double side) {
  const double quanta = index.map.quanta(axis, x) + side * static_cast<double>(kSearchSlack);
  const auto within = static_cast<float>(std::clamp(quanta, -1.0, kFixedPointQuanta));
  return cell_of<ScalarLanes>(within, cells.inverse_width[axis], last_of(cells, axis));
}

// Eqs. 4 and 5, row by row.
template <class Visit>
void visit_cells(const Index &index, const CellTable &cells, const PlaceBox &box, Visit &&visit) {
  int32_t first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
  for (int axis = 0; axis < index.domain.dimension; axis++) {
    first[axis] = outer_cell(index, cells, axis, box.low[axis], -1.0);
    last[axis] = outer_cell(index, cells, axis, box.high[axis], 1.0);
  }
  for (int32_t z = first[2]; z <= last[2]; z++) {
    for (int32_t y = first[1]; y <= last[1]; y++) {
      const size_t row = static_cast<size_t>(z) * static_cast<size_t>(cells.count[1]) + static_cast<size_t>(y);
      const uint32_t *cell = cells.cell_begin + row * static_cast<size_t>(cells.count[0]);
      visit(cell[first[0]], cell[last[0] + 1]);
    }
  }
}

template <class Visit>
void visit_chunks(const Index &index, const ChunkLevel &level, const PlaceBox &box, Visit &&visit) {
  const auto place = [&](int axis, double x) {
    return index.map.quanta(axis, index.is_squeezed(axis) ? index.squeezed.position(axis, x) : x);
  };
  PlaceBox places;
  for (int axis = 0; axis < index.domain.dimension; axis++) {
    places.low[axis] = place(axis, box.low[axis]);
    places.high[axis] = place(axis, box.high[axis]);
  }
  index.chunks.visit_box(level, places, [&](size_t chunk, const double *) {
    visit(index.chunks.chunk_begin(chunk), index.chunks.chunk_end(chunk));
    return true;
  });
}

// Calls visit(begin, end) for all particles of the level that lie in the box, and others near it. The box is one of
// positions (Domain::position).
template <class Visit>
void visit_ranges(const Index &index, int level, const PlaceBox &box, Visit &&visit) {
  if (index.levels[level].is_empty()) return;
  if (index.chunked) {
    visit_chunks(index, index.chunks.level(level), box, visit);
  } else {
    visit_cells(index, index.levels[level].cells, box, visit);
  }
}

}  // namespace hg
