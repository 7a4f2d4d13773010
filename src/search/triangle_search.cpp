// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/triangle_search.hpp"

#include "src/base/error.hpp"
#include "src/exact/triangle_distance.hpp"
#include "src/search/near_box.hpp"

#include <algorithm>
#include <cmath>

namespace hg {
namespace {

constexpr double kMostImages = 0x1p20;
// Added to a reach, relative to it and to the largest coordinate: more than distances are off.
constexpr double kTolerance = 0x1p-42;

struct Corners {
  double x[3][3];

  static Corners at(const double *values) {
    Corners corners;
    std::copy_n(values, 9, &corners.x[0][0]);
    return corners;
  }
  double low(int axis) const { return std::min(std::min(x[0][axis], x[1][axis]), x[2][axis]); }
  double high(int axis) const { return std::max(std::max(x[0][axis], x[1][axis]), x[2][axis]); }
  double edge(int k) const {
    const double *a = x[k], *b = x[(k + 1) % 3];
    return std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
  }
  // Cut across the middle of edge k.
  Corners half(int k, int side) const {
    Corners half = *this;
    for (int axis = 0; axis < 3; axis++) {
      half.x[(k + 1 - side) % 3][axis] = 0.5 * x[k][axis] + 0.5 * x[(k + 1) % 3][axis];
    }
    return half;
  }
};

class ManyTriangles final : public RowSource {
 public:
  ManyTriangles(const BuiltGrid &grid, size_t count, const double *corners)
      : grid_(grid), index_(grid.index), domain_(grid.index.domain), near_(grid), count_(count), corners_(corners) {
    if (domain_.dimension != 3) fail(HG_ERR_STATE, "triangles are looked for in three dimensions only");
    if (domain_.is_tilted()) fail(HG_ERR_STATE, "triangles are not looked for in a tilted cell");
    for (size_t k = 0; k < count; k++) check(k);
  }

  size_t count() const override { return count_; }
  void find_center(size_t k, double *center) const override {
    const Corners corners = triangle(k);
    for (int axis = 0; axis < 3; axis++) center[axis] = 0.5 * corners.low(axis) + 0.5 * corners.high(axis);
  }
  size_t find(size_t k, Buffer<int32_t> &ids, size_t count) const override {
    Found found{Triangle(corners_ + 9 * k), ids, count};
    const Corners corners = triangle(k);
    for (int h = 0; h < index_.level_count; h++) {
      if (!index_.levels[h].is_empty()) search(h, corners, kMostCuts, found);
    }
    return ascend_row(ids, count, found.count, true);
  }

 private:
  static constexpr int kMostCuts = 16;

  struct Found {
    Triangle triangle;
    Buffer<int32_t> &ids;
    size_t count;
  };

  Corners triangle(size_t k) const { return Corners::at(corners_ + 9 * k); }

  void check(size_t k) const {
    double images = 1;
    const Corners corners = triangle(k);
    for (int axis = 0; axis < 3; axis++) {
      for (int corner = 0; corner < 3; corner++) {
        const double x = corners.x[corner][axis];
        if (!std::isfinite(x)) fail(HG_ERR_ARGUMENT, "corners[%zu][%d][%d] = %g is not finite", k, corner, axis, x);
        if (std::fabs(domain_.wraps(axis, x)) <= kMaxWraps) continue;
        fail(HG_ERR_ARGUMENT, "corners[%zu][%d][%d] = %g: more than 2^%d box lengths outside the periodic box", k,
             corner, axis, x, std::ilogb(kMaxWraps));
      }
      if (!domain_.periodic[axis]) continue;
      images *= 3 + (corners.high(axis) - corners.low(axis)) / domain_.length[axis];
    }
    if (images > kMostImages) fail(HG_ERR_LIMIT, "corners[%zu]: a triangle across %g periodic cells", k, images);
  }

  // The box around a large triangle is mostly empty: it is cut until boxes fit, with an eye to the cells.
  void search(int h, const Corners &part, int cuts, Found &found) const {
    const double radius = index_.levels[h].largest_radius + index_.interaction.margin;
    const double reach = radius + kTolerance * (radius + found.triangle.size());  // cuts are rounded, too
    double low[3], high[3], edge[3];
    const double around = 2 * reach + row_width(h);
    double box = 1;
    for (int axis = 0; axis < 3; axis++) {
      low[axis] = part.low(axis);
      high[axis] = part.high(axis);
      edge[axis] = part.edge(axis);
      box *= high[axis] - low[axis] + around;
    }
    const auto longest = static_cast<int>(std::max_element(edge, edge + 3) - edge);
    const double rounds = edge[0] + edge[1] + edge[2], needed = around * (around + rounds) * (around + rounds) / 4;
    if (cuts > 0 && box > needed && edge[longest] > around) {
      for (int side = 0; side < 2; side++) search(h, part.half(longest, side), cuts - 1, found);
      return;
    }
    near_.visit(h, {low, high}, reach,
                [&](uint32_t begin, uint32_t end, const Shift &moved) { test(begin, end, moved, found); });
  }

  double row_width(int h) const {
    const double quanta =
        index_.chunked ? index_.chunks.level(h).row_width : static_cast<double>(index_.levels[h].cells.width[1]);
    return quanta / index_.map.scale;
  }

  void test(uint32_t begin, uint32_t end, const Shift &moved, Found &found) const {
    found.ids.grow(found.count + (end - begin));
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t slot = index_.particles.slot[j];
      if (is_near(j, slot, moved, found.triangle)) found.ids[found.count++] = grid_.store.id(slot);
    }
  }

  bool is_near(uint32_t particle, uint32_t slot, const Shift &moved, const Triangle &triangle) const {
    const Ball ball = grid_.store.ball(slot);
    const Shift back = domain_.any_periodic ? grid_.boxes(particle, slot) + moved : moved;
    double center[3], size = triangle.size();
    for (int axis = 0; axis < 3; axis++) {
      center[axis] = ball.center[axis] - back.n[axis] * domain_.length[axis];
      size = std::max(size, std::fabs(ball.center[axis]));
    }
    const double reach = ball.radius + grid_.overlap.interaction().margin;
    return triangle.distance(center) <= reach + kTolerance * (reach + size);
  }

  const BuiltGrid &grid_;
  const Index &index_;
  const Domain &domain_;
  NearBox near_;
  size_t count_;
  const double *corners_;
};

}  // namespace

void query_triangles(const BuiltGrid &grid, size_t count, const double *corners, QueryRows &rows) {
  rows.find(grid, ManyTriangles(grid, count, corners));
}

}  // namespace hg
