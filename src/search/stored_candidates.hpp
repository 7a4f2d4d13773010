// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The pairs that may come to interact while particles move within the skin, and where the particles were and are.
// docs/theory/exactness.md, section 13, proves that none is missed.
#pragma once

#include "src/exact/overlap.hpp"
#include "src/index/index.hpp"
#include "src/pairs/pair_list.hpp"
#include "src/pairs/pair_order.hpp"
#include "src/particles/particle_store.hpp"
#include "src/search/search_tasks.hpp"

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
  bool collect(const Index &index, const SearchTasks &tasks, const ParticleStore &store, const Interaction &interaction,
               PairPool &pool, SearchCounts &counts);
  void drop() { kept_ = moved_ = false; }

  // Puts the candidates into ascending order of their particles, so that those that interact come in it, too. Not if
  // the filter would then read its points all over memory, which costs more than to order the pairs that it finds. Out
  // of memory, candidates are dropped.
  void ascend(PairOrder &order);
  bool ascending() const { return kept_ && ascending_; }

  // Takes the particles to where they are now. False if one has moved too far: then the candidates are of no use.
  // `radii`: one may have changed since the candidates were collected.
  bool update(const ParticleStore &store, bool radii);

  // Particles have moved by this distance at most since the last call of this or of update.
  void add_motion(double distance);
  // Whether that matters: else update looks at all particles anyway.
  bool counts_motion() const { return direct(); }

  bool kept() const { return kept_; }
  bool moved() const { return moved_; }  // particles may have, since the index was built
  size_t count() const { return kept_ ? list_.count() : 0; }

  // While candidates are kept:
  const Index &index() const { return *index_; }
  const hg_pair *pairs() const { return list_.data(); }  // of points; of slots, the smaller first, if direct
  // They are tested on the caller's doubles: nothing has to follow the particles while they have not moved far.
  bool direct() const { return kept_ && direct_; }
  const uint32_t *slots() const { return slot_.data(); }  // of the points
  const Point *points() const { return points_.data(); }  // none if direct

  // Do two points (slots) interact, decided on the caller's doubles?
  bool interact(uint32_t a, uint32_t b, const ParticleStore &store, const Overlap &overlap, int64_t &exact) const;

  // Particle p of the index lies whole edges of the cell away from where the caller has it: how many are taken off.
  Shift boxes(size_t p, const ParticleStore &store) const;

  // The cell becomes another one, if its deformation leaves something of the skin: then particles may move by what is
  // left. False, and nothing has changed, if not, or if nothing is kept. The index must be given the cell, too.
  bool keep_in(const Domain &domain);

 private:
  // One of its points is an image.
  struct ImageCandidate {
    hg_pair slots, points;
  };

  // body(begin, end) for parts of the particles, on all threads.
  template <class Body>
  void for_parts(Body &&body);
  bool may_be_direct(const ParticleStore &store) const;
  bool squares_are_safe(const Interval &radii) const;
  void set_slots();
  void set_points(const ParticleStore &store);
  bool update_particles(const ParticleStore &store, bool radii);
  void update_images();
  void find_points_of_slots();
  hg_pair slots_of(const hg_pair &candidate) const;
  size_t copy_image_candidates();
  void slots_to_points(size_t images);
  double start_place(size_t p, int axis) const;

  int threads_;
  const Index *index_ = nullptr;
  Interaction interaction_;
  Domain collected_;  // where they were
  double skin_ = 0;
  float room_ = 0;   // quanta that a particle may move and grow
  double left_ = 0;  // of them, surely, without a look at each; if direct
  bool kept_ = false;
  bool moved_ = false;
  bool ascending_ = false;
  bool direct_ = false;
  size_t particle_count_ = 0, image_count_ = 0;  // of the index
  size_t slot_count_ = 0;
  PairList list_;
  Buffer<Point> points_;
  Buffer<double> place_[3];         // of each particle at first, where coordinates wrap
  Buffer<uint32_t> slot_;           // of each point
  Buffer<uint32_t> original_;       // of each image: the particle that it is an image of, as a point
  Buffer<uint32_t> point_of_slot_;  // of particles
  Buffer<ImageCandidate> image_candidates_;
};

}  // namespace hg
