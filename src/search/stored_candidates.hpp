// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs that may come to interact while particles move within the skin, and where the particles were and are.
// docs/exactness.md proves that none is missed.
#pragma once

#include "src/base/memory.hpp"
#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/pairs/pair_list.hpp"
#include "src/pairs/pair_source.hpp"
#include "src/particles/particle_store.hpp"

#include <cstddef>
#include <cstdint>

namespace hg {

// A candidate is a pair of points. Points are the particles in the order of the index, then its images.
class StoredCandidates {
 public:
  StoredCandidates(Memory &memory, int threads);

  // Collects the pairs of an index that was made for a margin wider than that of `interaction` by the skin, of
  // particles that have not moved since it was built. False, and nothing is kept, if they are too many to pay. The
  // index must stay as it is.
  bool collect(const Index &index, const ParticleStore &store, const Interaction &interaction, PairWorkers &workers,
               SearchCounts &counts);
  void drop() { kept_ = moved_ = false; }

  // Takes the particles to where they are now. False if one has moved too far: then the candidates are of no use.
  // `radii`: one may have changed since the candidates were collected.
  bool follow(const ParticleStore &store, bool radii);

  bool kept() const { return kept_; }
  size_t count() const { return kept_ ? list_.count() : 0; }

  // Once particles have moved, they may lie outside the box that the index put them in. `image` of a ball as seen from
  // the particle with this place in the index becomes the image as seen from its own box. False if that is two boxes
  // off, where the particle is out of reach or nearer through another image.
  bool moved() const { return moved_; }
  bool see(size_t place, Image &image, const ParticleStore &store) const;

 private:
  friend class CandidateFilter;
  // body(begin, end) for parts of the particles, on all threads.
  template <class Body>
  void for_parts(Body &&body);
  void place_particles(const ParticleStore &store);
  bool follow_particles(const ParticleStore &store, bool radii);
  void follow_images();
  void name_points();
  void outside(size_t place, const ParticleStore &store, int *boxes) const;
  bool see_from(const int *ball_outside, size_t place, Image &image, const ParticleStore &store) const;
  // Two points, decided on the caller's doubles.
  bool interact(uint32_t a, uint32_t b, const ParticleStore &store, const Overlap &overlap, int64_t &exact) const;

  int threads_;
  const Index *index_ = nullptr;
  Interaction interaction_;
  float room_ = 0;  // quanta that a particle may move and grow
  bool kept_ = false;
  bool moved_ = false;
  size_t particles_ = 0, image_count_ = 0;
  PairList list_;
  Buffer<Record> points_;
  Buffer<uint32_t> slot_;   // of each point
  Buffer<uint32_t> owner_;  // of each image: the particle's place in the index
  Buffer<uint32_t> place_;  // of each slot in the index, while owners are found
};

// The candidates that interact now.
class CandidateFilter final : public PairSource {
 public:
  CandidateFilter(const StoredCandidates &candidates, const ParticleStore &store, const Overlap &overlap)
      : candidates_(candidates), store_(store), overlap_(overlap) {}
  size_t task_count() const override;
  void prepare(PairSink &sink) const override;
  bool run(size_t task, PairSink &sink) const override;

 private:
  const StoredCandidates &candidates_;
  const ParticleStore &store_;
  const Overlap &overlap_;
};

// The widest skin up to `wanted` that candidates can be collected with in this system; 0 if none is worth it.
double usable_skin(double wanted, const Interaction &interaction, const Domain &domain, const Bounds &bounds,
                   int32_t accuracy, size_t particles);

}  // namespace hg
