// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/images.hpp"

#include "src/index/chunk_images.hpp"

namespace hg {
namespace {

// The steps, in box lengths, that leave a particle so near to the box that it may reach into it: 0 and what is next to
// it.
struct Steps {
  int first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
  bool any = false;

  Steps(const Index &index, uint32_t i, float reach) {
    for (int axis = 0; axis < index.domain.dimension; axis++) {
      if (!index.domain.periodic[axis]) continue;
      const auto period = static_cast<float>(index.map.period[axis]);
      const auto x = static_cast<float>(index.particles.column(axis)[i]);
      if ((x - period) + reach >= 0) first[axis] = -1;
      if ((x + period) - reach <= period) last[axis] = 1;
      any = any || first[axis] < last[axis];
    }
  }
};

void append(Index &index, uint32_t i, Image image, uint32_t at) {
  PointStore &images = index.images;
  const size_t room = at + 1 + kPadding;
  for (int axis = 0; axis < index.domain.dimension; axis++) {
    images.column(axis).grow(room);
    images.column(axis)[at] = index.particles.column(axis)[i] + image_step(image, axis) * index.map.period[axis];
  }
  images.radius.grow(room);
  images.slot.grow(room);
  images.image.grow(room);
  images.radius[at] = index.particles.radius[i];
  images.slot[at] = index.particles.slot[i];
  images.image[at] = image;
}

// Images of one level whose step is forward (lexicographically positive) or backward.
uint32_t add_images(Index &index, const IndexLevel &level, bool forward, uint32_t at) {
  // The largest reach of a particle towards its own and finer levels.
  const float reach = 2 * level.cells.largest_radius * kSearchScale + kSearchSlack;
  for (uint32_t i = level.begin; i < level.end; i++) {
    const Steps steps(index, i, reach);
    if (!steps.any) continue;
    for (int z = steps.first[2]; z <= steps.last[2]; z++) {
      for (int y = steps.first[1]; y <= steps.last[1]; y++) {
        for (int x = steps.first[0]; x <= steps.last[0]; x++) {
          const bool is_forward = z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
          if ((x == 0 && y == 0 && z == 0) || is_forward != forward) continue;
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
  const auto add = [&](int h, bool forward) {
    return index.chunked ? add_chunk_images(index, h, forward, at) : add_images(index, index.levels[h], forward, at);
  };
  for (int h = 0; h < index.level_count; h++) {
    IndexLevel &level = index.levels[h];
    level.image_begin = at;
    if (index.domain.any_periodic) at = add(h, true);
    level.image_forward_end = at;
    if (index.domain.any_periodic) at = add(h, false);
    level.image_end = at;
  }
}

}  // namespace hg
