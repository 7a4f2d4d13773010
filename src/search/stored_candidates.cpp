// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
#include "src/search/stored_candidates.hpp"

#include "src/base/parallel.hpp"
#include "src/kernels/kernel_sets.hpp"
#include "src/pairs/open_pairs.hpp"
#include "src/search/pair_search.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace hg {
namespace {

// More candidates than that cost more to keep and to filter than most searches.
constexpr size_t kMostPerParticle = 256;
// A skin of fewer quanta is eaten up by what the fixed-point places are off by.
constexpr double kLeastQuanta = 64;
// Two places are off by less than 6.08 quanta together, and what HG_DOUBLE computes across a box by 2.2 more.
constexpr double kPlaceError = 9;
// Covers the roundings of squares, sums and of the skin itself.
constexpr double kRoomScale = 1 - 0x1p-20;

constexpr size_t kFilterTask = 16384;  // candidates
constexpr size_t kFollowTask = 8192;   // particles

// The share of all pairs of evenly spread points that are nearer than the skin, or less.
double share_within(double skin, const Bounds &bounds, int dimension) {
  double share = 1;
  for (int k = 0; k < dimension; k++) share *= std::min(1.0, skin / bounds.width[k]);
  return share;
}

}  // namespace

double usable_skin(double wanted, const Interaction &interaction, const Domain &domain, const Bounds &bounds,
                   int32_t accuracy, size_t particles) {
  double extent = 0;
  for (int k = 0; k < domain.dimension; k++) extent = std::max(extent, bounds.max[k] - bounds.min[k]);
  double skin = std::min(wanted, extent);
  for (int k = 0; k < domain.dimension; k++) {
    if (!domain.periodic[k]) continue;
    // The wider reach, too, must meet one image of a particle at most.
    skin = std::min(skin, 0.5 * domain.length[k] * (1 - 0x1p-40) - interaction.diameter(bounds.max_radius));
  }
  const Interaction wide = interaction.widened(skin);
  const double reach = wide.diameter(bounds.max_radius);
  if (!(skin > 0 && reach <= 0.5 * std::numeric_limits<double>::max())) return 0;
  const double scale = Frame::over(bounds, domain, reach).scale;
  if ((wide.margin - interaction.margin) * scale < kLeastQuanta) return 0;
  if (!plain_squares_are_clear(accuracy, scale, reach)) return 0;
  const double expected = 0.5 * static_cast<double>(particles) * share_within(skin, bounds, domain.dimension);
  return expected <= static_cast<double>(kMostPerParticle) ? skin : 0;
}

StoredCandidates::StoredCandidates(Memory &memory, int threads)
    : threads_(threads), list_(memory), points_(memory), slot_(memory), owner_(memory), place_(memory) {}

bool StoredCandidates::collect(const Index &index, const ParticleStore &store, const Interaction &interaction,
                               PairWorkers &workers, SearchCounts &counts) {
  kept_ = moved_ = false;
  particles_ = store.slots();
  image_count_ = index.level_count > 0 ? index.levels[index.level_count - 1].image_end : 0;
  if (particles_ + image_count_ > static_cast<size_t>(std::numeric_limits<int32_t>::max())) return false;
  index_ = &index;
  interaction_ = interaction;
  const double skin = index.interaction.margin - interaction.margin;
  room_ = static_cast<float>((0.5 * skin * index.frame.scale - kPlaceError) * kRoomScale);

  slot_.require_room(particles_ + image_count_ + kPadding);
  for (size_t p = 0; p < particles_ + image_count_ + kPadding; p++) slot_[p] = static_cast<uint32_t>(p);
  const size_t most = kMostPerParticle * particles_;
  counts = list_.gather(CandidateSearch(index, store, slot_.data()), workers, particles_, most);
  if (list_.count() > most) return false;
  name_points();
  points_.require_room(particles_ + image_count_);
  place_particles(store);
  follow_images();
  kept_ = true;
  return true;
}

template <class Body>
void StoredCandidates::for_parts(Body &&body) {
  parallel_for(particles_ < kWorthThreads ? 1 : threads_, (particles_ + kFollowTask - 1) / kFollowTask,
               [&](size_t task, int) {
                 const size_t begin = task * kFollowTask;
                 body(begin, std::min(particles_, begin + kFollowTask));
               });
}

// Where the index has them, with radii folded for the true reach.
void StoredCandidates::place_particles(const ParticleStore &store) {
  const PointStore &from = index_->particles;
  const bool flat = index_->domain.dimension == 2;
  const double extra = interaction_.folded_radius(0), scale = index_->frame.scale;
  for_parts([&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; p++) {
      const auto radius = static_cast<float>((store.radius(slot_[p]) + extra) * scale);
      points_[p] = {from.x[p], from.y[p], flat ? 0 : from.z[p], radius};
    }
  });
}

// Names were their own numbers while collecting; from now on they are looked up to find slots.
void StoredCandidates::name_points() {
  std::copy_n(index_->particles.slot.data(), particles_, slot_.data());
  if (image_count_ == 0) return;
  std::copy_n(index_->images.slot.data(), image_count_, slot_.data() + particles_);
  place_.require(particles_);
  owner_.require_room(image_count_);
  for (size_t p = 0; p < particles_; p++) place_[slot_[p]] = static_cast<uint32_t>(p);
  for (size_t m = 0; m < image_count_; m++) owner_[m] = place_[slot_[particles_ + m]];
}

bool StoredCandidates::follow(const ParticleStore &store, bool radii) {
  if (!kept_) return false;
  kept_ = follow_particles(store, radii);
  if (kept_) follow_images();
  moved_ = kept_;
  return kept_;
}

bool StoredCandidates::follow_particles(const ParticleStore &store, bool radii) {
  const Index &index = *index_;
  const Domain &domain = index.domain;
  FollowInput input{};
  input.centers = store.centers();
  input.radii = radii ? store.radii() : nullptr;
  input.slot = slot_.data();
  input.x[0] = index.particles.x.data();
  input.x[1] = index.particles.y.data();
  input.x[2] = index.particles.z.data();
  input.radius = index.particles.radius.data();
  input.scale = index.frame.scale;
  for (int k = 0; k < domain.dimension; k++) {
    input.half_origin[k] = index.frame.half_origin[k];
    input.box_min[k] = domain.box_min[k];
    input.length[k] = domain.periodic[k] ? domain.length[k] : 0;
    input.period[k] = index.frame.period[k];
  }
  input.extra_radius = interaction_.folded_radius(0);
  input.extra_wide_radius = index.interaction.folded_radius(0);
  input.room = room_;
  FollowKernel *kernel = active_kernels().steps.follow[domain.dimension - 2];
  std::atomic<bool> all_near{true};
  for_parts([&](size_t begin, size_t end) {
    if (!all_near.load(std::memory_order_relaxed)) return;
    if (!kernel(input, begin, end, points_.data())) all_near.store(false, std::memory_order_relaxed);
  });
  return all_near.load();
}

void StoredCandidates::follow_images() {
  const int32_t *period = index_->frame.period;
  for (size_t m = 0; m < image_count_; m++) {
    const Image image = index_->images.image[m];
    Record point = points_[owner_[m]];
    point.x += image_step(image, 0) * period[0];
    point.y += image_step(image, 1) * period[1];
    point.z += image_step(image, 2) * period[2];
    points_[particles_ + m] = point;
  }
}

// By how many box lengths, -1, 0 or 1, the particle lies outside.
void StoredCandidates::outside(size_t place, const ParticleStore &store, int *boxes) const {
  const Domain &domain = index_->domain;
  const Record &point = points_[place];
  const int32_t here[3] = {point.x, point.y, point.z};
  for (int k = 0; k < 3; k++) {
    boxes[k] = 0;
    if (!domain.periodic[k]) continue;
    const double x = store.center(slot_[place])[k];
    const int32_t inside = index_->frame.coordinate(k, domain.position(k, x));
    boxes[k] = static_cast<int>(std::nearbyint(static_cast<double>(here[k] - inside) / index_->frame.period[k]));
  }
}

bool StoredCandidates::see(size_t place, Image &image, const ParticleStore &store) const {
  const int none[3] = {0, 0, 0};
  return see_from(none, place, image, store);
}

bool StoredCandidates::see_from(const int *ball_outside, size_t place, Image &image, const ParticleStore &store) const {
  int boxes[3];
  outside(place, store, boxes);
  for (int k = 0; k < 3; k++) {
    boxes[k] = image_step(image, k) + ball_outside[k] - boxes[k];
    if (boxes[k] < -1 || boxes[k] > 1) return false;
  }
  image = make_image(boxes[0], boxes[1], boxes[2]);
  return true;
}

// An image is always the larger number.
bool StoredCandidates::interact(uint32_t a, uint32_t b, const ParticleStore &store, const Overlap &overlap,
                                int64_t &exact) const {
  Image image = b < particles_ ? kNoImage : index_->images.image[b - particles_];
  if (moved_ && index_->domain.any_periodic) {
    int boxes[3];
    outside(b < particles_ ? b : owner_[b - particles_], store, boxes);
    if (!see_from(boxes, a, image, store)) return false;
  }
  return overlap.test(store.ball(slot_[b]), store.ball(slot_[a]), image, exact);
}

// ---- filter

size_t CandidateFilter::task_count() const { return (candidates_.count() + kFilterTask - 1) / kFilterTask; }

void CandidateFilter::prepare(PairSink &sink) const {
  sink.settle = [](PairSink *s) {
    const auto &self = *static_cast<const CandidateFilter *>(s->overlap);
    settle_open(*s, [&](const OpenPair &open) {
      return self.candidates_.interact(open.slot_a, open.slot_b, self.store_, self.overlap_, s->exact_count);
    });
  };
  sink.overlap = this;
  sink.store = nullptr;
  sink.centers = store_.centers();
  sink.radii = store_.radii();
  sink.dimension = static_cast<uint32_t>(candidates_.index_->domain.dimension);
  sink.id_offset = store_.id_offset();
  sink.band_constant = kBandConstant;
}

bool CandidateFilter::run(size_t task, PairSink &sink) const {
  const size_t first = task * kFilterTask;
  const FilterInput input{candidates_.points_.data(), candidates_.slot_.data(), candidates_.list_.data() + first,
                          std::min(kFilterTask, candidates_.count() - first)};
  const bool go_on = active_kernels().steps.filter[candidates_.index_->interaction.kind](input, &sink);
  sink.settle(&sink);
  return go_on;
}

}  // namespace hg
