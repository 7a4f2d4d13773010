// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Which of the sorted particles of a level may be near an aligned box or one of its periodic images, in a cell that is
// not tilted: the nearest image of a particle to any point of the box, which is no more than half a length away on each
// axis.
#pragma once

#include "src/exact/box_overlap.hpp"
#include "src/search/built_grid.hpp"
#include "src/search/level_ranges.hpp"
#include "src/space/search_box.hpp"

#include <algorithm>
#include <cmath>

namespace hg {

class NearBox {
 public:
  explicit NearBox(const BuiltGrid &grid) : grid_(grid) {}

  // Calls visit(begin, end, moved) with the image of the box in whole lengths: for all particles that are no farther
  // from it than `reach`, on each axis, and for others. An infinite end on a periodic axis stands for all of it.
  // Returns how many images there were.
  template <class Visit>
  int visit(int level, const AlignedBox &box, double reach, Visit &&visit) const {
    const Domain &domain = grid_.index.domain;
    Range range[3] = {};
    for (int axis = 0; axis < 3; axis++) {
      if (axis < domain.dimension) range[axis] = range_of(box, axis, reach * (1 + 0x1p-40));
      if (!(range[axis].low <= range[axis].high)) return 0;
    }
    int images = 0;
    Shift moved;
    const auto along = [&](int axis, auto &&next) {
      const auto count = static_cast<int64_t>(range[axis].images.count());
      for (int64_t k = 0; k < count; k++) {
        const double n = range[axis].images.first + static_cast<double>(k);
        moved.n[axis] = static_cast<int32_t>(n - range[axis].taken);
        range[axis].shift = n * domain.length[axis];
        next();
      }
    };
    along(2, [&] {
      along(1, [&] {
        along(0, [&] {
          PlaceBox places;
          for (int axis = 0; axis < domain.dimension; axis++) {
            places.low[axis] = range[axis].low + range[axis].shift;
            places.high[axis] = range[axis].high + range[axis].shift;
          }
          images++;
          visit_ranges(grid_.index, level, places, [&](uint32_t begin, uint32_t end) { visit(begin, end, moved); });
        });
      });
    });
    return images;
  }

 private:
  // The box on one axis, as places and enlarged: in which images it may meet particles, what was taken off, and where
  // the present image is.
  struct Range {
    double low, high;
    EdgeRange images{0, 0};
    double taken = 0, shift = 0;
  };

  Range range_of(const AlignedBox &box, int axis, double reach) const {
    const Index &index = grid_.index;
    const Domain &domain = index.domain;
    if (!domain.periodic[axis]) {
      // Not wider than all particles.
      const Interval &all = grid_.store.summary().center[axis];
      return {std::max(box.low[axis], all.least) - reach, std::min(box.high[axis], all.greatest) + reach};
    }
    const double length = domain.length[axis], extent = index.map.extent[axis] / index.map.scale;
    if (!std::isfinite(box.low[axis]) || !std::isfinite(box.high[axis])) return {-reach, extent + reach};
    // Particles may have moved within the skin since the index was built.
    const double skin = index.interaction.margin - grid_.overlap.interaction().margin;
    const double around = std::min(reach, 0.5 * length * (1 + 0x1p-20)) + skin + place_slack(domain, axis);
    const double above = box.low[axis] - domain.box_min[axis], taken = boxes_above(above, length);
    const double low = above - taken * length;
    Range range{low - around, low + (box.high[axis] - box.low[axis]) + around};
    range.images = EdgeRange::within(-range.high, extent - range.low, length);
    range.taken = taken;
    return range;
  }

  const BuiltGrid &grid_;
};

}  // namespace hg
