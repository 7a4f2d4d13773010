// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// Event-driven dynamics of hard spheres (disks) whose radii grow at a common relative rate.
#pragma once

#include "packing/box.hpp"
#include "packing/event/event_queue.hpp"
#include "packing/event/hull_lists.hpp"
#include "packing/event/skins.hpp"
#include "packing/vector.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace packing::event {

// All particles at one time. The radius of particle i is scale * radii[i].
struct State {
  std::vector<Vector> centers, velocities;
  std::vector<double> radii, masses;
  double scale = 1;

  size_t count() const { return radii.size(); }
  double kinetic_energy() const;
};

// What happened, counted from the start of an engine.
struct Tally {
  uint64_t collisions = 0;  // of two particles
  uint64_t wall_hits = 0;
  uint64_t renewals = 0;     // of hulls
  uint64_t stale = 0;        // events found outdated and predicted anew
  uint64_t predictions = 0;  // of the meeting of two particles
  uint64_t candidates = 0;   // hulls tested in renewals
  uint64_t rebuilds = 0;     // of all hulls
  double time = 0;
  double virial = 0;        // sum over collisions of impulse times distance of centres
  double wall_impulse = 0;  // sum over hits of walls
  double energy_gain = 0;   // from growing surfaces

  uint64_t events() const { return collisions + wall_hits + renewals + stale; }
};

// Why an epoch ended.
enum class EpochEnd {
  kTime,        // it is over
  kCollisions,  // the number asked for is reached
  kHulls,       // too many particles have left their outer hulls
  kEnergy,      // the kinetic energy has grown beyond the limit
  kStalled,     // collisions go on, time does not
  kStopped      // the poll said so
};

// One stretch at a constant growth rate (of the scale per time).
struct Epoch {
  double growth = 0;
  double longest = 0;  // time
  uint64_t most_collisions = 0;
  double highest_energy = 0;  // kinetic
};

// Spheres move freely, collide elastically with each other's (growing) surfaces and with walls. Each particle has its
// own time and place, brought up to date only when an event concerns it; each has one event in a queue: the earliest
// of its meetings with partners and walls and of its leaving its hull. An event whose partner has collided meanwhile
// is outdated and predicted anew when its turn comes: whatever changed the partner has predicted their meeting itself.
//
// Time starts anew with every epoch, so that no digits are lost to a large absolute time. Same state, same epochs: same
// bytes on every machine.
class Engine {
 public:
  // Throws Error if a value is not finite, a radius or mass is not positive, or particles are so few or the periodic
  // box so short that hulls do not fit. Particles must lie in the box and must not overlap.
  Engine(const Box &box, State state);

  // Brings all particles to the end of the epoch. `poll` is asked every few thousand events; false stops.
  EpochEnd run(const Epoch &epoch, const std::function<bool()> &poll = {});

  // All particles at the end of the last epoch; valid until the next run.
  const State &state() const { return state_; }
  // The scale now, also from within a poll.
  double scale() const { return state_.scale + growth_ * now_; }
  const Tally &tally() const { return tally_; }
  const Box &box() const { return box_; }

  // Multiplies all velocities.
  void scale_velocities(double factor);

 private:
  // One cache line: all that a prediction reads of a partner.
  struct alignas(64) Particle {
    Vector center;
    double time;  // of the centre
    Vector velocity;
    double radius;  // at scale 1
  };
  struct Event {
    double time;
    int32_t partner;         // a particle, or one of the codes below
    uint32_t partner_count;  // the partner's collisions when it was predicted
  };
  static constexpr int32_t kExit = -1;
  static constexpr int32_t kFirstWall = -2;  // then downwards: lower x, upper x, lower y ...

  static size_t index(int32_t particle) { return static_cast<size_t>(particle); }
  void begin(const Epoch &epoch);
  EpochEnd loop(const Epoch &epoch, const std::function<bool()> &poll);
  void synchronise();
  void rebuild_hulls();
  void process(int32_t i);
  void advance(Particle &particle) const;
  void predict(int32_t i);
  template <bool kPeriodic>
  Event next_event(int32_t i);
  void meet_walls(const Particle &particle, const Vector &center, double &tau, int32_t &partner) const;
  void collide(int32_t i, int32_t j);
  void hit_wall(int32_t i, int wall);
  void renew_hull(int32_t i);

  Box box_;
  State state_;
  std::vector<Particle> particles_;
  std::vector<uint32_t> counts_;  // collisions of each particle
  std::vector<Event> events_;
  EventQueue queue_;
  HullLists hulls_;
  Skins skins_;
  size_t most_strays_;
  double growth_ = 0, now_ = 0, end_ = 0;
  double kinetic_ = 0;
  Tally tally_;
};

}  // namespace packing::event
