// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The engine of one dimension and precision: the order of work within a step.
#include "dem/engine/simulation.hpp"

#include "dem/base/error.hpp"
#include "dem/base/parallel.hpp"
#include "dem/setup/time_step.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

namespace dem {
namespace {

Setup without_particles(const Setup &setup) {
  Setup result = setup;
  static_cast<ParticleArrays &>(result) = {};
  return result;
}

}  // namespace

template <int D, class Real>
Simulation<D, Real>::Simulation(const Setup &setup, std::vector<uint32_t> places)
    : setup_(without_particles(setup)),
      places_(std::move(places)),
      threads_(usable_threads(setup.threads)),
      boundary_(make_boundary<D, Real>(setup)),
      body_force_(make_body_force<D, Real>(setup)),
      pair_law_(make_law<Real>(setup, Partner::kParticle)),
      wall_law_(make_law<Real>(setup, Partner::kWall)),
      pair_kernel_(find_pair_kernel<D, Real>(setup.effects)),
      wall_kernel_(find_wall_kernel<D, Real>(setup.effects)),
      motion_kernel_(find_motion_kernel<D, Real>(setup.effects)),
      search_(setup),
      walls_of_part_(static_cast<size_t>(threads_)),
      pair_history_(setup.effects),
      wall_history_(setup.effects),
      fastest_allowed_(dem::fastest_allowed(setup)) {
  load_bodies(setup);
  list_wall_contacts();
}

// Where contacts get shorter with speed, too fast particles stop the run: what followed would be wrong in silence.
template <int D, class Real>
void Simulation<D, Real>::require_speed() const {
  for (const Vec<D, Real> &velocity : bodies_.velocity) {
    const double approach = 2 * static_cast<double>(velocity.norm());
    if (approach <= fastest_allowed_) continue;
    throw Error("at step " + std::to_string(steps_) + " particles approach with " + text(approach) +
                ", and the time step " + text(setup_.time_step) + " is short enough for " + text(fastest_allowed_) +
                ": give an impact_speed of " + text(2 * approach) + ", or a shorter step");
  }
}

template <int D, class Real>
void Simulation<D, Real>::load_bodies(const Setup &setup) {
  bodies_.resize(setup.count(), setup.effects);
  const auto lead = static_cast<Real>(setup.scheme.shared_drift * setup.time_step);
  for (size_t i = 0; i < setup.count(); i++) {
    bodies_.velocity[i] = vector_at<Vec<D, double>>(setup.velocities, i).template cast<Real>();
    bodies_.position[i] = vector_at<Vec<D, double>>(setup.centers, i).template cast<Real>();
    bodies_.position[i] += lead * bodies_.velocity[i];
    bodies_.radius[i] = static_cast<Real>(setup.radii[i]);
    bodies_.inverse_mass[i] = static_cast<Real>(1 / setup.masses[i]);
    if (bodies_.spin.empty() || setup.spins.empty()) continue;
    bodies_.spin[i] = vector_at<Spin<D, double>>(setup.spins, i).template cast<Real>();
  }
}

template <int D, class Real>
Real Simulation<D, Real>::wall_range() const {
  return static_cast<Real>(contact_range(setup_));
}

template <int D, class Real>
void Simulation<D, Real>::list_wall_contacts() {
  wall_contacts_.clear();
  const WallReach<D, Real> reach(boundary_, wall_range());
  for (size_t i = 0; i < bodies_.count(); i++) {
    reach.list(bodies_.position[i], bodies_.radius[i], i, wall_contacts_);
  }
}

template <int D, class Real>
void Simulation<D, Real>::run(uint64_t steps) {
  constexpr uint64_t kStepsPerLook = 16;
  for (; steps > 0; steps--) {
    if (fastest_allowed_ < kInfinity && steps_ % kStepsPerLook == 0) require_speed();
    for (size_t k = 0; k < setup_.scheme.stages.size(); k++) {
      find_forces();
      Stage stage = setup_.scheme.stages[k];
      if (steps_ == 0 && k == 0) stage.kick -= setup_.scheme.shared_kick;
      advance(stage);
    }
    steps_++;
    if (has(setup_.effects, kShear)) cross_sheared_faces();
  }
}

template <int D, class Real>
double Simulation<D, Real>::position_time() const {
  return time() + setup_.scheme.shared_drift * setup_.time_step;
}

template <int D, class Real>
double Simulation<D, Real>::image_offset() const {
  if (!has(setup_.effects, kShear)) return 0;
  const double height = setup_.box_max[1] - setup_.box_min[1], length = setup_.box_max[0] - setup_.box_min[0];
  return std::fmod(setup_.shear_rate * height * position_time(), length);
}

template <int D, class Real>
const double *Simulation<D, Real>::centers() {
  if constexpr (std::is_same_v<Real, double>) {
    return bodies_.position.empty() ? nullptr : bodies_.position.front().data();
  } else {
    staged_centers_.resize(D * bodies_.count());
    const Real *numbers = bodies_.position.empty() ? nullptr : bodies_.position.front().data();
    std::copy(numbers, numbers + staged_centers_.size(), staged_centers_.begin());
    return staged_centers_.data();
  }
}

// Null if the library has them already.
template <int D, class Real>
const double *Simulation<D, Real>::radii() {
  if (!radii_new_) return nullptr;
  radii_new_ = false;
  if constexpr (std::is_same_v<Real, double>) {
    return bodies_.radius.data();
  } else {
    staged_radii_.assign(bodies_.radius.begin(), bodies_.radius.end());
    return staged_radii_.data();
  }
}

template <int D, class Real>
void Simulation<D, Real>::find_pairs() {
  if (pairs_known_) return;
  boundary_.offset = static_cast<Real>(image_offset());
  pairs_ = search_.find(centers(), radii(), image_offset());
  pair_history_.follow(pairs_);
  wall_history_.follow(walls());
  pairs_known_ = true;
}

template <int D, class Real>
void Simulation<D, Real>::find_forces() {
  if (forces_known_) return;
  find_pairs();
  wall_kernel_(task_of(wall_law_, walls(), wall_history_), 0, walls().size());
  find_pair_forces();
  forces_known_ = true;
}

template <int D, class Real>
ContactTask<D, Real> Simulation<D, Real>::task_of(const ContactLaw<Real> &law, PairView contacts,
                                                  ContactHistory<D, Real> &history) {
  return {&bodies_, &boundary_, &law, contacts.data(), {history.rows(), static_cast<Real>(last_drift_)}};
}

// On several threads the pairs' forces are computed first and then added up by runs of particles: each particle's sum
// goes through its pairs in the order of the list, as on one thread, and so is the same to the last bit.
template <int D, class Real>
void Simulation<D, Real>::find_pair_forces() {
  ContactTask<D, Real> task = task_of(pair_law_, pairs_, pair_history_);
  if (threads_ == 1) return pair_kernel_(task, 0, pairs_.size());
  pair_forces_.resize(pairs_.size());
  task.pairs = pair_forces_.data();
  in_parts(threads_, pairs_.size(), [&](int, size_t first, size_t last) { pair_kernel_(task, first, last); });
  in_parts(threads_, bodies_.count(), [&](int, size_t first, size_t last) {
    add_pair_forces(bodies_, pairs_.data(), pairs_.size(), pair_forces_.data(), first, last);
  });
}

template <int D, class Real>
void Simulation<D, Real>::advance(const Stage &stage) {
  const double kick = stage.kick * setup_.time_step;
  last_drift_ = stage.drift * setup_.time_step;
  const MotionTask<D, Real> task{
      &bodies_, &boundary_, body_force_, static_cast<Real>(kick), static_cast<Real>(last_drift_), wall_range()};
  for (std::vector<hg_pair> &part : walls_of_part_) part.clear();
  in_parts(threads_, bodies_.count(), [&](int part, size_t first, size_t last) {
    motion_kernel_(task, first, last, walls_of_part_[static_cast<size_t>(part)]);
  });
  wall_contacts_.swap(walls_of_part_.front());
  for (size_t part = 1; part < walls_of_part_.size(); part++) {
    wall_contacts_.insert(wall_contacts_.end(), walls_of_part_[part].begin(), walls_of_part_[part].end());
  }
  if (has(setup_.effects, kGrowth)) grow();
  forces_known_ = pairs_known_ = false;
}

// Radii follow R (1 + rate t) up to the end of growth, at constant density.
template <int D, class Real>
void Simulation<D, Real>::grow() {
  const auto scale = [this](uint64_t step) {
    const double time = std::min(static_cast<double>(step) * setup_.time_step, setup_.growth_end);
    return 1 + setup_.growth_rate * time;
  };
  const double factor = scale(steps_ + 1) / scale(steps_);
  if (factor == 1) return;
  const auto radius_factor = static_cast<Real>(factor), mass_factor = static_cast<Real>(std::pow(factor, -D));
  for (size_t i = 0; i < bodies_.count(); i++) {
    bodies_.radius[i] *= radius_factor;
    bodies_.inverse_mass[i] *= mass_factor;
  }
  radii_new_ = true;
  list_wall_contacts();
}

// A particle that leaves through the upper face comes in through the lower one where its image is, and takes the
// image's velocity.
template <int D, class Real>
void Simulation<D, Real>::cross_sheared_faces() {
  const auto offset = static_cast<Real>(image_offset());
  for (size_t i = 0; i < bodies_.count(); i++) {
    Vec<D, Real> &x = bodies_.position[i];
    const Real crossed = std::floor((x[1] - boundary_.low[1]) * boundary_.inverse_period[1]);
    if (crossed != 0) {
      x[1] -= crossed * boundary_.period[1];
      x[0] -= crossed * offset;
      bodies_.velocity[i][0] -= crossed * boundary_.jump;
    }
    x[0] -= boundary_.period[0] * std::floor((x[0] - boundary_.low[0]) * boundary_.inverse_period[0]);
  }
}

template <int D, class Real>
size_t Simulation<D, Real>::state_bytes() const {
  size_t bytes =
      sizeof places_.front() * places_.size() + bodies_.bytes() + pair_history_.bytes() + wall_history_.bytes();
  bytes += sizeof(PairForce<D, Real>) * pair_forces_.capacity();
  bytes += sizeof(double) * (staged_centers_.capacity() + staged_radii_.capacity());
  bytes += sizeof(hg_pair) * wall_contacts_.capacity();
  for (const std::vector<hg_pair> &part : walls_of_part_) bytes += sizeof(hg_pair) * part.capacity();
  return bytes;
}

template class Simulation<2, double>;
template class Simulation<3, double>;
template class Simulation<2, float>;
template class Simulation<3, float>;

}  // namespace dem
