// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Stored candidates against the oracle: what is collected, what of it interacts after any motion within the skin,
// through faces of the box too, when a particle has gone too far, and when candidates are too many; in chunks, too.
#include "src/search/skin.hpp"
#include "tests/unit/cells.hpp"
#include "tests/unit/same_pairs.hpp"
#include "tests/unit/search/stored.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace {

using namespace hgtest;
using hg::Image;

Sphere particle(const Crowd &crowd, size_t i) { return {crowd.particles.center(i), crowd.particles.radii[i]}; }

class Run {
 public:
  explicit Run(uint64_t seed)
      : rng_(seed),
        shape_(skinned_shape(rng_, 1 + rng_.below(150))),
        stored_(seed, shape_),
        crowd_(stored_.crowd),
        candidates_(stored_.candidates),
        start_(crowd_.particles) {
    // Beside an outlier the skin is but a few quanta.
    half_ = 0.5 * shape_.skin * (1 - 0x1p-19) - 20 / crowd_.index.map.scale;
    near_.list(crowd_.index.domain, crowd_.index.map, 60 + shape_.skin);
  }

  // Whether the index is in chunks.
  bool check() {
    require(stored_.collect() && candidates_.kept() && !candidates_.moved(), "nothing was kept");
    check_points();
    check_collected();
    check_interacting();
    const int ascend_at = rng_.integer(0, 8);  // after 3: never
    for (int step = 0; step < 4 && half_ > 0; step++) {
      const bool with_radii = step >= 2;  // from the third step on, radii are not what they were
      move(with_radii);
      // From one place near its start to another; or told nothing, which is to be found out then.
      candidates_.add_motion(rng_.chance(0.5) ? 2.001 * half_ : std::numeric_limits<double>::infinity());
      require(candidates_.update(crowd_.store, with_radii), "step %d: motion within the skin is refused", step);
      require(candidates_.kept() && candidates_.moved(), "not moved");
      if (step == ascend_at) check_ascending();
      check_interacting();
    }
    check_too_far();
    return crowd_.index.chunked;
  }

 private:
  // Where the index has the particles, with radii for the true reach; then its images.
  void check_points() {
    const hg::Index &index = crowd_.index;
    const hg::Interaction &interaction = crowd_.overlap.interaction();
    const double share = interaction.kind == HG_CONTACT ? 0.5 * interaction.margin : interaction.margin;
    const size_t count = crowd_.store.slots();
    for (size_t p = 0; p < count + index.image_count(); p++) {
      const hg::PointStore &from = p < count ? index.particles : index.images;
      const size_t at = p < count ? p : p - count;
      require(candidates_.slots()[p] == from.slot[at], "point %zu is of another particle", p);
      if (candidates_.direct()) continue;
      const hg::Point &point = candidates_.points()[p];
      require(point.x == from.x[at] && point.y == from.y[at], "point %zu is elsewhere", p);
      require(point.z == (index.domain.dimension == 3 ? from.z[at] : 0), "point %zu is elsewhere in z", p);
      const double radius = (crowd_.store.radius(from.slot[at]) + share) * index.map.scale;
      require(std::fabs(static_cast<double>(point.radius) - radius) <= 0x1p-23 * radius, "radius of point %zu", p);
    }
  }

  // All pairs nearer than the reach with the skin, none twice, and none much farther.
  void check_collected() {
    hg_grid_def wide = crowd_.rule();
    wide.margin = crowd_.index.interaction.margin;
    Pairs found;
    for (size_t k = 0; k < candidates_.count(); k++) {
      const hg_pair pair = stored_.slots_of(candidates_.pairs()[k]);
      const Sphere a = particle(crowd_, static_cast<size_t>(pair.a)), b = particle(crowd_, static_cast<size_t>(pair.b));
      const double reach = crowd_.index.interaction.reach(a.radius, b.radius) * crowd_.index.map.scale;
      require(relative_gap(wide, a, b) * reach < 64 + 1e-5 * reach, "candidate %zu is far beyond the skin", k);
      found.push_back(pair);
    }
    found = sorted(found.data(), found.size());
    require(std::adjacent_find(found.begin(), found.end(), pair_equal) == found.end(), "a candidate came twice");
    const Pairs expected = all_pairs(wide, crowd_.particles, exact_interact);
    require(std::includes(found.begin(), found.end(), expected.begin(), expected.end(), pair_less),
            "of %zu pairs within the skin some are missing", expected.size());
  }

  // The same candidates, in the order of their particles.
  void check_ascending() {
    const auto candidates = [&] { return Pairs(candidates_.pairs(), candidates_.pairs() + candidates_.count()); };
    const Pairs before = candidates();
    candidates_.ascend(order_);
    Pairs after = candidates();
    require(candidates_.ascending() && candidates_.kept() && candidates_.moved(), "not ascending");
    Pairs slots;
    for (const hg_pair &pair : after) slots.push_back(stored_.slots_of(pair));
    require_pairs("order of candidates", slots, sorted(slots.data(), slots.size()));
    require_pairs("ascending candidates", sorted(after.data(), after.size()), sorted(before.data(), before.size()));
    candidates_.ascend(order_);
    require_pairs("ascending again", candidates(), after);
  }

  void check_interacting() {
    const Pairs found = stored_.filtered();
    require_pairs("filtered", candidates_.ascending() ? found : sorted(found.data(), found.size()), crowd_.pairs());
    require_pairs("one by one", stored_.decided(), found);
    for (int n = 0; n < 10; n++) check_sphere();
  }

  // A ball anywhere meets each particle through some image or not at all.
  void check_sphere() {
    double center[3];
    for (double &x : center) x = Crowd::kEdge * rng_.uniform(-2, 3);
    const Sphere sphere{center, 40 * rng_.uniform() * rng_.uniform()};
    for (size_t p = 0; p < crowd_.store.slots(); p++) {
      const size_t slot = candidates_.slots()[p];
      bool met = false;
      for (Image image = 0; image < near_.count(); image++) {
        if (!is_possible(near_[image])) continue;
        const hg::Shift seen = near_[image] + candidates_.boxes(p, crowd_.store) - crowd_.index.domain.boxes(center);
        int64_t exact = 0;
        met = met || crowd_.overlap.holds({center, sphere.radius}, crowd_.store.ball(slot), seen, exact);
      }
      require(met == (exact_interact(crowd_.rule(), sphere, particle(crowd_, slot)) > 0), "a sphere meets slot %zu: %d",
              slot, met);
    }
  }
  bool is_possible(const hg::Shift &shift) const {
    for (int axis = 0; axis < 3; axis++) {
      if (shift.n[axis] != 0 && !crowd_.index.domain.periodic[axis]) return false;
    }
    return true;
  }

  // Each particle to within half the skin from its start, its growth taken in; some boxes away where there are periods.
  void move(bool with_radii) {
    // Radii as floats are off by 2^-21 of themselves, which counts as growth.
    const double half = with_radii ? half_ - 0x1p-20 * Crowd::kEdge : half_, share = rng_.uniform();
    for (size_t i = 0; i < start_.count(); i++) {
      const double growth = with_radii ? half * rng_.uniform(-1, 1) * share : 0;
      put(i, half - std::max(0.0, growth));
      crowd_.particles.radii[i] = std::max(0.0, start_.radii[i] + growth);
    }
    crowd_.move();
  }

  // So far from its start: along an axis, as far as is allowed, or anywhere within.
  void put(size_t i, double most) {
    const auto dimension = static_cast<size_t>(shape_.dimension);
    const size_t only = rng_.below(dimension);
    const bool along_axis = rng_.chance(0.3);
    const hg::Shift boxes = any_shift(rng_, crowd_.index.domain, 3);
    for (size_t axis = 0; axis < dimension; axis++) {
      double step = most * rng_.uniform(-1, 1) / std::sqrt(3);
      if (along_axis) step = axis != only ? 0 : (rng_.chance(0.5) ? most : -most);
      step += crowd_.index.domain.shifted(static_cast<int>(axis), boxes);
      crowd_.particles.centers[i * dimension + axis] = start_.centers[i * dimension + axis] + step;
    }
  }

  // By 2^32 quanta, which coordinates that wrap cannot tell from nothing, unless these are about as many whole boxes.
  double jump() const {
    const double length = 0x1p32 / crowd_.index.map.scale;
    const double left = shape_.periodic ? std::fabs(std::remainder(length, Crowd::kEdge)) : length;
    return left > shape_.skin ? length : 0;
  }

  // One particle has moved or grown by half the skin and a little more, or jumped.
  void check_too_far() {
    const bool by_growth = rng_.chance(0.5), by_jump = !by_growth && rng_.chance(0.5);
    const double more = by_jump && jump() > 0 ? jump() : 0.5 * shape_.skin + 20 / crowd_.index.map.scale;
    const size_t who = rng_.below(start_.count());
    crowd_.particles = start_;
    if (by_growth) {
      crowd_.particles.radii[who] += more;
    } else {
      crowd_.particles.centers[who * static_cast<size_t>(shape_.dimension)] += more;
    }
    crowd_.move();
    require(!candidates_.update(crowd_.store, true), "motion beyond the skin is allowed");
    require(!candidates_.kept() && !candidates_.moved() && candidates_.count() == 0, "candidates of no use are kept");
    crowd_.particles = start_;
    crowd_.move();
    require(!candidates_.update(crowd_.store, true), "candidates that were given up came back");
    require(stored_.collect() && candidates_.kept() && !candidates_.ascending(), "not collected anew");
    candidates_.drop();
    require(!candidates_.kept() && candidates_.count() == 0, "dropped candidates are kept");
  }

  Rng rng_;
  CrowdShape shape_;
  Stored stored_;
  Crowd &crowd_;
  hg::StoredCandidates &candidates_;
  hg::PairOrder order_{stored_.memory};
  hg::ShiftTable near_{stored_.memory};  // by which a particle may come near a sphere
  Particles start_;
  double half_;  // that a particle may surely move
};

void any_motion(void **) {
  int in_chunks = 0;
  assert_true(sweep(300, [&](uint64_t seed) { in_chunks += Run(seed).check() ? 1 : 0; }));
  assert_true(in_chunks > 40);
}

// A particle that has left through some faces sees images as from the box that it is in now.
void check_leaving(uint64_t seed) {
  Rng rng(seed);
  CrowdShape shape;
  shape.dimension = rng.integer(2, 3);
  shape.periodic = true;
  if (rng.chance(0.5)) shape.tilt[0] = rng.uniform(-2, 2);
  if (shape.dimension == 3 && rng.chance(0.5)) shape.tilt[2] = rng.uniform(-2, 2);
  shape.filling = rng.chance(0.5) ? Filling::kEven : Filling::kCorner;
  shape.count = 1 + rng.below(shape.filling == Filling::kEven ? 20 : 150);
  shape.skin = 4;
  Stored stored(seed, shape);
  const auto dimension = static_cast<size_t>(shape.dimension);
  const size_t who = rng.below(shape.count);
  double *center = &stored.crowd.particles.centers[who * dimension];
  int boxes[3] = {0, 0, 0};
  for (size_t axis = 0; axis < dimension; axis++) {
    boxes[axis] = rng.integer(-1, 1);
    center[axis] = boxes[axis] == 0 ? 50 : (boxes[axis] > 0 ? Crowd::kEdge - 0.5 : 0.5);
  }
  stored.crowd.move();
  stored.crowd.build(1);
  require(stored.collect(), "nothing was kept");
  const hg::Shift caller = any_shift(rng, stored.crowd.index.domain, 2);
  for (size_t axis = 0; axis < dimension; axis++) {
    center[axis] += boxes[axis] + stored.crowd.index.domain.shifted(static_cast<int>(axis), caller);
  }
  stored.crowd.move();
  require(stored.candidates.update(stored.crowd.store, false), "motion within the skin is refused");
  size_t p = 0;
  while (stored.candidates.slots()[p] != who) p++;
  const hg::Shift found = stored.candidates.boxes(p, stored.crowd.store);
  for (size_t axis = 0; axis < dimension; axis++) {
    require(found.n[axis] == caller.n[axis], "axis %zu: %d boxes instead of %d", axis, found.n[axis], caller.n[axis]);
  }
}

void leaving_the_box(void **) { assert_true(sweep(100, check_leaving)); }

// In heaps of coincident particles all are candidates of each other.
void make_heaps(Crowd &crowd, size_t heap, int threads) {
  for (size_t i = 0; i < crowd.particles.count(); i++) {
    const size_t heap_number = i / heap;
    const double place = 1 + 2 * static_cast<double>(heap_number);
    for (size_t axis = 0; axis < 3; axis++) {
      crowd.particles.centers[3 * i + axis] = axis == 0 ? place : 50;
    }
    crowd.particles.radii[i] = 0.25;
  }
  crowd.move();
  crowd.build(threads);
}

// Coordinates do not tell where giants are from each other, nor squeezed places where a particle has moved.
void check_untold(uint64_t seed) {
  Rng rng(seed);
  hg::Memory memory(hg::system_allocator());
  const bool giants = seed % 2 == 0;
  Particles particles;
  for (int i = 0; i < 200; i++) {
    double center[3];
    for (double &x : center) x = rng.uniform(0, 1) + (!giants && i % 2 == 0 ? 1e18 : 0);
    particles.add(center, giants && i == 0 ? 1e6 : 0.1);
  }
  Crowd crowd(memory, open_space(3), {}, 0.01, particles, 1e6);
  require(giants ? crowd.index.chunks.has_giants() : crowd.index.squeezed.in_use(), "no such index");
  hg::PairPool pool(memory, 1);
  hg::StoredCandidates candidates(memory, 1);
  hg::SearchCounts counts;
  require(!candidates.collect(crowd.index, crowd.tasks, crowd.store, {}, pool, counts), "candidates are kept");
  require(!candidates.kept() && candidates.count() == 0 && !candidates.update(crowd.store, false), "kept after all");
}

void untold_motion(void **) { assert_true(sweep(10, check_untold)); }

// 256 for each particle are kept, not one more.
void check_too_many(uint64_t) {
  const size_t most = 2 * hg::kMostCandidatesPerParticle + 1;
  for (const size_t count : {most, most + 1}) {
    CrowdShape shape;
    shape.count = count;
    shape.skin = 0.5;
    Stored stored(1, shape);
    make_heaps(stored.crowd, count, 1);
    require(stored.collect() == (count == most), "%zu particles in a heap: kept %d", count, stored.candidates.kept());
    require(stored.candidates.count() == (count == most ? count * (count - 1) / 2 : 0), "%zu candidates",
            stored.candidates.count());
  }
}

// Threads share the work where there are many particles: the same candidates and points in the same order.
void check_threads(uint64_t seed) {
  Rng rng(seed);
  CrowdShape shape = any_shape(rng, 21000);
  shape.filling = seed % 2 == 0 ? Filling::kEven : Filling::kCorner;
  const double step_length = seed % 2 == 0 ? 0.05 : 0.005;
  shape.skin = 10 * step_length;
  Stored alone(seed, shape), together(seed, shape, 3);
  require(alone.collect() && together.collect(), "nothing was kept");
  require(alone.crowd.index.chunked == (shape.filling == Filling::kCorner), "chunks: %d", alone.crowd.index.chunked);
  for (int step = 0; step < 2; step++) {
    const size_t count = alone.candidates.count(), points = alone.crowd.store.slots() + alone.crowd.index.image_count();
    require(count > 40000 && together.candidates.count() == count, "%zu candidates instead of %zu",
            together.candidates.count(), count);
    require(std::memcmp(alone.candidates.pairs(), together.candidates.pairs(), count * sizeof(hg_pair)) == 0,
            "other candidates, or another order");
    require(alone.candidates.direct() ||
                std::memcmp(alone.candidates.points(), together.candidates.points(), points * sizeof(hg::Point)) == 0,
            "other points");
    require_pairs("alone", alone.filtered(), alone.decided());
    require_pairs("together", together.filtered(), alone.decided());
    for (Stored *stored : {&alone, &together}) {
      hg::PairOrder order(stored->memory);
      stored->candidates.ascend(order);
      for (double &x : stored->crowd.particles.centers) x += step_length * std::sin(1000 * x);
      stored->crowd.move();
      stored->candidates.add_motion(std::numeric_limits<double>::infinity());
      require(stored->candidates.update(stored->crowd.store, step == 1), "motion within the skin is refused");
    }
  }
  // The last one has gone too far.
  together.crowd.particles.centers.back() += 1;
  together.crowd.move();
  together.candidates.add_motion(1);
  require(!together.candidates.update(together.crowd.store, false), "motion beyond the skin is allowed");

  CrowdShape open;
  open.count = 21000;
  open.skin = 0.5;
  Stored heaps(seed, open, 3);
  make_heaps(heaps.crowd, 600, 3);
  require(!heaps.collect() && !heaps.candidates.kept(), "too many candidates are kept");
}

void too_many(void **) { assert_true(holds(0, check_too_many)); }
void threads(void **) { assert_true(sweep(4, check_threads)); }

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(any_motion), cmocka_unit_test(leaving_the_box),
                              cmocka_unit_test(untold_motion), cmocka_unit_test(too_many), cmocka_unit_test(threads)};
  return cmocka_run_group_tests_name("stored_candidates", tests, nullptr, nullptr);
}
