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

// `of`: which of several, in texts.
void check_sphere(const Domain &domain, const Ball &sphere, const char *of = "") {
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double x = sphere.center[axis];
    if (!std::isfinite(x)) fail(HG_ERR_ARGUMENT, "center%s[%d] = %g is not finite", of, axis, x);
  }
  const Domain::Outside outside = domain.outside(sphere.center);
  if (!(outside.boxes <= domain.most_outside())) {
    fail(HG_ERR_ARGUMENT, "center%s[%d] = %g: more than 2^%d box lengths outside the periodic box", of, outside.axis,
         sphere.center[outside.axis], std::ilogb(domain.most_outside()));
  }
  if (!std::isfinite(sphere.radius) || is_negative(sphere.radius)) {
    fail(HG_ERR_ARGUMENT, "radius%s = %g is not finite and >= 0", of, sphere.radius);
  }
}

// How far from a sphere images must be looked for, on one axis: as far as it reaches, but of any particle the nearest
// image is enough. In a box of right angles that is within half a length on each axis, in a tilted one within half the
// diagonal.
double farthest_image(const Domain &domain, int axis, double reach) {
  if (!domain.periodic[axis]) return reach;
  const double diagonal = std::hypot(domain.period(0), domain.period(1), domain.period(2));
  const double nearest = 0.5 * (domain.is_tilted() ? diagonal : domain.length[axis]) * (1 + 0x1p-20);
  return std::min(reach, nearest);
}

// In a very thin cell.
void check_reach(const Domain &domain, double reach) {
  if (!domain.is_tilted() ||
      may_list(domain, std::min(reach, domain.length[0] + domain.length[1] + domain.length[2]))) {
    return;
  }
  fail(HG_ERR_LIMIT, "a reach of %g goes across too many periodic cells", reach);
}

class SphereSearch {
 public:
  SphereSearch(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids)
      : grid_(grid),
        index_(grid.index),
        sphere_(sphere),
        ids_(ids),
        boxes_(index_.domain.take_in(sphere.center, place_)) {}

  size_t run() {
    for (int h = 0; h < index_.level_count; h++) {
      if (!index_.levels[h].is_empty()) search_level(h);
    }
    std::sort(ids_.data(), ids_.data() + count_);
    // A sphere wider than half the box can meet a particle through several images.
    if (index_.domain.any_periodic) {
      count_ = static_cast<size_t>(std::unique(ids_.data(), ids_.data() + count_) - ids_.data());
    }
    return count_;
  }

 private:
  void search_level(int h) {
    const Domain &domain = index_.domain;
    const double reach = index_.interaction.reach(sphere_.radius, index_.levels[h].largest_radius);
    // Stored candidates may have left their places by the skin.
    const double skin = index_.interaction.margin - grid_.overlap.interaction().margin;
    check_reach(domain, reach);
    PlaceBox to;
    for (int axis = 0; axis < domain.dimension; axis++) {
      const double around = farthest_image(domain, axis, reach * (1 + 0x1p-40)) + skin + place_slack(domain, axis);
      to.low[axis] = -around;
      to.high[axis] = index_.map.extent[axis] / index_.map.scale + around;
    }
    visit_shifts(domain, PlaceBox::at(place_, domain.dimension), to,
                 [&](const Shift &shift) { search(h, search_box(domain, place_, shift, reach), shift); });
  }

  void search(int h, const PlaceBox &box, const Shift &shift) {
    if (index_.chunked) {
      search_chunks(index_.chunks.level(h), box, shift);
    } else {
      search_cells(index_.levels[h].cells, box, shift);
    }
  }

  void search_chunks(const ChunkLevel &level, const PlaceBox &box, const Shift &shift) {
    PlaceBox places;
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      places.low[axis] = place(axis, box.low[axis]);
      places.high[axis] = place(axis, box.high[axis]);
    }
    index_.chunks.visit_box(level, places, [&](size_t chunk, const double *) {
      test(index_.chunks.chunk_begin(chunk), index_.chunks.chunk_end(chunk), shift);
      return true;
    });
  }

  double place(int axis, double x) const {
    return index_.map.quanta(axis, index_.is_squeezed(axis) ? index_.squeezed.position(axis, x) : x);
  }

  // Eqs. 4 and 5, row by row.
  void search_cells(const CellTable &cells, const PlaceBox &box, const Shift &shift) {
    int32_t first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      first[axis] = outer_cell(cells, axis, box.low[axis], -1.0);
      last[axis] = outer_cell(cells, axis, box.high[axis], 1.0);
    }
    for (int32_t z = first[2]; z <= last[2]; z++) {
      for (int32_t y = first[1]; y <= last[1]; y++) {
        const size_t row = static_cast<size_t>(z) * static_cast<size_t>(cells.count[1]) + static_cast<size_t>(y);
        const uint32_t *cell = cells.cell_begin + row * static_cast<size_t>(cells.count[0]);
        test(cell[first[0]], cell[last[0] + 1], shift);
      }
    }
  }

  // The cell of an end of the box, which may lie far outside; `side` says which way it may move.
  int32_t outer_cell(const CellTable &cells, int axis, double x, double side) const {
    const double quanta = index_.map.quanta(axis, x) + side * static_cast<double>(kSearchSlack);
    const auto within = static_cast<float>(std::clamp(quanta, -1.0, kFixedPointQuanta));
    return cell_of<ScalarLanes>(within, cells.inverse_width[axis], last_of(cells, axis));
  }

  void test(uint32_t begin, uint32_t end, const Shift &shift) {
    int64_t exact = 0;
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t slot = index_.particles.slot[j];
      if (!grid_.overlap.holds(sphere_, grid_.store.ball(slot), shift + boxes_of(j, slot) - boxes_, exact)) continue;
      ids_.grow(count_ + 1);
      ids_[count_++] = grid_.store.id(slot);
    }
  }

  Shift boxes_of(uint32_t particle, uint32_t slot) const {
    return grid_.candidates.moved() ? grid_.candidates.boxes(particle, grid_.store)
                                    : index_.domain.boxes(grid_.store.center(slot));
  }

  const BuiltGrid &grid_;
  const Index &index_;
  const Ball &sphere_;
  Buffer<int32_t> &ids_;
  double place_[3] = {0, 0, 0};
  Shift boxes_;  // that were taken off the centre
  size_t count_ = 0;
};

}  // namespace

bool overlaps(const Domain &domain, const Overlap &overlap, const Ball &a, const Ball &b) {
  check_sphere(domain, a, "_a");
  check_sphere(domain, b, "_b");
  double place_a[3] = {0, 0, 0}, place_b[3] = {0, 0, 0};
  const Shift boxes = domain.take_in(b.center, place_b) - domain.take_in(a.center, place_a);
  const double reach = overlap.interaction().reach(a.radius, b.radius) * (1 + 0x1p-40);
  check_reach(domain, reach);
  PlaceBox to;
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double around = farthest_image(domain, axis, reach) + place_slack(domain, axis);
    to.low[axis] = place_b[axis] - around;
    to.high[axis] = place_b[axis] + around;
  }
  bool found = false;
  int64_t exact = 0;
  visit_shifts(domain, PlaceBox::at(place_a, domain.dimension), to,
               [&](const Shift &shift) { found = found || overlap.holds(a, b, shift + boxes, exact); });
  return found;
}

size_t query_sphere(const BuiltGrid &grid, const Ball &sphere, Buffer<int32_t> &ids) {
  check_sphere(grid.index.domain, sphere);
  return SphereSearch(grid, sphere, ids).run();
}

}  // namespace hg
