// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/pair_search.hpp"

#include "src/kernels/kernel_sets.hpp"
#include "src/pairs/open_pairs.hpp"
#include "src/space/window.hpp"

#include <limits>

namespace hg {
namespace {

bool decide(PairSink *sink, uint32_t slot_a, uint32_t slot_b, uint8_t image) {
  const auto &overlap = *static_cast<const Overlap *>(sink->overlap);
  const auto &store = *static_cast<const ParticleStore *>(sink->store);
  return overlap.test(store.ball(slot_a), store.ball(slot_b), image, sink->exact_count);
}

void settle(PairSink *sink) {
  settle_open(*sink, [=](const OpenPair &open) { return decide(sink, open.slot_a, open.slot_b, open.image); });
}

// Candidates need not be sure to interact.
void keep_all(PairSink *sink) {
  sink->undecided_count += sink->open_count;
  sink->open_count = 0;
}

static_assert(kItself == kNoImage, "kernels and predicate must mean the same by no image");

class Search {
 public:
  // With `names`, pairs hold these instead of slots.
  Search(const Index &index, const ParticleStore &store, PairSink &sink, const uint32_t *names)
      : index_(index),
        store_(store),
        sink_(sink),
        kernel_(active_kernels().search[index.domain.dimension - 2][index.interaction.kind]),
        particles_(index.particles.arrays(false)),
        images_(index.images.arrays(true)) {
    if (names == nullptr) return;
    particles_.slot = names;
    images_.slot = names + store.slots();
  }

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

  // points.slot may hold names.
  uint32_t slot_of(const PointArrays &points, uint32_t i) const {
    return points.image != nullptr ? index_.images.slot[i] : index_.particles.slot[i];
  }

  Window window(const PointArrays &points, uint32_t i, const IndexLevel &level) const {
    const uint32_t slot = slot_of(points, i);
    const double reach = index_.interaction.reach(store_.radius(slot), level.largest_radius);
    return Window::around(index_.domain, store_.center(slot), image_of(points, i), reach);
  }

  bool test(const PointArrays &points, uint32_t i, uint32_t begin, uint32_t end) {
    const uint32_t slot = slot_of(points, i), name = points.slot[i];
    const Image image = image_of(points, i);
    sink_.candidate_count += end - begin;
    for (uint32_t j = begin; j < end; j++) {
      if (!decide(&sink_, slot, index_.particles.slot[j], image)) continue;
      if (sink_.next == sink_.limit && !sink_.make_room(&sink_, 1)) return false;
      const uint32_t other = particles_.slot[j];
      const uint32_t low = name < other ? name : other, high = name < other ? other : name;
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

void give_doubles(PairSink &sink, const Overlap &overlap, const ParticleStore &store, const Domain &domain) {
  sink.overlap = &overlap;
  sink.store = &store;
  sink.centers = store.centers();
  sink.radii = store.radii();
  sink.dimension = static_cast<uint32_t>(domain.dimension);
}

}  // namespace

bool plain_squares_are_clear(int32_t accuracy, double scale, double reach) {
  return accuracy != HG_DOUBLE || (scale <= 0x1p480 && reach <= 1e150);
}

void PairSearch::prepare(PairSink &sink) const {
  give_doubles(sink, overlap_, store_, index_.domain);
  sink.settle = settle;
  sink.id_offset = store_.id_offset();
  const bool clear = index_.interaction.margin == overlap_.interaction().margin &&
                     plain_squares_are_clear(overlap_.accuracy(), index_.frame.scale,
                                             index_.interaction.diameter(index_.largest_radius));
  sink.band_constant = clear ? kBandConstant : std::numeric_limits<float>::infinity();
}

bool PairSearch::run(size_t task, PairSink &sink) const {
  const bool go_on = Search(index_, store_, sink, nullptr).run(index_.tasks[task]);
  sink.settle(&sink);
  return go_on;
}

void CandidateSearch::prepare(PairSink &sink) const {
  give_doubles(sink, overlap_, store_, index_.domain);
  sink.settle = keep_all;
  sink.id_offset = 0;
  sink.band_constant = kBandConstant;
}

bool CandidateSearch::run(size_t task, PairSink &sink) const {
  const bool go_on = Search(index_, store_, sink, names_).run(index_.tasks[task]);
  sink.settle(&sink);
  return go_on;
}

}  // namespace hg
