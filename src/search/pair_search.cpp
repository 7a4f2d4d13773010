// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/pair_search.hpp"

#include "src/exact/fast_test.hpp"
#include "src/pairs/undecided_pairs.hpp"
#include "src/search/chunk_pairs.hpp"
#include "src/search/giant_pairs.hpp"
#include "src/search/image_pairs.hpp"

#include <limits>

namespace hg {

bool plain_squares_are_clear(int32_t accuracy, double scale, double reach) {
  return accuracy != HG_DOUBLE || (scale <= 0x1p480 && reach <= 1e150);
}

PairJudge PairSearch::judge() const {
  PairJudge judge{};
  judge.decide = [](PairStream *stream) {
    const auto &self = *static_cast<const PairSearch *>(stream->judge.source);
    decide_each(*stream, [&](const UndecidedPair &pair) {
      return interact(self.index_, self.store_, self.overlap_, pair.a, pair.b, pair.image, stream->exact_total);
    });
  };
  judge.source = this;
  judge.centers = store_.centers();
  judge.radii = store_.radii();
  judge.dimension = static_cast<uint32_t>(index_.domain.dimension);
  judge.id_offset = store_.id_offset();
  const bool clear = index_.interaction.margin == overlap_.interaction().margin &&
                     plain_squares_are_clear(overlap_.accuracy(), index_.map.scale, index_.largest_reach());
  judge.band_constant = clear ? kBandConstant : std::numeric_limits<float>::infinity();
  return judge;
}

bool PairSearch::send(size_t task, PairStream &stream) const {
  return send(task, index_.particles.arrays(false), index_.images.arrays(true), stream);
}

bool PairSearch::send(size_t n, const PointArrays &particles, const PointArrays &images, PairStream &stream) const {
  const SearchTask &task = tasks_[n];
  const IndexLevel &target = index_.levels[task.target];
  const PointArrays &points = task.images ? images : particles;
  const bool own_level = task.level == task.target && !task.images;
  const SearchKernel &kernel = active_kernels().search[index_.domain.dimension - 2][index_.interaction.kind];
  bool go_on;
  if (index_.chunked && index_.chunks.level(task.level).giants) {
    go_on = GiantPairs(index_, store_, overlap_, points, particles, stream).run(task);
  } else if (index_.chunked) {
    go_on = ChunkPairs(index_, points, particles, stream).run(task);
  } else if (own_level) {
    go_on = kernel.own_level(points, task.begin, task.end, target.cells, &stream);
  } else {
    go_on = kernel.cross_level(points, task.begin, task.end, target.cells, particles, &stream);
  }
  stream.judge.decide(&stream);
  return go_on;
}

}  // namespace hg
