// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/box_search.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"
#include "src/exact/box_overlap.hpp"
#include "src/search/level_ranges.hpp"
#include "src/space/search_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Nothing finite lies in it.
bool is_at_infinity(double low, double high) { return low == kInfinity || high == -kInfinity; }

void check_box(const Domain &domain, const AlignedBox &box, size_t k) {
  for (int axis = 0; axis < domain.dimension; axis++) {
    const double low = box.low[axis], high = box.high[axis];
    if (std::isnan(low)) fail(HG_ERR_ARGUMENT, "low[%zu][%d] = %g is no number", k, axis, low);
    if (std::isnan(high)) fail(HG_ERR_ARGUMENT, "high[%zu][%d] = %g is no number", k, axis, high);
    if (order_of(low) > order_of(high)) {
      fail(HG_ERR_ARGUMENT, "low[%zu][%d] = %.17g is above high[%zu][%d] = %.17g", k, axis, low, k, axis, high);
    }
    if (!domain.periodic[axis] || box.covers(domain, axis) || is_at_infinity(low, high)) continue;
    if (std::fabs(boxes_above(low - domain.box_min[axis], domain.length[axis])) > kMaxWraps) {
      fail(HG_ERR_ARGUMENT, "low[%zu][%d] = %g: more than 2^%d box lengths outside the periodic box", k, axis, low,
           std::ilogb(kMaxWraps));
    }
  }
}

// Ends of a box on one axis as places, and its images there that may meet particles: numbers of box lengths.
struct AxisRange {
  double low, high;
  EdgeRange images{0, 0};
};

class ManyBoxes final : public RowSource {
 public:
  ManyBoxes(const BuiltGrid &grid, size_t count, const double *low, const double *high)
      : grid_(grid),
        index_(grid.index),
        domain_(grid.index.domain),
        overlap_(grid.overlap.interaction(), grid.overlap.domain()),
        dimension_(static_cast<size_t>(domain_.dimension)),
        count_(count),
        low_(low),
        high_(high) {
    if (domain_.is_tilted()) fail(HG_ERR_STATE, "boxes are not looked for in a tilted cell");
    for (size_t k = 0; k < count; k++) check_box(domain_, box(k), k);
  }

  size_t count() const override { return count_; }
  void find_center(size_t k, double *center) const override {
    for (size_t axis = 0; axis < dimension_; axis++) center[axis] = 0.5 * box(k).low[axis] + 0.5 * box(k).high[axis];
  }
  size_t find(size_t k, Buffer<int32_t> &ids, size_t count) const override {
    const AlignedBox wanted = box(k);
    for (size_t axis = 0; axis < dimension_; axis++) {
      if (is_at_infinity(wanted.low[axis], wanted.high[axis])) return count;
    }
    bool may_repeat = false;
    size_t found = count;
    for (int h = 0; h < index_.level_count; h++) {
      if (!index_.levels[h].is_empty()) found = search_level(h, wanted, ids, found, may_repeat);
    }
    return ascend_row(ids, count, found, may_repeat);
  }

 private:
  AlignedBox box(size_t k) const { return {low_ + k * dimension_, high_ + k * dimension_}; }

  size_t search_level(int h, const AlignedBox &box, Buffer<int32_t> &ids, size_t count, bool &may_repeat) const {
    const double reach = (index_.levels[h].largest_radius + index_.interaction.margin) * (1 + 0x1p-40);
    AxisRange range[3] = {};
    for (int axis = 0; axis < domain_.dimension; axis++) {
      range[axis] = range_of(box, axis, reach);
      if (!(range[axis].low <= range[axis].high)) return count;
    }
    const auto images = [&](int axis, auto &&next) {
      for (double n = range[axis].images.first; n <= range[axis].images.last; n++) next(n * domain_.length[axis]);
    };
    int visits = 0;
    images(2, [&](double z) {
      images(1, [&](double y) {
        images(0, [&](double x) {
          const double moved[3] = {x, y, z};
          PlaceBox places;
          for (int axis = 0; axis < domain_.dimension; axis++) {
            places.low[axis] = range[axis].low + moved[axis];
            places.high[axis] = range[axis].high + moved[axis];
          }
          may_repeat = may_repeat || visits++ > 0;
          visit_ranges(index_, h, places,
                       [&](uint32_t begin, uint32_t end) { count = test(box, begin, end, ids, count); });
        });
      });
    });
    return count;
  }

  // Enlarged by the reach. On an open axis the box need not be wider than all particles; on a periodic one it need not
  // reach farther than to the nearest image of each, but for particles that have moved within the skin since the index
  // was built.
  AxisRange range_of(const AlignedBox &box, int axis, double reach) const {
    if (!domain_.periodic[axis]) {
      const Interval &all = grid_.store.summary().center[axis];
      return {std::max(box.low[axis], all.least) - reach, std::min(box.high[axis], all.greatest) + reach};
    }
    const double length = domain_.length[axis], extent = index_.map.extent[axis] / index_.map.scale;
    if (box.covers(domain_, axis)) return {-reach, extent + reach};
    const double skin = index_.interaction.margin - grid_.overlap.interaction().margin;
    const double around = std::min(reach, 0.5 * length * (1 + 0x1p-20)) + skin + place_slack(domain_, axis);
    const double above = box.low[axis] - domain_.box_min[axis], low = above - boxes_above(above, length) * length;
    AxisRange range{low - around, low + (box.high[axis] - box.low[axis]) + around};
    range.images = EdgeRange::within(-range.high, extent - range.low, length);
    return range;
  }

  size_t test(const AlignedBox &box, uint32_t begin, uint32_t end, Buffer<int32_t> &ids, size_t count) const {
    ids.grow(count + (end - begin));
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t slot = index_.particles.slot[j];
      if (overlap_.holds(box, grid_.store.ball(slot))) ids[count++] = grid_.store.id(slot);
    }
    return count;
  }

  const BuiltGrid &grid_;
  const Index &index_;
  const Domain &domain_;
  BoxOverlap overlap_;
  size_t dimension_, count_;
  const double *low_, *high_;
};

}  // namespace

void query_boxes(const BuiltGrid &grid, size_t count, const double *low, const double *high, QueryRows &rows) {
  rows.find(grid, ManyBoxes(grid, count, low, high));
}

}  // namespace hg
