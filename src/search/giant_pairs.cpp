// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/giant_pairs.hpp"

#include "src/search/image_pairs.hpp"

namespace hg {

bool GiantPairs::run(const SearchTask &task) {
  const ChunkRows &chunks = index_.chunks;
  for (uint32_t i = task.begin; i < task.end; i++) {
    const uint32_t slot = (task.images ? index_.images : index_.particles).slot[i];
    const PlaceBox box = box_of(task, i, store_.radius(slot));
    const bool go_on = chunks.visit_box(chunks.level(task.target), box, [&](size_t chunk, const double *) {
      return test(task, i, slot, chunks.chunk_begin(chunk), chunks.chunk_end(chunk));
    });
    if (!go_on) return false;
  }
  return true;
}

// Doubles round the reach by less than the slack of any level.
PlaceBox GiantPairs::box_of(const SearchTask &task, uint32_t i, double radius) const {
  const double largest = index_.levels[task.target].largest_radius;
  const double reach = index_.interaction.reach(radius, largest) * index_.map.scale * (1 + 0x1p-40);
  PlaceBox box;
  for (int axis = 0; axis < index_.domain.dimension; axis++) {
    const double place = task.images ? index_.image_place[axis][i] : index_.chunks.giant_place(axis, i);
    box.low[axis] = place - reach;
    box.high[axis] = place + reach;
  }
  return box;
}

// Of its own level a giant looks only at what comes after it.
bool GiantPairs::test(const SearchTask &task, uint32_t i, uint32_t slot, uint32_t begin, uint32_t end) {
  if (task.level == task.target && !task.images && begin <= i) begin = i + 1;
  const int32_t *body = particles_.body;
  const int32_t own = body != nullptr ? points_.body[i] : kNoBody;
  const Image image = points_.image != nullptr ? points_.image[i] : kNoImage;
  const uint32_t name = points_.slot[i];
  const int32_t offset = stream_.judge.id_offset;
  PairOutput &output = stream_.output;
  for (uint32_t j = begin; j < end; j++) {
    stream_.candidate_total++;
    if (own != kNoBody && body[j] == own) continue;
    if (!interact(index_, store_, overlap_, slot, index_.particles.slot[j], image, stream_.exact_total)) continue;
    if (output.next == output.limit && !output.make_room(&output, 1)) return false;
    const uint32_t other = particles_.slot[j];
    const uint32_t low = name < other ? name : other, high = name < other ? other : name;
    *output.next++ = {static_cast<int32_t>(low) + offset, static_cast<int32_t>(high) + offset};
  }
  return true;
}

}  // namespace hg
