// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/box_search.hpp"

#include "src/base/error.hpp"
#include "src/base/ordered_bits.hpp"
#include "src/exact/box_overlap.hpp"
#include "src/search/near_box.hpp"

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

class ManyBoxes final : public RowSource {
 public:
  ManyBoxes(const BuiltGrid &grid, size_t count, const double *low, const double *high)
      : grid_(grid),
        index_(grid.index),
        domain_(grid.index.domain),
        near_(grid),
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
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int axis = 0; axis < domain_.dimension; axis++) {
      if (is_at_infinity(wanted.low[axis], wanted.high[axis])) return count;
      low[axis] = wanted.low[axis];
      high[axis] = wanted.high[axis];
      if (wanted.covers(domain_, axis)) low[axis] = -kInfinity;
    }
    bool may_repeat = false;
    size_t found = count;
    for (int h = 0; h < index_.level_count; h++) {
      if (index_.levels[h].is_empty()) continue;
      const double reach = index_.levels[h].largest_radius + index_.interaction.margin;
      const int images = near_.visit(h, {low, high}, reach, [&](uint32_t begin, uint32_t end, const Shift &) {
        found = test(wanted, begin, end, ids, found);
      });
      may_repeat = may_repeat || images > 1;
    }
    return ascend_row(ids, count, found, may_repeat);
  }

 private:
  AlignedBox box(size_t k) const { return {low_ + k * dimension_, high_ + k * dimension_}; }

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
  NearBox near_;
  BoxOverlap overlap_;
  size_t dimension_, count_;
  const double *low_, *high_;
};

}  // namespace

void query_boxes(const BuiltGrid &grid, size_t count, const double *low, const double *high, QueryRows &rows) {
  rows.find(grid, ManyBoxes(grid, count, low, high));
}

}  // namespace hg
