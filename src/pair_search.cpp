// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "pair_search.hpp"

#include "kernels/kernel_sets.hpp"
#include "window.hpp"

#include <algorithm>
#include <limits>

namespace hg {
namespace {

bool decide(PairSink *sink, uint32_t slot_a, uint32_t slot_b, uint8_t image) {
  const auto &overlap = *static_cast<const Overlap *>(sink->overlap);
  const auto &store = *static_cast<const ParticleStore *>(sink->store);
  return overlap.test(store.ball(slot_a), store.ball(slot_b), image, sink->exact_count);
}

void settle(PairSink *sink) {
  hg_pair *to = nullptr;  // where the pairs from `from` on go, once one has been taken out
  hg_pair *from = nullptr;
  for (uint32_t k = 0; k < sink->open_count; k++) {
    const OpenPair &open = sink->open[k];
    if (decide(sink, open.slot_a, open.slot_b, open.image)) continue;
    to = to == nullptr ? open.at : std::copy(from, open.at, to);
    from = open.at + 1;
  }
  if (to != nullptr) sink->next = std::copy(from, sink->next, to);
  sink->undecided_count += sink->open_count;
  sink->open_count = 0;
}

static_assert(kItself == kNoImage, "kernels and predicate must mean the same by no image");

class Search {
 public:
  Search(const Index &index, const ParticleStore &store, PairSink &sink)
      : index_(index),
        store_(store),
        sink_(sink),
        kernel_(active_kernels().search[index.domain.dimension - 2][index.interaction.kind]),
        particles_(index.particles.arrays(false)),
        images_(index.images.arrays(true)) {}

  // False if the sink stopped.
  bool run(const SearchTask &task) {
    const IndexLevel &target = index_.levels[task.target];
    if (task.images) return cross_level(images_, task.begin, task.end, target);
    if (task.level != task.target) return cross_level(particles_, task.begin, task.end, target);
    return own_level(task.begin, task.end, target);
  }

 private:
  bool own_level(uint32_t begin, uint32_t end, const IndexLevel &level) {
    if (!level.sparse) return kernel_.own_level(particles_, begin, end, level.cells, &sink_);
    SparseRows::Place place = index_.sparse.place_of(level.rows, begin);
    for (uint32_t i = begin; i < end; i++) {
      const Window w = window(particles_, i, level);
      const bool go_on =
          index_.sparse.visit_after(level.rows, index_.domain.dimension, i, place, w.low, w.high,
                                    [&](uint32_t first, uint32_t last) { return test(particles_, i, first, last); });
      if (!go_on) return false;
    }
    return true;
  }

  bool cross_level(const PointArrays &points, uint32_t begin, uint32_t end, const IndexLevel &level) {
    if (!level.sparse) return kernel_.cross_level(points, begin, end, level.cells, particles_, &sink_);
    for (uint32_t i = begin; i < end; i++) {
      const Window w = window(points, i, level);
      const bool go_on =
          index_.sparse.visit_box(level.rows, index_.domain.dimension, w.low, w.high,
                                  [&](uint32_t first, uint32_t last) { return test(points, i, first, last); });
      if (!go_on) return false;
    }
    return true;
  }

  static Image image_of(const PointArrays &points, uint32_t i) {
    return points.image != nullptr ? points.image[i] : kItself;
  }

  Window window(const PointArrays &points, uint32_t i, const IndexLevel &level) const {
    const uint32_t slot = points.slot[i];
    const double reach = index_.interaction.reach(store_.radius(slot), level.largest_radius);
    return Window::around(index_.domain, store_.center(slot), image_of(points, i), reach);
  }

  bool test(const PointArrays &points, uint32_t i, uint32_t begin, uint32_t end) {
    const uint32_t slot = points.slot[i];
    const Image image = image_of(points, i);
    sink_.candidate_count += end - begin;
    for (uint32_t j = begin; j < end; j++) {
      const uint32_t other = particles_.slot[j];
      if (!decide(&sink_, slot, other, image)) continue;
      if (sink_.next == sink_.limit && !sink_.make_room(&sink_, 1)) return false;
      const uint32_t low = slot < other ? slot : other, high = slot < other ? other : slot;
      *sink_.next++ = {static_cast<int32_t>(low) + sink_.id_offset, static_cast<int32_t>(high) + sink_.id_offset};
    }
    return true;
  }

  const Index &index_;
  const ParticleStore &store_;
  PairSink &sink_;
  SearchKernel kernel_;
  PointArrays particles_;
  PointArrays images_;
};

// HG_DOUBLE is its plain expression even where that under- or overflows. Only on such scales can the expression differ
// from a clear verdict of the fast test.
bool plain_squares_are_clear(const Index &index, const Overlap &overlap) {
  return overlap.accuracy() != HG_DOUBLE ||
         (index.frame.scale <= 0x1p480 && index.interaction.diameter(index.largest_radius) <= 1e150);
}

}  // namespace

void prepare_sink(PairSink &sink, const Index &index, const ParticleStore &store, const Overlap &overlap) {
  sink.settle = settle;
  sink.overlap = &overlap;
  sink.store = &store;
  sink.centers = store.centers();
  sink.radii = store.radii();
  sink.dimension = static_cast<uint32_t>(index.domain.dimension);
  sink.id_offset = store.id_offset();
  sink.band_constant = plain_squares_are_clear(index, overlap) ? kBandConstant : std::numeric_limits<float>::infinity();
}

bool search_task(const SearchTask &task, const Index &index, const ParticleStore &store, PairSink &sink) {
  const bool go_on = Search(index, store, sink).run(task);
  settle(&sink);
  return go_on;
}

}  // namespace hg
