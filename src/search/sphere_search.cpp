// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/sphere_search.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"
#include "src/kernels/lanes_scalar.hpp"
#include "src/space/search_box.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

void check_sphere(const Domain &domain, const Ball &sphere) {
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double x = sphere.center[axis];
    if (!std::isfinite(x)) fail(HG_ERR_ARGUMENT, "center[%d] = %g is not finite", axis, x);
    if (!(std::fabs(domain.wraps(axis, x)) <= kMaxWraps)) {
      fail(HG_ERR_ARGUMENT, "center[%d] = %g: more than 2^20 box lengths outside the periodic box", axis, x);
    }
  }
  if (!std::isfinite(sphere.radius) || is_negative(sphere.radius)) {
    fail(HG_ERR_ARGUMENT, "radius = %g is not finite and >= 0", sphere.radius);
  }
}

class SphereSearch {
 public:
  SphereSearch(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids)
      : grid_(grid), index_(grid.index), sphere_(sphere), ids_(ids) {}

  size_t run() {
    for (int h = 0; h < index_.level_count; h++) {
      const IndexLevel &level = index_.levels[h];
      if (level.is_empty()) continue;
      for (Image image = 0; image < kImages; image++) {
        if (is_possible(image)) search(h, image);
      }
    }
    std::sort(ids_.data(), ids_.data() + count_);
    // A sphere wider than half the box can meet a particle through several images.
    if (index_.domain.any_periodic) {
      count_ = static_cast<size_t>(std::unique(ids_.data(), ids_.data() + count_) - ids_.data());
    }
    return count_;
  }

 private:
  bool is_possible(Image image) const {
    for (int axis = 0; axis < 3; axis++) {
      if (image_step(image, axis) != 0 && !index_.domain.periodic[axis]) return false;
    }
    return true;
  }

  void search(int h, Image image) {
    const IndexLevel &level = index_.levels[h];
    const double reach = index_.interaction.reach(sphere_.radius, level.largest_radius);
    const SearchBox box = SearchBox::around(index_.domain, sphere_.center, image, reach);
    if (box.misses(index_.domain)) return;
    if (index_.chunked) {
      search_chunks(index_.chunks.level(h), box, image);
    } else {
      search_cells(level.cells, box, image);
    }
  }

  void search_chunks(const ChunkLevel &level, const SearchBox &box, Image image) {
    PlaceBox places;
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      places.low[axis] = place(axis, box.low[axis]);
      places.high[axis] = place(axis, box.high[axis]);
    }
    index_.chunks.visit_box(level, places, [&](size_t chunk, const double *) {
      test(index_.chunks.chunk_begin(chunk), index_.chunks.chunk_end(chunk), image);
      return true;
    });
  }

  double place(int axis, double x) const {
    const bool squeezed = index_.squeezed.in_use() && !index_.domain.periodic[axis];
    return index_.map.quanta(axis, squeezed ? index_.squeezed.position(axis, x) : x);
  }

  // Eqs. 4 and 5, row by row.
  void search_cells(const CellTable &cells, const SearchBox &box, Image image) {
    int32_t first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      first[axis] = outer_cell(cells, axis, box.low[axis], -1.0);
      last[axis] = outer_cell(cells, axis, box.high[axis], 1.0);
    }
    for (int32_t z = first[2]; z <= last[2]; z++) {
      for (int32_t y = first[1]; y <= last[1]; y++) {
        const size_t row = static_cast<size_t>(z) * static_cast<size_t>(cells.count[1]) + static_cast<size_t>(y);
        const uint32_t *cell = cells.cell_begin + row * static_cast<size_t>(cells.count[0]);
        test(cell[first[0]], cell[last[0] + 1], image);
      }
    }
  }

  // The cell of an end of the box, which may lie far outside; `side` says which way it may move.
  int32_t outer_cell(const CellTable &cells, int axis, double x, double side) const {
    const double quanta = index_.map.quanta(axis, x) + side * static_cast<double>(kSearchSlack);
    const auto within = static_cast<float>(std::clamp(quanta, -1.0, kFixedPointQuanta));
    return cell_of<ScalarLanes>(within, cells.inverse_width[axis], last_of(cells, axis));
  }

  void test(uint32_t begin, uint32_t end, Image image) {
    int64_t exact = 0;
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t slot = index_.particles.slot[j];
      Image seen = image;
      if (grid_.candidates.moved() && !grid_.candidates.see(j, seen, grid_.store)) continue;
      if (!grid_.overlap.holds(sphere_, grid_.store.ball(slot), seen, exact)) continue;
      ids_.grow(count_ + 1);
      ids_[count_++] = grid_.store.id(slot);
    }
  }

  const BuiltGrid &grid_;
  const Index &index_;
  const Ball &sphere_;
  Buffer<int32_t> &ids_;
  size_t count_ = 0;
};

}  // namespace

size_t query_sphere(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids) {
  check_sphere(grid.index.domain, sphere);
  return SphereSearch(grid, sphere, ids).run();
}

}  // namespace hg
