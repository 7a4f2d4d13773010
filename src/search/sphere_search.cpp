// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/sphere_search.hpp"

#include "src/space/level_cells.hpp"
#include "src/space/window.hpp"

#include <algorithm>

namespace hg {
namespace {

class SphereSearch {
 public:
  SphereSearch(const Index &index, const ParticleStore &store, const Overlap &overlap,
               const StoredCandidates &candidates, const Ball &sphere, Buffer<int32_t> &found)
      : index_(index), store_(store), overlap_(overlap), candidates_(candidates), sphere_(sphere), found_(found) {}

  size_t run() {
    for (int h = 0; h < index_.level_count; h++) {
      const IndexLevel &level = index_.levels[h];
      if (level.begin == level.end) continue;
      for (Image image = 0; image < 27; image++) {
        if (is_possible(image)) search(level, image);
      }
    }
    // A sphere wider than half the box can meet a particle through several images.
    if (index_.domain.any_periodic) {
      std::sort(found_.data(), found_.data() + count_);
      count_ = static_cast<size_t>(std::unique(found_.data(), found_.data() + count_) - found_.data());
    }
    return count_;
  }

 private:
  bool is_possible(Image image) const {
    for (int k = 0; k < 3; k++) {
      if (image_step(image, k) != 0 && !index_.domain.periodic[k]) return false;
    }
    return true;
  }

  void search(const IndexLevel &level, Image image) {
    const double reach = index_.interaction.reach(sphere_.radius, level.largest_radius);
    const Window window = Window::around(index_.domain, sphere_.center, image, reach);
    if (window.misses_box(index_.domain)) return;
    if (level.sparse) {
      index_.sparse.visit_box(level.rows, index_.domain.dimension, window.low, window.high,
                              [&](uint32_t begin, uint32_t end) {
                                test(begin, end, image);
                                return true;
                              });
    } else {
      search_cells(level, window, image);
    }
  }

  void search_cells(const IndexLevel &level, const Window &window, Image image) {
    int32_t first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
    for (int k = 0; k < index_.domain.dimension; k++) {
      first[k] = outer_cell(level.cells, k, window.low[k], -1.0);
      last[k] = outer_cell(level.cells, k, window.high[k], 1.0);
    }
    for (int32_t z = first[2]; z <= last[2]; z++) {
      for (int32_t y = first[1]; y <= last[1]; y++) {
        const uint32_t *cell =
            level.cells.cell_begin +
            (static_cast<size_t>(z) * static_cast<size_t>(level.cells.count[1]) + static_cast<size_t>(y)) *
                static_cast<size_t>(level.cells.count[0]);
        test(cell[first[0]], cell[last[0] + 1], image);
      }
    }
  }

  // The cell of a window's end, which may lie far outside; `side` says which way it may move.
  int32_t outer_cell(const CellTable &cells, int axis, double x, double side) const {
    const double quanta = index_.frame.quanta(axis, x) + side * static_cast<double>(kWindowSlack);
    return cell_of(cells, axis, static_cast<float>(std::clamp(quanta, -1.0, kFrameQuanta)));
  }

  void test(uint32_t begin, uint32_t end, Image image) {
    int64_t exact = 0;
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t slot = index_.particles.slot[j];
      Image seen = image;
      if (candidates_.moved() && !candidates_.see(j, seen, store_)) continue;
      if (!overlap_.test(sphere_, store_.ball(slot), seen, exact)) continue;
      found_.grow(count_ + 1);
      found_[count_++] = static_cast<int32_t>(slot);
    }
  }

  const Index &index_;
  const ParticleStore &store_;
  const Overlap &overlap_;
  const StoredCandidates &candidates_;
  const Ball &sphere_;
  Buffer<int32_t> &found_;
  size_t count_ = 0;
};

}  // namespace

size_t search_sphere(const Index &index, const ParticleStore &store, const Overlap &overlap,
                     const StoredCandidates &candidates, const Ball &sphere, Buffer<int32_t> &found) {
  return SphereSearch(index, store, overlap, candidates, sphere, found).run();
}

}  // namespace hg
