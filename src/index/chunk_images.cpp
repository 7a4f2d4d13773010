// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/chunk_images.hpp"

namespace hg {
namespace {

class ChunkImages {
 public:
  ChunkImages(Index &index, int h, uint32_t at)
      : index_(index),
        level_(index.chunks.level(h)),
        reach_(2.0 * static_cast<double>(index.levels[h].cells.largest_radius) + 2 * level_.slack + kFarSlack),
        at_(at) {
    for (int axis = 0; axis < index.domain.dimension; axis++) period_[axis] = index.map.period_place(axis);
  }

  uint32_t count() const { return at_; }

  void add(size_t chunk, const double *corner, bool forward) {
    const double end[3] = {corner[0] + level_.chunk_length(), corner[1] + level_.row_width,
                           corner[2] + level_.row_width};
    const Image first = forward ? kNoImage + 1 : 0, last = forward ? kImages : kNoImage;
    for (Image image = first; image < last; image++) {
      if (!reaches(image, corner, end)) continue;
      for (uint32_t i = index_.chunks.chunk_begin(chunk); i < index_.chunks.chunk_end(chunk); i++) {
        double place[3];
        index_.chunks.find_place(index_.particles.arrays(false), i, chunk, corner, index_.domain.dimension, place);
        if (reaches(image, place, place)) append(i, place, image);
      }
    }
  }

 private:
  // May what lies between two places reach into the box once it is moved by the image's step?
  bool reaches(Image image, const double *low, const double *high) const {
    for (int axis = 0; axis < 3; axis++) {
      const int step = image_step(image, axis);
      if (step == 0) continue;
      if (!index_.domain.periodic[axis]) return false;
      if (step < 0 ? (high[axis] - period_[axis]) + reach_ < 0 : low[axis] - reach_ > 0) return false;
    }
    return true;
  }

  void append(uint32_t i, const double *place, Image image) {
    PointStore &images = index_.images;
    const size_t room = at_ + 1 + kPadding;
    for (int axis = 0; axis < index_.domain.dimension; axis++) {
      const int step = image_step(image, axis);
      images.column(axis).grow(room);
      images.column(axis)[at_] = moved_by(index_.particles.column(axis)[i], step, index_.map.period[axis]);
      index_.image_place[axis].grow(room);
      index_.image_place[axis][at_] = place[axis] + step * period_[axis];
    }
    images.radius.grow(room);
    images.slot.grow(room);
    images.image.grow(room);
    images.radius[at_] = index_.particles.radius[i];
    images.slot[at_] = index_.particles.slot[i];
    images.image[at_++] = image;
  }

  Index &index_;
  const ChunkLevel &level_;
  double reach_;
  double period_[3] = {0, 0, 0};
  uint32_t at_;
};

}  // namespace

uint32_t add_chunk_images(Index &index, int h, bool forward, uint32_t at) {
  ChunkImages images(index, h, at);
  const ChunkLevel &level = index.chunks.level(h);
  index.chunks.visit_box(level, level.space, [&](size_t chunk, const double *corner) {
    images.add(chunk, corner, forward);
    return true;
  });
  return images.count();
}

}  // namespace hg
