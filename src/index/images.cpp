// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/images.hpp"

#include "src/kernels/kernel_set.hpp"

#include <algorithm>
#include <utility>

namespace hg {
namespace {

constexpr uint32_t kTogether = 256;                               // particles whose images are made together
constexpr size_t kMostFound = size_t{kTogether} * (kImages / 2);  // by steps of -1, 0 or 1, in one direction

// Numbers of shifts.
struct ImageRange {
  Image begin, end;
};

// Of the particles of a level and of all that they search.
float largest_radius_met(const Index &index, int h) {
  float largest = index.levels[h].cells.largest_radius;
  for (int k = 0; k < index.level_count; k++) {
    if (index.searches(h, k)) largest = std::max(largest, index.levels[k].cells.largest_radius);
  }
  return largest;
}

class ImageBuilder {
 public:
  explicit ImageBuilder(Index &index)
      : index_(index),
        shifts_(index.shifts),
        dimension_(index.domain.dimension),
        find_images_(active_kernels().find_images[dimension_ - 2]) {
    for (int axis = 0; axis < dimension_; axis++) {
      period_[axis] = index.chunked ? index.map.period_place(axis) : index.map.period[axis];
    }
  }

  uint32_t count() const { return count_; }

  void add_forward(int h) { add(h, {shifts_.middle() + 1, shifts_.count()}); }
  void add_backward(int h) { add(h, {0, shifts_.middle()}); }

 private:
  void add(int h, const ImageRange &wanted) {
    if (index_.chunked) {
      add_by_chunks(h, wanted);
    } else if (shifts_.steps_by_one()) {
      add_by_steps(h, wanted.begin == 0 ? kBackwardImages : kForwardImages);
    } else {
      add_by_points(h, wanted);
    }
  }

  // The largest reach of a particle towards the levels that it searches, and what the search allows for.
  float reach_of(int h) const { return 2 * largest_radius_met(index_, h) * kSearchScale + kSearchSlack; }

  // Images of the particles of a level, in the order of the particles.
  void add_by_steps(int h, ImageSet wanted) {
    const IndexLevel &level = index_.levels[h];
    const PointStore &from = index_.particles;
    const int32_t *period = index_.map.period;
    const bool *periodic = index_.domain.periodic;
    const ImageInput input{{from.x.data(), from.y.data(), from.z.data()},
                           {periodic[0], periodic[1], periodic[2]},
                           {period[0], period[1], period[2]},
                           reach_of(h),
                           wanted};
    for (uint32_t begin = level.begin; begin < level.end;) {
      const uint32_t end = begin + std::min(kTogether, level.end - begin);
      append(find_images_(input, begin, end, found_));
      begin = end;
    }
  }

  // The same in any other cell.
  void add_by_points(int h, const ImageRange &wanted) {
    const IndexLevel &level = index_.levels[h];
    const double reach = static_cast<double>(reach_of(h));
    size_t found = 0;
    for (uint32_t i = level.begin; i < level.end; i++) {
      double place[3] = {0, 0, 0};
      for (int axis = 0; axis < dimension_; axis++) place[axis] = index_.particles.column(axis)[i];
      if (!is_near_face(place, place, reach)) continue;
      for (Image image = wanted.begin; image < wanted.end; image++) {
        if (!comes_near(place, place, image, reach)) continue;
        found_[found++] = {i, image};
        if (found == kMostFound) append(std::exchange(found, 0));
      }
    }
    append(found);
  }

  // Chunk by chunk, most of which are far from all faces and not looked into; in each, shift by shift, so that images
  // which lie together search together.
  void add_by_chunks(int h, const ImageRange &wanted) {
    const ChunkRows &chunks = index_.chunks;
    const ChunkLevel &level = chunks.level(h);
    const double largest = static_cast<double>(largest_radius_met(index_, h));
    const double reach = 2 * largest + 2 * level.slack + kFarSlack;
    chunks.visit_box(level, level.space, [&](size_t chunk, const double *corner) {
      const double end[3] = {corner[0] + level.chunk_length(), corner[1] + level.row_width,
                             corner[2] + level.row_width};
      if (!is_near_face(corner, end, reach)) return true;
      for (Image image = wanted.begin; image < wanted.end; image++) {
        if (comes_near(corner, end, image, reach)) add_chunk(chunk, corner, image, reach);
      }
      return true;
    });
  }

  void add_chunk(size_t chunk, const double *corner, Image image, double reach) {
    const PointArrays points = index_.particles.arrays(false);
    size_t found = 0;
    for (uint32_t i = index_.chunks.chunk_begin(chunk); i < index_.chunks.chunk_end(chunk); i++) {
      double place[3];
      index_.chunks.find_place(points, i, chunk, corner, dimension_, place);
      if (!comes_near(place, place, image, reach)) continue;
      for (int axis = 0; axis < dimension_; axis++) {
        index_.image_place[axis].grow(count_ + found + 1);
        index_.image_place[axis][count_ + found] = place[axis] + shifts_.quanta(image, axis);
      }
      found_[found++] = {i, image};
      if (found == kMostFound) append(std::exchange(found, 0));
    }
    append(found);
  }

  // May what lies between two places come near the box by any shift? From inside, none leads there.
  bool is_near_face(const double *low, const double *high, double reach) const {
    for (int axis = 0; axis < dimension_; axis++) {
      if (index_.domain.periodic[axis] && (low[axis] <= reach || high[axis] + reach >= period_[axis])) return true;
    }
    return false;
  }

  bool comes_near(const double *low, const double *high, Image image, double reach) const {
    for (int axis = 0; axis < 3; axis++) {
      if (index_.domain.periodic[axis]) {
        const double moved = shifts_.quanta(image, axis);
        if (high[axis] + moved + reach < 0 || low[axis] + moved - reach > period_[axis]) return false;
      } else if (shifts_[image].n[axis] != 0) {
        return false;
      }
    }
    return true;
  }

  void append(size_t found) {
    if (found == 0) return;
    const PointStore &from = index_.particles;
    PointStore &to = index_.images;
    for (int axis = 0; axis < dimension_; axis++) {
      const int32_t *x = from.column(axis).data();
      fill(to.column(axis), found,
           [&](PointImage image) { return moved_by(x[image.point], 1, shifts_.coordinate(image.image, axis)); });
    }
    fill(to.radius, found, [&](PointImage image) { return from.radius[image.point]; });
    fill(to.slot, found, [&](PointImage image) { return from.slot[image.point]; });
    fill(to.image, found, [](PointImage image) { return image.image; });
    if (from.with_bodies) fill(to.body, found, [&](PointImage image) { return from.body[image.point]; });
    count_ += static_cast<uint32_t>(found);
  }

  template <class T, class Value>
  void fill(Buffer<T> &column, size_t found, Value value) {
    column.grow(count_ + found + kPadding);
    T *to = column.data() + count_;
    for (size_t k = 0; k < found; k++) to[k] = value(found_[k]);
  }

  Index &index_;
  const ShiftTable &shifts_;
  int dimension_;
  ImageKernel *find_images_;
  uint32_t count_ = 0;
  double period_[3] = {0, 0, 0};
  PointImage found_[kMostFound];
};

}  // namespace

void build_images(Index &index) {
  // One particle alone meets nothing but itself.
  const bool alone = index.levels[index.level_count - 1].end == 1 && !index.domain.all_images;
  if (!index.domain.any_periodic || alone) return;
  index.shifts.list(index.domain, index.map, index.largest_reach());
  ImageBuilder images(index);
  for (int h = 0; h < index.level_count; h++) {
    IndexLevel &level = index.levels[h];
    bool others = false;
    for (int k = 0; k < index.level_count; k++) others = others || (k != h && index.searches(h, k));
    level.image_begin = images.count();
    if (others || index.searches(h, h)) images.add_forward(h);
    level.image_forward_end = images.count();
    // Backward ones are for other levels only.
    if (others) images.add_backward(h);
    level.image_end = images.count();
  }
}

}  // namespace hg
