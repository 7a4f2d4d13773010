// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/stored_candidates.hpp"

#include "src/base/parallel.hpp"
#include "src/exact/fast_test.hpp"
#include "src/search/pair_search.hpp"
#include "src/search/skin.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace hg {
namespace {

// Two places are off by less than 6.08 quanta together, and what HG_DOUBLE computes across a box by 2.2 more.
constexpr double kPlaceError = 9;
// A cell whose lengths change by more than this share is another one.
constexpr double kMostDeformed = 0x1p-4;
// Covers the roundings of squares, sums and of the skin itself.
constexpr double kRoomScale = 1 - 0x1p-20;

// The square of no reach up to that overflows.
constexpr double kMostReach = 1e150;

constexpr size_t kUpdateTask = 8192;  // particles

// The length of what one cell makes of a shift less what the other does, and what is rounded.
double change_of(const Shift &shift, const Domain &from, const Domain &to) {
  double change[3], size = 0;
  for (int axis = 0; axis < 3; axis++) {
    change[axis] = to.shifted(axis, shift) - from.shifted(axis, shift);
    size += to.shift_size(axis, shift) + from.shift_size(axis, shift);
  }
  return std::hypot(change[0], change[1], change[2]) * (1 + 0x1p-40) + 0x1p-48 * size;
}

float room_within(double skin, double scale) {
  return static_cast<float>((0.5 * skin * scale - kPlaceError) * kRoomScale);
}

// All pairs nearer than the reach that the index was made for, and some about as near. `points` are the numbers of all
// particles of the index, then of its images.
class CandidateSearch final : public PairSearch {
 public:
  CandidateSearch(const Index &index, const SearchTasks &tasks, const ParticleStore &store, const uint32_t *points)
      : PairSearch(index, tasks, store, wide_), points_(points), wide_(index.interaction, HG_FLOAT, index.domain) {}

  // Candidates need not be sure to interact: all that is undecided stays.
  PairJudge judge() const override {
    PairJudge judge = PairSearch::judge();
    judge.decide = [](PairStream *stream) {
      stream->undecided_total += stream->undecided_count;
      stream->undecided_count = 0;
    };
    judge.id_offset = 0;
    judge.band_constant = kBandConstant;
    return judge;
  }
  bool send(size_t task, PairStream &stream) const override {
    PointArrays particles = index_.particles.arrays(false), images = index_.images.arrays(true);
    particles.slot = points_;
    images.slot = points_ + index_.particle_count;
    return PairSearch::send(task, particles, images, stream);
  }

 private:
  const uint32_t *points_;
  Overlap wide_;
};

}  // namespace

StoredCandidates::StoredCandidates(Memory &memory, int threads)
    : threads_(threads),
      list_(memory),
      points_(memory),
      place_{Buffer<double>(memory), Buffer<double>(memory), Buffer<double>(memory)},
      slot_(memory),
      original_(memory),
      point_of_slot_(memory),
      image_candidates_(memory) {}

bool StoredCandidates::collect(const Index &index, const SearchTasks &tasks, const ParticleStore &store,
                               const Interaction &interaction, PairPool &pool, SearchCounts &counts) {
  kept_ = moved_ = ascending_ = false;
  particle_count_ = index.particle_count;
  slot_count_ = store.slots();
  image_count_ = index.image_count();
  const size_t count = particle_count_ + image_count_;
  if (count > static_cast<size_t>(std::numeric_limits<int32_t>::max())) return false;
  // Squeezed places say nothing of where a particle has moved, coordinates nothing of distances between giants.
  if (index.squeezed.in_use() || (index.chunked && index.chunks.has_giants())) return false;
  index_ = &index;
  interaction_ = interaction;
  collected_ = index.domain;
  skin_ = index.interaction.margin - interaction.margin;
  room_ = room_within(skin_, index.map.scale);

  // While collecting, each point stands for itself.
  slot_.require_room(count + kPadding);
  for (size_t p = 0; p < count + kPadding; p++) slot_[p] = static_cast<uint32_t>(p);
  const size_t most = kMostCandidatesPerParticle * particle_count_;
  counts = list_.gather(CandidateSearch(index, tasks, store, slot_.data()), pool, particle_count_, most);
  if (list_.count() > most) return false;
  set_slots();
  direct_ = may_be_direct(store);
  left_ = room_ * kRoomScale;
  if (direct_) {
    for (size_t k = 0; k < list_.count(); k++) list_.data()[k] = slots_of(list_.data()[k]);
  } else {
    points_.require_room(count);
  }
  set_points(store);
  if (!direct_) update_images();
  kept_ = true;
  return true;
}

// Doubles are in the caller's order. Where that does not follow space, a candidate fetches two centres and two radii
// from anywhere, and an update one centre for each particle.
bool StoredCandidates::may_be_direct(const ParticleStore &store) const {
  if (active_kernels().direct[0][0].pairs == nullptr || index_->domain.any_periodic) return false;
  if (!squares_are_safe(store.summary().radius)) return false;
  constexpr int64_t kFar = 4096;  // particles: what lies between is not in the nearer caches
  return 4 * list_.count() <= particle_count_ ||
         !jump_about(particle_count_, kFar, [this](size_t p) { return static_cast<int32_t>(slot_[p]); });
}

bool StoredCandidates::squares_are_safe(const Interval &radii) const {
  return interaction_.diameter(radii.greatest) <= kMostReach;
}

// Ways are summed in doubles, each rounded by less than kRoomScale takes off the room.
void StoredCandidates::add_motion(double distance) { left_ -= distance * index_->map.scale; }

template <class Body>
void StoredCandidates::for_parts(Body &&body) {
  parallel_for(particle_count_ < kWorthThreads ? 1 : threads_, (particle_count_ + kUpdateTask - 1) / kUpdateTask,
               [&](size_t task, int) {
                 const size_t begin = task * kUpdateTask;
                 body(begin, std::min(particle_count_, begin + kUpdateTask));
               });
}

void StoredCandidates::set_slots() {
  std::copy_n(index_->particles.slot.data(), particle_count_, slot_.data());
  if (image_count_ == 0) return;
  std::copy_n(index_->images.slot.data(), image_count_, slot_.data() + particle_count_);
  find_points_of_slots();
  original_.require_room(image_count_);
  for (size_t m = 0; m < image_count_; m++) original_[m] = point_of_slot_[slot_[particle_count_ + m]];
}

// Where the index has them, with radii folded for the true reach.
void StoredCandidates::set_points(const ParticleStore &store) {
  const PointStore &from = index_->particles;
  const bool flat = index_->domain.dimension == 2;
  const double extra = interaction_.folded_radius(0), scale = index_->map.scale;
  const int with_places = index_->chunked ? index_->domain.dimension : 0;
  for (int axis = 0; axis < with_places; axis++) place_[axis].require_room(particle_count_);
  for_parts([&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; p++) {
      if (!direct_) {
        const auto radius = static_cast<float>((store.radius(slot_[p]) + extra) * scale);
        points_[p] = {from.x[p], from.y[p], flat ? 0 : from.z[p], radius};
      }
      if (with_places == 0) continue;
      double quanta[3];
      index_->map.find_quanta(store.center(slot_[p]), with_places, quanta);
      for (int axis = 0; axis < with_places; axis++) place_[axis][p] = quanta[axis];
    }
  });
}

void StoredCandidates::find_points_of_slots() {
  point_of_slot_.require(slot_count_);
  for (size_t p = 0; p < particle_count_; p++) point_of_slot_[slot_[p]] = static_cast<uint32_t>(p);
}

// Candidates go through the order as slots. Slots tell which particles they are of; those of images are kept beside.
void StoredCandidates::ascend(PairOrder &order) {
  hg_pair *pairs = list_.data();
  const size_t count = list_.count();
  const auto first = [&](size_t k) { return direct_ ? pairs[k].a : slots_of(pairs[k]).a; };
  if (!kept_ || ascending_ || is_scattered(count, slot_count_, first)) return;
  kept_ = false;
  if (direct_) {
    order.ascend(pairs, count, slot_count_, 0);
    kept_ = ascending_ = true;
    return;
  }
  const size_t images = copy_image_candidates();
  for (size_t k = 0; k < count; k++) pairs[k] = slots_of(pairs[k]);
  order.ascend(pairs, count, slot_count_, 0);
  find_points_of_slots();
  slots_to_points(images);
  kept_ = ascending_ = true;
}

hg_pair StoredCandidates::slots_of(const hg_pair &candidate) const {
  const auto [a, b] = std::minmax(slot_[candidate.a], slot_[candidate.b]);
  return {static_cast<int32_t>(a), static_cast<int32_t>(b)};
}

// Returns how many there are.
size_t StoredCandidates::copy_image_candidates() {
  size_t count = 0;
  for (size_t k = 0; k < list_.count(); k++) {
    const hg_pair candidate = list_.data()[k];
    if (static_cast<size_t>(candidate.b) < particle_count_) continue;
    image_candidates_.grow(count + 1);
    image_candidates_[count++] = {slots_of(candidate), candidate};
  }
  std::sort(image_candidates_.data(), image_candidates_.data() + count,
            [](const ImageCandidate &p, const ImageCandidate &q) { return comes_first(p.slots, q.slots); });
  return count;
}

// Walks along both ascending lists, that of all and that of images.
void StoredCandidates::slots_to_points(size_t images) {
  size_t next = 0;
  for (size_t k = 0; k < list_.count(); k++) {
    hg_pair &pair = list_.data()[k];
    if (next < images && !comes_first(pair, image_candidates_[next].slots)) {
      pair = image_candidates_[next++].points;
    } else {
      const auto [a, b] = std::minmax(point_of_slot_[pair.a], point_of_slot_[pair.b]);
      pair = {static_cast<int32_t>(a), static_cast<int32_t>(b)};
    }
  }
}

bool StoredCandidates::update(const ParticleStore &store, bool radii) {
  if (!kept_) return false;
  if (direct_ && left_ > 0 && !radii) return moved_ = true;
  const bool unsafe = direct_ && radii && !squares_are_safe(store.summary().radius);
  kept_ = !unsafe && update_particles(store, radii);
  if (kept_ && !direct_) update_images();
  moved_ = kept_;
  return kept_;
}

bool StoredCandidates::update_particles(const ParticleStore &store, bool radii) {
  const PointStore &start = index_->particles;
  UpdateInput input{store.centers(),
                    radii ? store.radii() : nullptr,
                    store.summary().center,
                    slot_.data(),
                    {start.x.data(), start.y.data(), start.z.data()},
                    {nullptr, nullptr, nullptr},
                    start.radius.data(),
                    index_->map,
                    interaction_.folded_radius(0),
                    index_->interaction.folded_radius(0),
                    room_};
  for (int axis = 0; index_->chunked && axis < index_->domain.dimension; axis++) {
    input.place[axis] = place_[axis].data();
  }
  UpdateKernel *kernel = active_kernels().update[index_->domain.dimension - 2];
  std::atomic<float> least_left{room_};
  for_parts([&](size_t begin, size_t end) {
    float least = least_left.load(std::memory_order_relaxed);
    if (least < 0) return;
    const float left = kernel(input, begin, end, direct_ ? nullptr : points_.data());
    while (left < least && !least_left.compare_exchange_weak(least, left, std::memory_order_relaxed)) {
    }
  });
  left_ = least_left.load() * kRoomScale;
  return left_ >= 0;
}

void StoredCandidates::update_images() {
  const ShiftTable &shifts = index_->shifts;
  for (size_t m = 0; m < image_count_; m++) {
    const Image image = index_->images.image[m];
    Point point = points_[original_[m]];
    point.x = moved_by(point.x, 1, shifts.coordinate(image, 0));
    point.y = moved_by(point.y, 1, shifts.coordinate(image, 1));
    point.z = moved_by(point.z, 1, shifts.coordinate(image, 2));
    points_[particle_count_ + m] = point;
  }
}

double StoredCandidates::start_place(size_t p, int axis) const {
  return index_->chunked ? place_[axis][p] : index_->particles.column(axis)[p];
}

// Once particles have moved, they may lie outside the box: nearest to where they were.
Shift StoredCandidates::boxes(size_t p, const ParticleStore &store) const {
  const Domain &domain = index_->domain;
  const FixedPoint &map = index_->map;
  const double *center = store.center(slot_[p]);
  double place[3] = {0, 0, 0};
  const Shift boxes = domain.take_in(center, place);
  if (!moved_) return boxes;
  Shift back;
  for (int axis = 2; axis >= 0; axis--) {
    if (!domain.periodic[axis]) continue;
    const double here = map.quanta(axis, place[axis]) + domain.shifted(axis, back) * map.scale;
    back.n[axis] = static_cast<int32_t>(edges_back(here - start_place(p, axis), domain.length[axis] * map.scale));
  }
  return boxes - back;
}

// An image is always the larger number.
bool StoredCandidates::interact(uint32_t a, uint32_t b, const ParticleStore &store, const Overlap &overlap,
                                int64_t &exact) const {
  if (direct_) return overlap.is_pair(store.ball(b), store.ball(a), Shift{}, exact);
  const Ball ball_a = store.ball(slot_[a]), ball_b = store.ball(slot_[b]);
  const Domain &domain = index_->domain;
  if (!domain.any_periodic) return overlap.is_pair(ball_b, ball_a, Shift{}, exact);
  if (slot_[a] == slot_[b] && !domain.all_images) return false;
  const bool b_is_image = b >= particle_count_;
  const Shift step = index_->shifts[b_is_image ? index_->images.image[b - particle_count_] : kNoImage];
  const uint32_t original = b_is_image ? original_[b - particle_count_] : b;
  return overlap.is_pair(ball_b, ball_a, step + boxes(a, store) - boxes(original, store), exact);
}

// Two particles, one of them moved by whole edges, are farther apart by no more than what the new cell makes of these
// edges. Only shifts through which they may come within reach count. docs/theory/exactness.md, section 13.
bool StoredCandidates::keep_in(const Domain &domain) {
  if (!kept_) return false;
  const double reach = index_->largest_reach() + skin_;
  PlaceBox box, around;
  for (int axis = 0; axis < domain.dimension; axis++) {
    if (!domain.periodic[axis]) continue;
    const double before = collected_.length[axis], origin = collected_.box_min[axis];
    if (std::fabs(domain.length[axis] - before) > kMostDeformed * before) return false;
    if (std::fabs(domain.box_min[axis] - origin) > before) return false;
    box.low[axis] = -skin_;
    box.high[axis] = before + skin_;
    around.low[axis] = box.low[axis] - reach;
    around.high[axis] = box.high[axis] + reach;
  }
  double longer = 0;
  visit_shifts(domain, box, around,
               [&](const Shift &shift) { longer = std::max(longer, change_of(shift, collected_, domain)); });
  const double skin = skin_ - longer;
  if (!(skin * index_->map.scale >= kLeastQuanta)) return false;
  room_ = room_within(skin, index_->map.scale);
  left_ = 0;
  return true;
}

}  // namespace hg
