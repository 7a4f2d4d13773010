// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The periodic images of points that reach into the box, one source for all instruction sets. A plain loop over blocks
// that the compiler turns into vector code, as in build.hpp, finds the images of each point as bits; few have any.
#pragma once

#include "src/kernels/kernel_set.hpp"

namespace hg {
namespace {

template <int D>
class ImageBlock {
  static constexpr size_t kGroup = 8;  // points without images that are passed over together

 public:
  static constexpr size_t kBlock = 64;

  explicit ImageBlock(const ImageInput &input) : input_(input), wanted_(input.wanted) {
    for (int axis = 0; axis < 3; axis++) {
      if (!is_periodic(axis)) wanted_ &= kImagesWithStep[axis][1];
    }
  }

  PointImage *run(size_t at, size_t count, PointImage *next) {
    for (ImageSet &images : images_) images = wanted_;
    for (int axis = 0; axis < D; axis++) {
      if (is_periodic(axis)) keep_near(axis, at, count);
    }
    for (size_t group = 0; group < count; group += kGroup) {
      ImageSet any = 0;
      for (size_t i = group; i < group + kGroup; i++) any |= images_[i];
      if (any == 0) continue;
      for (size_t i = group; i < group + kGroup && i < count; i++) next = list(at + i, images_[i], next);
    }
    return next;
  }

 private:
  bool is_periodic(int axis) const { return axis < D && input_.periodic[axis]; }

  // Of the images that move along an axis, those of points that come near the box by it.
  void keep_near(int axis, size_t at, size_t count) {
    const int32_t *__restrict x = input_.x[axis] + at;
    if (count < kBlock) {
      for (size_t i = 0; i < kBlock; i++) copy_[i] = x[i < count ? i : 0];
      x = copy_;
    }
    ImageSet *__restrict images = images_;
    const ImageSet down = kImagesWithStep[axis][0], stay = kImagesWithStep[axis][1], up = kImagesWithStep[axis][2];
    const auto period = static_cast<float>(input_.period[axis]);
    const float reach = input_.reach;
    for (size_t i = 0; i < kBlock; i++) {
      const auto here = static_cast<float>(x[i]);
      images[i] &= stay | ((here - period) + reach >= 0 ? down : 0) | ((here + period) - reach <= period ? up : 0);
    }
  }

  static PointImage *list(size_t point, ImageSet images, PointImage *next) {
    for (; images != 0; images &= images - 1) {
      *next++ = {static_cast<uint32_t>(point), static_cast<Image>(__builtin_ctz(static_cast<uint32_t>(images)))};
    }
    return next;
  }

  const ImageInput &input_;
  ImageSet wanted_;
  alignas(64) ImageSet images_[kBlock];
  alignas(64) int32_t copy_[kBlock];
};

template <int D>
size_t find_images(const ImageInput &input, size_t begin, size_t end, PointImage *found) {
  constexpr size_t kBlock = ImageBlock<D>::kBlock;
  ImageBlock<D> block(input);
  PointImage *next = found;
  for (size_t at = begin; at < end; at += kBlock) {
    next = block.run(at, end - at < kBlock ? end - at : kBlock, next);
  }
  return static_cast<size_t>(next - found);
}

}  // namespace
}  // namespace hg
