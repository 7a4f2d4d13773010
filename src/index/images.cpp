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
    for (Image image = 0; image < kImages; image++) {
      for (int axis = 0; axis < 3; axis++) shift_[axis][image] = image_step(image, axis) * index.map.period[axis];
    }
  }

  uint32_t count() const { return count_; }

  // Images of the particles of a level, in the order of the particles.
  void add(const IndexLevel &level, ImageSet wanted) {
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

 private:
  void append(size_t found) {
    if (found == 0) return;
    const PointStore &from = index_.particles;
    PointStore &to = index_.images;
    for (int axis = 0; axis < dimension_; axis++) {
      const int32_t *x = from.column(axis).data(), *shift = shift_[axis];
      fill(to.column(axis), found, [&](PointImage image) { return x[image.point] + shift[image.image]; });
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
    images.add(level, kForwardImages);
    level.image_forward_end = images.count();
    // Backward ones are for finer levels only.
    if (some_finer) images.add(level, kBackwardImages);
    level.image_end = images.count();
    some_finer = some_finer || !level.is_empty();
  }
}

}  // namespace hg
