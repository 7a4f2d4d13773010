// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/sparse_search.hpp"

namespace hg {

bool SparseSearch::run(const SearchTask &task, bool own_level) {
  const IndexLevel &target = index_.levels[task.target];
  const int dimension = index_.domain.dimension;
  SparseRows::Place place{};
  if (own_level) place = index_.sparse.place_of(target.rows, task.begin);
  for (uint32_t i = task.begin; i < task.end; i++) {
    const SearchBox box = box_of(i, target);
    const auto visit = [&](uint32_t begin, uint32_t end) { return test(i, begin, end); };
    const bool go_on = own_level ? index_.sparse.visit_after(target.rows, dimension, i, place, box.low, box.high, visit)
                                 : index_.sparse.visit_box(target.rows, dimension, box.low, box.high, visit);
    if (!go_on) return false;
  }
  return true;
}

SearchBox SparseSearch::box_of(uint32_t i, const IndexLevel &target) const {
  const Ball ball = store_.ball(slot_of(i));
  const double reach = index_.interaction.reach(ball.radius, target.largest_radius);
  return SearchBox::around(index_.domain, ball.center, image_of(i), reach);
}

bool SparseSearch::test(uint32_t i, uint32_t begin, uint32_t end) {
  const Ball ball = store_.ball(slot_of(i));
  const Image image = image_of(i);
  const uint32_t name = points_.slot[i];
  const int32_t offset = stream_.judge.id_offset;
  PairOutput &output = stream_.output;
  stream_.candidate_total += end - begin;
  for (uint32_t j = begin; j < end; j++) {
    if (!overlap_.holds(ball, store_.ball(index_.particles.slot[j]), image, stream_.exact_total)) continue;
    if (output.next == output.limit && !output.make_room(&output, 1)) return false;
    const uint32_t other = particles_.slot[j];
    const uint32_t low = name < other ? name : other, high = name < other ? other : name;
    *output.next++ = {static_cast<int32_t>(low) + offset, static_cast<int32_t>(high) + offset};
  }
  return true;
}

}  // namespace hg
