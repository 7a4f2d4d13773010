// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/images.hpp"

#include "src/kernels/kernel_set.hpp"

#include <algorithm>

namespace hg {
namespace {

constexpr uint32_t kTogether = 256;  // particles whose images are made together
constexpr size_t kMostImages = 13;   // of a particle, in one direction

class ImageBuilder {
 public:
  explicit ImageBuilder(Index &index)
      : index_(index), dimension_(index.domain.dimension), find_images_(active_kernels().find_images[dimension_ - 2]) {
    for (int axis = 0; axis < dimension_; axis++) period_place_[axis] = index.map.period_place(axis);
    for (Image image = 0; image < kImages; image++) {
      for (int axis = 0; axis < 3; axis++) {
        shift_[axis][image] = moved_by(0, image_step(image, axis), index.map.period[axis]);
      }
    }
  }

  uint32_t count() const { return count_; }

  void add(int h, ImageSet wanted) {
    if (index_.chunked) {
      add_by_chunks(h, wanted);
    } else {
      add_by_points(index_.levels[h], wanted);
    }
  }

 private:
  // Images of the particles of a level, in the order of the particles.
  void add_by_points(const IndexLevel &level, ImageSet wanted) {
    const PointStore &from = index_.particles;
    const int32_t *period = index_.map.period;
    // The largest reach of a particle towards its own and finer levels.
    const float reach = 2 * level.cells.largest_radius * kSearchScale + kSearchSlack;
    const ImageInput input{
        {from.x.data(), from.y.data(), from.z.data()}, {period[0], period[1], period[2]}, reach, wanted};
    for (uint32_t begin = level.begin; begin < level.end;) {
      const uint32_t end = begin + std::min(kTogether, level.end - begin);
      append(find_images_(input, begin, end, found_));
      begin = end;
    }
  }

  // Chunk by chunk, most of which are far from all faces and not looked into; in each, step by step, so that images
  // which lie together search together.
  void add_by_chunks(int h, ImageSet wanted) {
    const ChunkRows &chunks = index_.chunks;
    const ChunkLevel &level = chunks.level(h);
    const double largest = static_cast<double>(index_.levels[h].cells.largest_radius);
    const double reach = 2 * largest + 2 * level.slack + kFarSlack;
    chunks.visit_box(level, level.space, [&](size_t chunk, const double *corner) {
      const double end[3] = {corner[0] + level.chunk_length(), corner[1] + level.row_width,
                             corner[2] + level.row_width};
      const ImageSet some = wanted & images_near_box(corner, end, reach);
      for (ImageSet left = some; left != 0; left &= left - 1) {
        add_chunk(chunk, corner, static_cast<Image>(__builtin_ctz(static_cast<uint32_t>(left))), reach);
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
      if ((images_near_box(place, place, reach) >> image & 1) == 0) continue;
      for (int axis = 0; axis < dimension_; axis++) {
        index_.image_place[axis].grow(count_ + found + 1);
        index_.image_place[axis][count_ + found] = place[axis] + image_step(image, axis) * period_place_[axis];
      }
      found_[found++] = {i, image};
      if (found < kTogether) continue;
      append(found);
      found = 0;
    }
    append(found);
  }

  // By which steps may what lies between two places come near the box? As the kernel asks of points.
  ImageSet images_near_box(const double *low, const double *high, double reach) const {
    ImageSet images = kForwardImages | kBackwardImages;
    for (int axis = 0; axis < 3; axis++) {
      const ImageSet *step = kImagesWithStep[axis];
      const bool periodic = index_.domain.periodic[axis];
      const bool down = periodic && high[axis] + reach >= period_place_[axis], up = periodic && low[axis] <= reach;
      images &= step[1] | (down ? step[0] : 0) | (up ? step[2] : 0);
    }
    return images;
  }

  void append(size_t found) {
    if (found == 0) return;
    const PointStore &from = index_.particles;
    PointStore &to = index_.images;
    for (int axis = 0; axis < dimension_; axis++) {
      const int32_t *x = from.column(axis).data(), *shift = shift_[axis];
      fill(to.column(axis), found, [&](PointImage image) { return moved_by(x[image.point], 1, shift[image.image]); });
    }
    fill(to.radius, found, [&](PointImage image) { return from.radius[image.point]; });
    fill(to.slot, found, [&](PointImage image) { return from.slot[image.point]; });
    fill(to.image, found, [](PointImage image) { return image.image; });
    count_ += static_cast<uint32_t>(found);
  }

  template <class T, class Value>
  void fill(Buffer<T> &column, size_t found, Value value) {
    column.grow(count_ + found + kPadding);
    T *to = column.data() + count_;
    for (size_t k = 0; k < found; k++) to[k] = value(found_[k]);
  }

  Index &index_;
  int dimension_;
  ImageKernel *find_images_;
  uint32_t count_ = 0;
  int32_t shift_[3][kImages];
  double period_place_[3] = {0, 0, 0};
  PointImage found_[kTogether * kMostImages];
};

}  // namespace

void build_images(Index &index) {
  if (!index.domain.any_periodic) return;
  ImageBuilder images(index);
  bool some_finer = false;
  for (int h = 0; h < index.level_count; h++) {
    IndexLevel &level = index.levels[h];
    level.image_begin = images.count();
    images.add(h, kForwardImages);
    level.image_forward_end = images.count();
    // Backward ones are for finer levels only.
    if (some_finer) images.add(h, kBackwardImages);
    level.image_end = images.count();
    some_finer = some_finer || !level.is_empty();
  }
}

}  // namespace hg
