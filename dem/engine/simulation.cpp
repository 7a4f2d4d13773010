// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine of one dimension and precision: the order of work within a step.
#include "dem/engine/simulation.hpp"

#include "dem/base/error.hpp"
#include "dem/base/parallel.hpp"
#include "dem/engine/snapshots.hpp"
#include "dem/setup/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

namespace dem {
namespace {

// Ways can be told from places unless particles are put into the box or grow.
bool goes_straight(const Setup &setup) { return !has(setup.effects, kShear | kGrowth); }

}  // namespace

template <int D, class Real>
Simulation<D, Real>::Simulation(const Setup &setup, std::vector<uint32_t> places)
    : setup_(without_particles(setup)),
      places_(std::move(places)),
      threads_(hg::usable_threads(setup.threads)),
      boundary_(make_boundary<D, Real>(setup)),
      body_force_(make_body_force<D, Real>(setup)),
      pair_laws_(setup, Partner::kParticle),
      wall_laws_(setup, Partner::kWall),
      batch_filler_(find_batch_filler<D, Real>(setup.effects)),
      rough_kernels_(find_rough_kernels<D, Real>(setup.effects)),
      pair_kernel_(find_pair_kernel<D, Real>(setup.effects)),
      wall_kernel_(find_wall_kernel<D, Real>(setup.effects)),
      motion_kernel_(find_motion_kernel<D, Real>(setup.effects)),
      slack_(rounding_slack<Real>(setup)),
      search_(setup, slack_),
      room_(search_.skin() / 2, goes_straight(setup)),
      pair_history_(setup.effects),
      wall_history_(setup.effects),
      surfaces_(setup),
      surface_history_(setup.effects),
      exchange_(setup),
      fastest_allowed_(dem::fastest_allowed(setup)),
      steps_(setup.beginning.step) {
  load_bodies(setup);
  load_history(setup.beginning);
  if (surfaces_.empty()) return;
  if (!std::is_same_v<Real, double>) throw Error("[[wall]] goes with double numbers only");
  surface_kernel_ = find_surface_kernel<D>(setup.effects);
}

// Where contacts get shorter with speed, too fast particles stop the run: what followed would be wrong in silence.
template <int D, class Real>
void Simulation<D, Real>::require_speed() const {
  for (size_t i = 0; i < bodies_.count(); i++) {
    const double approach = 2 * static_cast<double>(bodies_.velocity(i).norm());
    if (approach <= fastest_allowed_) continue;
    throw Error("at step " + std::to_string(steps_) + " " + speed_fault(setup_, approach, fastest_allowed_));
  }
}

template <int D, class Real>
void Simulation<D, Real>::load_bodies(const Setup &setup) {
  bodies_.resize(setup.count(), setup.effects);
  const auto lead = static_cast<Real>(setup.scheme.shared_drift * setup.time_step);
  for (size_t i = 0; i < setup.count(); i++) {
    set_body(setup, i, bodies_, i);
    bodies_.position(i) += lead * bodies_.velocity(i);
  }
}

template <int D, class Real>
void Simulation<D, Real>::load_history(const Beginning &beginning) {
  pair_history_.begin(renumbered_pairs(beginning.pairs, places_));
  wall_history_.begin(renumbered_walls(beginning.walls, places_));
  if (!surfaces_.empty()) surface_history_.begin(renumbered_walls(surfaces_.taken_over(beginning), places_));
}

// Who could reach a wall after moving and growing so far.
template <int D, class Real>
void Simulation<D, Real>::list_walls(double within) {
  walls_.clear();
  if (!has(setup_.effects, kWalls)) return;
  const WallReach<D, Real> reach(boundary_, static_cast<Real>(contact_range(setup_) + within));
  reach.list_all(bodies_, bodies_.count(), walls_);
}

template <int D, class Real>
void Simulation<D, Real>::run(uint64_t steps) {
  constexpr uint64_t kStepsPerLook = 16;
  for (; steps > 0; steps--) {
    if (fastest_allowed_ < kInfinity && steps_ % kStepsPerLook == 0) require_speed();
    if (exchange_.is_due(steps_)) exchange();
    for (size_t k = 0; k < setup_.scheme.stages.size(); k++) {
      find_forces();
      Stage stage = setup_.scheme.stages[k];
      if (steps_since_beginning() == 0 && k == 0) stage.kick -= setup_.scheme.shared_kick;
      if (counts_work_) tally(stage.kick * setup_.time_step);
      advance(stage);
    }
    steps_++;
    if (has(setup_.effects, kShear)) cross_sheared_faces();
  }
}

template <int D, class Real>
double Simulation<D, Real>::image_offset() const {
  if (!has(setup_.effects, kShear)) return 0;
  const double height = setup_.box_max[1] - setup_.box_min[1], length = setup_.box_max[0] - setup_.box_min[0];
  const double passed = since_beginning() + setup_.scheme.shared_drift * setup_.time_step;
  return std::fmod(setup_.beginning.image_offset + setup_.shear_rate * height * passed, length);
}

template <int D, class Real>
bool Simulation<D, Real>::lists_hold() {
  if (!surfaces_.empty()) {
    surfaces_.move_to(since_beginning());
    if (!surfaces_.hold(search_.skin() / 2)) return false;
  }
  return room_.holds(bodies_, threads_);
}

template <int D, class Real>
void Simulation<D, Real>::find_pairs() {
  boundary_.offset = static_cast<Real>(image_offset());
  if (lists_hold()) return;
  pair_history_.pack(pairs_);
  wall_history_.pack(walls());
  if (!surfaces_.empty()) surface_history_.pack(surfaces_.pairs());
  constexpr int32_t kType = sizeof(Real) == sizeof(double) ? HG_REAL64 : HG_REAL32;
  const auto column = [&](size_t k) {
    return hg_array{&bodies_.places.data()->numbers[k], sizeof(Row<Real>), kType, 0};
  };
  const hg_array centers[3] = {column(0), column(1), column(2)}, radius = column(3);
  pairs_ = search_.find(bodies_.count(), centers, radii_new_ ? &radius : nullptr, image_offset());
  radii_new_ = false;
  list_walls(search_.skin() / 2 + slack_);
  if constexpr (std::is_same_v<Real, double>) {
    if (!surfaces_.empty()) surfaces_.list(bodies_, search_, contact_range(setup_) + slack_, search_.skin() / 2);
  }
  share_out(bodies_.count(), threads_, pairs_, walls(), surfaces_.pairs(), shares_);
  std::vector<ListPart> of_walls, of_surfaces, of_pairs;
  for (const Share &share : shares_.of_thread) {
    of_walls.push_back({share.first_wall, share.last_wall, nullptr});
    of_surfaces.push_back({share.first_surface, share.last_surface, nullptr});
    of_pairs.push_back({share.first_pair, share.last_pair, nullptr});
    of_pairs.push_back({share.first_incoming, share.last_incoming, shares_.places.data()});
  }
  wall_history_.unpack(walls(), of_walls);
  if (!surfaces_.empty()) surface_history_.unpack(surfaces_.pairs(), of_surfaces);
  pair_history_.unpack(pairs_, of_pairs);
  room_.renew(bodies_);
}

template <int D, class Real>
void Simulation<D, Real>::find_surface_forces(size_t thread) {
  if constexpr (std::is_same_v<Real, double>) {
    const Share &share = shares_.of_thread[thread];
    const SurfaceTask<D> task{&bodies_,           &surfaces_,  wall_laws_.all().data(),
                              wall_laws_.width(), last_drift_, contact_range(setup_)};
    surface_kernel_(task, share.first_surface, share.last_surface, surface_history_.part(thread));
  }
}

// Walls first, then pairs in ascending order: a particle's sum is the same for any number of threads.
template <int D, class Real>
void Simulation<D, Real>::find_forces() {
  if (forces_known_) return;
  find_pairs();
  const ContactTask<D, Real> of_walls = task_of(wall_laws_), of_pairs = task_of(pair_laws_);
  std::vector<size_t> found(shares_.of_thread.size());
  const bool has_surfaces = !surfaces_.empty();
  if (has_surfaces) surfaces_.clear_pushes();
  in_parts(threads_, shares_.of_thread.size(), [&](int, size_t first, size_t last) {
    for (size_t k = first; k < last; k++) {
      const Share &share = shares_.of_thread[k];
      const size_t low = share.first_body, high = share.last_body;
      if (has_surfaces) find_surface_forces(k);
      wall_kernel_(of_walls, {walls_.data(), share.first_wall, share.last_wall, low, high, wall_history_.part(k)});
      pair_kernel_(of_pairs, {shares_.incoming.data(), share.first_incoming, share.last_incoming, low, high,
                              pair_history_.part(2 * k + 1)});
      found[k] = pair_kernel_(of_pairs,
                              {pairs_.data(), share.first_pair, share.last_pair, low, high, pair_history_.part(2 * k)});
    }
  });
  if (has_surfaces) surfaces_.sum_up();
  pair_count_ = std::accumulate(found.begin(), found.end(), size_t{0});
  forces_known_ = true;
}

template <int D, class Real>
ContactTask<D, Real> Simulation<D, Real>::task_of(const LawTable<Real> &laws) {
  return {&bodies_,
          &boundary_,
          laws.all().data(),
          laws.width(),
          static_cast<Real>(last_drift_),
          static_cast<Real>(contact_range(setup_)),
          batch_filler_,
          rough_kernels_};
}

template <int D, class Real>
void Simulation<D, Real>::advance(const Stage &stage) {
  const double kick = stage.kick * setup_.time_step;
  last_drift_ = stage.drift * setup_.time_step;
  const MotionTask<D, Real> task{&bodies_, body_force_, static_cast<Real>(kick), static_cast<Real>(last_drift_)};
  std::vector<double> speeds(static_cast<size_t>(threads_));
  in_parts(threads_, bodies_.count(), [&](int part, size_t first, size_t last) {
    speeds[static_cast<size_t>(part)] = static_cast<double>(motion_kernel_(task, first, last));
  });
  double fastest = 0;
  for (const double speed : speeds) fastest = speed <= fastest ? fastest : speed;
  double way = std::sqrt(fastest) * std::abs(last_drift_);
  // Images slide by as much again, which the two particles of a pair share.
  if (has(setup_.effects, kShear)) way += std::abs(static_cast<double>(boundary_.jump) * last_drift_) / 2;
  if (has(setup_.effects, kGrowth)) way += grow();
  room_.spend(way);
  if (!surfaces_.empty()) surfaces_.press(last_drift_);
  forces_known_ = false;
}

// Radii follow R (1 + rate t) up to the end of growth, at constant density. Returns by how much the largest has grown.
template <int D, class Real>
double Simulation<D, Real>::grow() {
  const auto scale = [this](uint64_t step) {
    const double time = std::min(static_cast<double>(step) * setup_.time_step, setup_.growth_end);
    return 1 + setup_.growth_rate * time;
  };
  const uint64_t done = steps_since_beginning();
  const double factor = scale(done + 1) / scale(done);
  if (factor == 1) return 0;
  const auto radius_factor = static_cast<Real>(factor), mass_factor = static_cast<Real>(std::pow(factor, -D));
  Real largest = 0;
  for (size_t i = 0; i < bodies_.count(); i++) {
    bodies_.radius(i) *= radius_factor;
    bodies_.inverse_mass(i) *= mass_factor;
    largest = std::max(largest, bodies_.radius(i));
  }
  radii_new_ = true;
  return static_cast<double>(largest) * (1 - 1 / factor);
}

// A particle that leaves through the upper face comes in through the lower one where its image is, and takes the
// image's velocity.
template <int D, class Real>
void Simulation<D, Real>::cross_sheared_faces() {
  const auto offset = static_cast<Real>(image_offset());
  for (size_t i = 0; i < bodies_.count(); i++) {
    auto x = bodies_.position(i);
    const Real crossed = std::floor((x[1] - boundary_.low[1]) * boundary_.inverse_period[1]);
    if (crossed != 0) {
      x[1] -= crossed * boundary_.period[1];
      x[0] -= crossed * offset;
      const Real speed = bodies_.velocity(i)[0];
      bodies_.velocity(i)[0] -= crossed * boundary_.jump;
      if (counts_work_ && bodies_.inverse_mass(i) > 0) {
        const Real faster = bodies_.velocity(i)[0];
        work_.input += 0.5 * static_cast<double>((faster - speed) * (faster + speed) / bodies_.inverse_mass(i));
      }
    }
    x[0] -= boundary_.period[0] * std::floor((x[0] - boundary_.low[0]) * boundary_.inverse_period[0]);
  }
}

template <int D, class Real>
size_t Simulation<D, Real>::state_bytes() const {
  return sizeof places_.front() * places_.size() + bodies_.bytes() + room_.bytes() + shares_.bytes() +
         pair_history_.bytes() + wall_history_.bytes() + sizeof(hg_pair) * walls_.capacity() +
         surface_history_.bytes() + surfaces_.bytes();
}

template class Simulation<2, double>;
template class Simulation<3, double>;
template class Simulation<2, float>;
template class Simulation<3, float>;

}  // namespace dem
