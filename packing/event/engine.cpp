// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The event loop: prediction, collisions, renewal of hulls, and the epochs in which time starts anew.
#include "packing/event/engine.hpp"

#include "packing/event/collision.hpp"
#include "particles/error.hpp"
#include "particles/text/number.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace packing::event {
namespace {

constexpr uint64_t kEventsPerPoll = 4096;
// Time stands still if so many collisions per particle pass without this share of the epoch.
constexpr uint64_t kStallCollisions = 100;
constexpr double kStallShare = 1e-9;
constexpr size_t kParticlesPerStray = 256;
constexpr size_t kLeastStrays = 16;

using particles::text;

void check_state(const Box &box, const State &state) {
  const size_t count = state.count();
  if (state.centers.size() != count || state.velocities.size() != count || state.masses.size() != count) {
    throw particles::Error("centres, velocities, radii and masses are not of one number");
  }
  if (!(state.scale >= 0) || !std::isfinite(state.scale)) throw particles::Error("scale " + text(state.scale));
  for (size_t i = 0; i < count; i++) {
    const std::string who = "particle " + std::to_string(i) + ": ";
    if (!(state.radii[i] > 0) || !std::isfinite(state.radii[i])) {
      throw particles::Error(who + "radius " + text(state.radii[i]));
    }
    if (!(state.masses[i] > 0) || !std::isfinite(state.masses[i])) {
      throw particles::Error(who + "mass " + text(state.masses[i]));
    }
    for (int axis = 0; axis < 3; axis++) {
      const double x = state.centers[i][axis], v = state.velocities[i][axis];
      if (!std::isfinite(x) || !std::isfinite(v)) {
        throw particles::Error(who + "centre or velocity is not finite on axis " + std::to_string(axis));
      }
      if (axis >= box.dimension() ? x != 0 || v != 0 : x < 0 || x > box.edge(axis)) {
        throw particles::Error(who + "lies at " + text(x) + " on axis " + std::to_string(axis) + ", outside the box");
      }
    }
  }
}

}  // namespace

double State::kinetic_energy() const {
  double sum = 0;
  for (size_t i = 0; i < count(); i++) sum += masses[i] * square(velocities[i]);
  return sum / 2;
}

Engine::Engine(const Box &box, State state)
    : box_(box),
      state_(std::move(state)),
      particles_(state_.count()),
      counts_(state_.count(), 0),
      events_(state_.count()),
      queue_(state_.count()),
      hulls_(box, state_.count()),
      skins_(box, state_.count()),
      most_strays_(std::max(kLeastStrays, state_.count() / kParticlesPerStray)) {
  check_state(box_, state_);
  for (Vector &center : state_.centers) box_.wrap(center);
}

void Engine::scale_velocities(double factor) {
  for (Vector &velocity : state_.velocities) velocity *= factor;
}

EpochEnd Engine::run(const Epoch &epoch, const std::function<bool()> &poll) {
  if (state_.count() == 0) return EpochEnd::kTime;
  const Tally before = tally_;
  begin(epoch);
  const EpochEnd end = loop(epoch, poll);
  EpochCounts counts;
  counts.collisions = static_cast<double>(tally_.collisions - before.collisions);
  counts.predictions = static_cast<double>(tally_.predictions - before.predictions);
  counts.candidates = static_cast<double>(tally_.candidates - before.candidates);
  counts.outer_pairs = static_cast<double>(hulls_.outer_sum());
  counts.ended_by_hulls = end == EpochEnd::kHulls;
  counts.few_strays = hulls_.stray_count() < most_strays_ / 4;
  skins_.learn(counts, state_.count());
  synchronise();
  return end;
}

void Engine::begin(const Epoch &epoch) {
  growth_ = epoch.growth;
  now_ = 0;
  end_ = epoch.longest;
  kinetic_ = state_.kinetic_energy();
  for (size_t i = 0; i < particles_.size(); i++) {
    particles_[i] = {state_.centers[i], 0, state_.velocities[i], state_.radii[i]};
  }
  rebuild_hulls();
  std::vector<double> times(particles_.size());
  for (size_t i = 0; i < particles_.size(); i++) {
    const auto particle = static_cast<int32_t>(i);
    events_[i] = box_.any_periodic() ? next_event<true>(particle) : next_event<false>(particle);
    times[i] = events_[i].time;
  }
  queue_.fill(times);
}

void Engine::rebuild_hulls() {
  const size_t count = particles_.size();
  std::vector<Sphere> spheres(count);
  std::vector<double> inner(count), outer(count);
  for (size_t i = 0; i < count; i++) {
    spheres[i] = {state_.centers[i], state_.radii[i] * state_.scale};
    const double growth = growth_ * state_.radii[i];
    inner[i] = skins_.inner(spheres[i].radius, growth);
    outer[i] = skins_.outer(spheres[i].radius, growth);
  }
  hulls_.rebuild(spheres, inner, outer);
  tally_.rebuilds++;
}

EpochEnd Engine::loop(const Epoch &epoch, const std::function<bool()> &poll) {
  const uint64_t most_collisions = tally_.collisions + epoch.most_collisions;
  const uint64_t stall = kStallCollisions * static_cast<uint64_t>(particles_.size());
  uint64_t next_stall_check = tally_.collisions + stall;
  uint64_t steps = kEventsPerPoll - 1;  // the first event is polled: epochs may be shorter
  double stall_time = 0;
  for (;;) {
    if (queue_.first_time() >= epoch.longest) {
      now_ = epoch.longest;
      return EpochEnd::kTime;
    }
    now_ = queue_.first_time();
    process(queue_.first());
    if (tally_.collisions >= most_collisions) return EpochEnd::kCollisions;
    if (hulls_.stray_count() > most_strays_) return EpochEnd::kHulls;
    if (tally_.collisions >= next_stall_check) {
      if (now_ - stall_time < kStallShare * epoch.longest) return EpochEnd::kStalled;
      stall_time = now_;
      next_stall_check = tally_.collisions + stall;
    }
    if (kinetic_ > epoch.highest_energy) return EpochEnd::kEnergy;
    if (++steps % kEventsPerPoll == 0 && poll && !poll()) return EpochEnd::kStopped;
  }
}

void Engine::synchronise() {
  for (size_t i = 0; i < particles_.size(); i++) {
    advance(particles_[i]);
    state_.centers[i] = particles_[i].center;
    state_.velocities[i] = particles_[i].velocity;
  }
  state_.scale = scale();
  tally_.time += now_;
  now_ = 0;
}

void Engine::advance(Particle &particle) const {
  particle.center += particle.velocity * (now_ - particle.time);
  box_.wrap(particle.center);
  particle.time = now_;
}

void Engine::process(int32_t i) {
  const Event &event = events_[index(i)];
  if (event.partner >= 0) {
    const int32_t j = event.partner;
    if (counts_[index(j)] == event.partner_count) return collide(i, j);
    tally_.stale++;
    return predict(i);
  }
  if (event.partner == kExit) return renew_hull(i);
  hit_wall(i, kFirstWall - event.partner);
}

void Engine::predict(int32_t i) {
  events_[index(i)] = box_.any_periodic() ? next_event<true>(i) : next_event<false>(i);
  queue_.set(i, events_[index(i)].time);
}

template <bool kPeriodic>
Engine::Event Engine::next_event(int32_t i) {
  const Particle &particle = particles_[index(i)];
  const double now_scale = scale();
  const Vector center = particle.center + particle.velocity * (now_ - particle.time);
  const Sphere &hull = hulls_.hull(i);
  const Vector from_hull = kPeriodic ? box_.nearest(center - hull.center) : Vector(center - hull.center);
  int32_t partner = kExit;
  double tau =
      exit_time(from_hull, particle.velocity, hull.radius - now_scale * particle.radius, growth_ * particle.radius);
  meet_walls(particle, center, tau, partner);
  const Row row = hulls_.partners(i);
  for (const int32_t j : row) __builtin_prefetch(&particles_[index(j)]);
  for (const int32_t j : row) {
    const Particle &other = particles_[index(j)];
    Vector x = other.center + other.velocity * (now_ - other.time) - center;
    if constexpr (kPeriodic) x = box_.nearest(x);
    const Vector v = other.velocity - particle.velocity;
    const double radii = particle.radius + other.radius;
    const double meeting = meeting_time(x, v, now_scale * radii, growth_ * radii, tau);
    if (meeting < tau) {
      tau = meeting;
      partner = j;
    }
  }
  tally_.predictions += row.size();
  return {now_ + tau, partner, partner >= 0 ? counts_[index(partner)] : 0};
}

void Engine::meet_walls(const Particle &particle, const Vector &center, double &tau, int32_t &partner) const {
  const double radius = scale() * particle.radius, growth = growth_ * particle.radius;
  for (int axis = 0; axis < box_.dimension(); axis++) {
    if (box_.is_periodic(axis)) continue;
    const double lower = wall_time(center[axis] - radius, -particle.velocity[axis], growth);
    const double upper = wall_time(box_.edge(axis) - center[axis] - radius, particle.velocity[axis], growth);
    if (lower < tau) tau = lower, partner = kFirstWall - 2 * axis;
    if (upper < tau) tau = upper, partner = kFirstWall - 2 * axis - 1;
  }
}

void Engine::collide(int32_t i, int32_t j) {
  Particle &a = particles_[index(i)], &b = particles_[index(j)];
  advance(a);
  advance(b);
  Vector normal = box_.nearest(b.center - a.center);
  const double distance = std::sqrt(square(normal));
  if (distance > 0) {
    normal /= distance;
  } else {
    normal = i < j ? Vector::UnitX() : Vector(-Vector::UnitX());  // points at one place part along x
  }
  const double v_n = dot(normal, b.velocity - a.velocity), growth = growth_ * (a.radius + b.radius);
  const double m_a = state_.masses[index(i)], m_b = state_.masses[index(j)], mu = m_a * m_b / (m_a + m_b);
  const double impulse = pair_impulse(mu, v_n, growth);
  a.velocity -= impulse / m_a * normal;
  b.velocity += impulse / m_b * normal;
  const double gain = impulse * (v_n + impulse / (2 * mu));
  kinetic_ += gain;
  tally_.energy_gain += gain;
  tally_.virial += impulse * distance;
  tally_.collisions++;
  ++counts_[index(i)];
  ++counts_[index(j)];
  predict(i);
  predict(j);
}

void Engine::hit_wall(int32_t i, int wall) {
  Particle &particle = particles_[index(i)];
  advance(particle);
  const int axis = wall / 2;
  const double inward = wall % 2 == 0 ? 1 : -1, mass = state_.masses[index(i)];
  const double before = inward * particle.velocity[axis];
  const double after = wall_rebound(before, growth_ * particle.radius);
  particle.velocity[axis] = inward * after;
  const double gain = mass * (after * after - before * before) / 2;
  kinetic_ += gain;
  tally_.energy_gain += gain;
  tally_.wall_impulse += mass * (after - before);
  tally_.wall_hits++;
  ++counts_[index(i)];
  predict(i);
}

void Engine::renew_hull(int32_t i) {
  Particle &particle = particles_[index(i)];
  advance(particle);
  const double radius = scale() * particle.radius;
  tally_.candidates += hulls_.renew(i, {particle.center, radius}, skins_.inner(radius, growth_ * particle.radius));
  tally_.renewals++;
  predict(i);
}

}  // namespace packing::event
