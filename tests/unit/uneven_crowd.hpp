// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// A crowd of groups of any size and place, for tests of what searches indexes in chunks, and the pairs of its tasks.
#pragma once

#include "src/search/pair_search.hpp"
#include "tests/unit/crowd.hpp"
#include "tests/unit/same_pairs.hpp"

#include <cmath>
#include <vector>

namespace hgtest {

inline hg::Domain any_box(Rng &rng) {
  hg::Domain domain = open_space(rng.integer(2, 3));
  for (int axis = 0; axis < domain.dimension; axis++) set_box(domain, axis, 0, Crowd::kEdge, rng.chance(0.4));
  return domain;
}

// Radii from `smallest` edges of the box to a tenth of it. Groups as dense as their particles are wide, and one that is
// thrown over the box; on faces, too.
inline Particles uneven_particles(Rng &rng, const hg::Domain &domain, size_t count, double smallest) {
  Particles particles;
  particles.dimension = domain.dimension;
  while (particles.count() < count) {
    const double radius = Crowd::kEdge * std::pow(10, rng.uniform(std::log10(smallest), -1.3));
    const int members = rng.integer(1, 100);
    const double spread = rng.chance(0.2) ? Crowd::kEdge : radius * std::pow(members, 1.0 / 3) * rng.uniform(0.5, 4);
    double middle[3];
    for (double &x : middle) x = rng.chance(0.3) ? 0 : Crowd::kEdge * rng.uniform();
    for (int n = 0; n < members && particles.count() < count; n++) {
      double center[3] = {0, 0, 0};
      for (int axis = 0; axis < domain.dimension; axis++) center[axis] = middle[axis] + spread * rng.uniform(-1, 1);
      particles.add(center, rng.chance(0.3) ? radius * smallest / 0.05 + 1e-300 : radius * rng.uniform(0.5, 1));
    }
  }
  return particles;
}

// One ball in the middle, in a thin cloud of dust of which a quarter lies in a dense core; `cloud` and `core` are
// their half widths.
inline Particles ball_in_dust(Rng &rng, int dimension, int count, double cloud, double core, double dust_radius) {
  Particles particles;
  particles.dimension = dimension;
  const double middle[3] = {50, 50, 50};
  particles.add(middle, 20);
  for (int i = 0; i < count; i++) {
    const double spread = i % 4 == 0 ? core : cloud;
    double center[3];
    for (double &x : center) x = 50 + spread * rng.uniform(-1, 1);
    particles.add(center, dust_radius);
  }
  return particles;
}

// What a search sends to an output that may stop it.
class Drain {
 public:
  explicit Drain(const hg::PairJudge &judge, size_t rooms = SIZE_MAX)
      : room_(kRoom), rooms_(rooms), stream_(judge, {room_.data(), room_.data() + kRoom, this, make_room}) {}
  Drain(const Drain &) = delete;
  Drain &operator=(const Drain &) = delete;

  hg::PairStream &stream() { return stream_; }
  const Pairs &pairs() {
    take();
    return pairs_;
  }
  bool refused() const { return refused_; }

 private:
  static constexpr size_t kRoom = hg::kMaxPiece + hg::kPadding;

  static bool make_room(hg::PairOutput *output, size_t count) {
    auto *self = static_cast<Drain *>(output->owner);
    self->take();
    self->refused_ = self->refused_ || count > kRoom || self->rooms_-- == 0;
    return !self->refused_;
  }
  void take() {
    pairs_.insert(pairs_.end(), room_.data(), stream_.output.next);
    stream_.output.next = room_.data();
  }

  Pairs room_, pairs_;
  size_t rooms_;
  bool refused_ = false;
  hg::PairStream stream_;
};

// The pairs of all tasks are those of exact arithmetic, each once, each in the task that it is due in; a search that is
// stopped has sent the first of them.
inline void check_tasks(const Crowd &crowd, size_t stop_after) {
  const hg::PairSearch search(crowd.index, crowd.tasks, crowd.store, crowd.overlap);
  std::vector<int> level(crowd.store.slots());
  for (int h = 0; h < crowd.index.level_count; h++) {
    for (uint32_t i = crowd.index.levels[h].begin; i < crowd.index.levels[h].end; i++) {
      level[crowd.index.particles.slot[i]] = h;
    }
  }
  Pairs all;
  for (size_t t = 0; t < crowd.tasks.count(); t++) {
    Drain drain(search.judge());
    require(search.send(t, drain.stream()), "task %zu: stopped", t);
    for (const hg_pair &pair : drain.pairs()) {
      const int a = level[static_cast<size_t>(pair.a)], b = level[static_cast<size_t>(pair.b)];
      require(std::max(a, b) == crowd.tasks[t].level && std::min(a, b) == crowd.tasks[t].target,
              "task %zu: levels %d and %d", t, a, b);
      all.push_back(pair);
    }
  }
  require_pairs("all tasks", sorted(all.data(), all.size()), crowd.pairs());

  Drain stopped(search.judge(), stop_after);
  bool go_on = true;
  for (size_t t = 0; go_on && t < crowd.tasks.count(); t++) go_on = search.send(t, stopped.stream());
  const size_t sent = stopped.pairs().size();
  require(go_on != stopped.refused(), "a search that was stopped went on, or the other way round");
  require(sent <= all.size() && (!go_on || sent == all.size()), "%zu pairs before the stop, of %zu", sent, all.size());
  require_pairs("before the stop", stopped.pairs(), Pairs(all.begin(), all.begin() + static_cast<ptrdiff_t>(sent)));
}

}  // namespace hgtest
