// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/index/images.hpp"

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
      set(axis, (x - period) + reach >= 0, (x + period) - reach <= period);
    }
  }
  // For anything between two places.
  Steps(const Index &index, const double *low, const double *high, double reach) {
    for (int axis = 0; axis < 3; axis++) {
      if (!index.domain.periodic[axis]) continue;
      const double period = index.map.period_place(axis);
      set(axis, (high[axis] - period) + reach >= 0, low[axis] - reach <= 0);
    }
  }

 private:
  void set(int axis, bool back, bool forth) {
    if (back) first[axis] = -1;
    if (forth) last[axis] = 1;
    any = any || back || forth;
  }
};

void append(Index &index, uint32_t i, Image image, uint32_t at) {
  PointStore &images = index.images;
  const size_t room = at + 1 + kPadding;
  for (int axis = 0; axis < index.domain.dimension; axis++) {
    images.column(axis).grow(room);
    images.column(axis)[at] =
        moved_by(index.particles.column(axis)[i], image_step(image, axis), index.map.period[axis]);
  }
  images.radius.grow(room);
  images.slot.grow(room);
  images.image.grow(room);
  images.radius[at] = index.particles.radius[i];
  images.slot[at] = index.particles.slot[i];
  images.image[at] = image;
}

void append_far(Index &index, uint32_t i, const double *place, Image image, uint32_t at) {
  append(index, i, image, at);
  for (int axis = 0; axis < index.domain.dimension; axis++) {
    index.image_place[axis].grow(at + 1);
    index.image_place[axis][at] = place[axis] + image_step(image, axis) * index.map.period_place(axis);
  }
}

template <class Append>
void append_all(const Steps &steps, bool forward, Append &&append_one) {
  for (int z = steps.first[2]; z <= steps.last[2]; z++) {
    for (int y = steps.first[1]; y <= steps.last[1]; y++) {
      for (int x = steps.first[0]; x <= steps.last[0]; x++) {
        const bool is_forward = z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
        if ((x == 0 && y == 0 && z == 0) || is_forward != forward) continue;
        append_one(make_image(x, y, z));
      }
    }
  }
}

// Images of one level whose step is forward (lexicographically positive) or backward.
uint32_t add_images(Index &index, const IndexLevel &level, bool forward, uint32_t at) {
  // The largest reach of a particle towards its own and finer levels.
  const float reach = 2 * level.cells.largest_radius * kSearchScale + kSearchSlack;
  for (uint32_t i = level.begin; i < level.end; i++) {
    const Steps steps(index, i, reach);
    if (!steps.any) continue;
    append_all(steps, forward, [&](Image image) { append(index, i, image, at++); });
  }
  return at;
}

// The same of a level in chunks. Most chunks are far from all faces.
uint32_t add_far_images(Index &index, int h, bool forward, uint32_t at) {
  const ChunkRows &chunks = index.chunks;
  const ChunkLevel &level = chunks.level(h);
  const double reach = 2.0 * static_cast<double>(index.levels[h].cells.largest_radius) + 2 * level.slack;
  chunks.visit_box(level, level.space, [&](size_t chunk, const double *corner) {
    const double end[3] = {corner[0] + level.chunk_length(), corner[1] + level.row_width, corner[2] + level.row_width};
    if (!Steps(index, corner, end, reach).any) return true;
    for (uint32_t i = chunks.chunk_begin(chunk); i < chunks.chunk_end(chunk); i++) {
      double place[3];
      chunks.find_place(index.particles.arrays(false), i, chunk, corner, index.domain.dimension, place);
      append_all(Steps(index, place, place, reach), forward,
                 [&](Image image) { append_far(index, i, place, image, at++); });
    }
    return true;
  });
  return at;
}

}  // namespace

void build_images(Index &index) {
  uint32_t at = 0;
  const auto add = [&](int h, bool forward) {
    return index.chunked ? add_far_images(index, h, forward, at) : add_images(index, index.levels[h], forward, at);
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
