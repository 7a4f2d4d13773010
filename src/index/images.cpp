// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/images.hpp"

namespace hg {
namespace {

bool reaches_box(const Index &index, uint32_t i, float window, int axis, int step) {
  if (step == 0) return true;
  if (!index.domain.periodic[axis]) return false;
  const Buffer<int32_t> &x = axis == 0 ? index.particles.x : (axis == 1 ? index.particles.y : index.particles.z);
  const float at = static_cast<float>(x[i]) + static_cast<float>(step) * static_cast<float>(index.frame.period[axis]);
  return at + window >= 0 && at - window <= static_cast<float>(index.frame.period[axis]);
}

void append(Index &index, uint32_t i, Image image, uint32_t at) {
  PointStore &images = index.images;
  images.x.grow(at + 1 + kPadding);
  images.y.grow(at + 1 + kPadding);
  images.radius.grow(at + 1 + kPadding);
  images.slot.grow(at + 1 + kPadding);
  images.image.grow(at + 1 + kPadding);
  images.x[at] = index.particles.x[i] + image_step(image, 0) * index.frame.period[0];
  images.y[at] = index.particles.y[i] + image_step(image, 1) * index.frame.period[1];
  if (index.domain.dimension == 3) {
    images.z.grow(at + 1 + kPadding);
    images.z[at] = index.particles.z[i] + image_step(image, 2) * index.frame.period[2];
  }
  images.radius[at] = index.particles.radius[i];
  images.slot[at] = index.particles.slot[i];
  images.image[at] = image;
}

// Images of one level whose step is forward (lexicographically positive) or backward.
uint32_t add_images(Index &index, const IndexLevel &level, bool forward, uint32_t at) {
  const int z_steps = index.domain.dimension == 3 ? 1 : 0;
  for (uint32_t i = level.begin; i < level.end; i++) {
    // The largest reach of this particle towards its own and finer levels.
    const float window = 2 * level.cells.largest_radius * kWindowScale + kWindowSlack;
    for (int z = -z_steps; z <= z_steps; z++) {
      for (int y = -1; y <= 1; y++) {
        for (int x = -1; x <= 1; x++) {
          const bool is_forward = z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
          if ((x == 0 && y == 0 && z == 0) || is_forward != forward) continue;
          if (!reaches_box(index, i, window, 0, x) || !reaches_box(index, i, window, 1, y) ||
              !reaches_box(index, i, window, 2, z)) {
            continue;
          }
          append(index, i, make_image(x, y, z), at++);
        }
      }
    }
  }
  return at;
}

}  // namespace

void build_images(Index &index) {
  uint32_t at = 0;
  for (int h = 0; h < index.level_count; h++) {
    IndexLevel &level = index.levels[h];
    level.image_begin = at;
    if (index.domain.any_periodic) at = add_images(index, level, true, at);
    level.image_forward_end = at;
    if (index.domain.any_periodic) at = add_images(index, level, false, at);
    level.image_end = at;
  }
}

}  // namespace hg
