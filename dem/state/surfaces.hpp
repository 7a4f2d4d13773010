// SPDX-FileCopyrightText: The libhgrid developers
// SPDX-License-Identifier: BSD-3-Clause
// The walls beside those of the box: where they stand, which particles are near, and what they do to particles.
#pragma once

#include "dem/state/bodies.hpp"
#include "dem/state/checkpoint.hpp"
#include "dem/state/contact_search.hpp"
#include "dem/state/surface.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace dem {

// A wall at the time of a step.
struct WallReport {
  std::string name;
  WallPlace place;
  double push[3]{};   // the force on particles
  double torque = 0;  // of it, about the axis through the pivot
  double work = 0;    // that it has done on particles
};

// Where a wall at this place stands, at rest.
template <int D>
WallPose<D> pose_of(const WallBody &wall, const WallPlace &place);

// What the surface at one place of the list does to its particle.
template <int D>
struct SurfacePush {
  Vec<D, double> force = Vec<D, double>::Zero();
  Spin<D, double> torque = Spin<D, double>::Zero();  // about the wall's pivot
};

template <int D>
class Surfaces {
 public:
  Surfaces() = default;
  explicit Surfaces(const Setup &setup);

  bool empty() const { return walls_.empty(); }

  // Brings the walls to where they stand at a time since the setup began.
  void move_to(double time);

  // Whether the list still has all surfaces that particles could reach: walls have moved by no more than `way` since.
  bool hold(double way) const;
  // Lists anew who could reach a surface when both have moved by `way`, ascending by particle and surface. `search`
  // holds the same particles, and has a margin of 2 ways.
  template <class Real>
  void list(const Bodies<D, Real> &bodies, ContactSearch &search, double range, double way);
  PairView pairs() const { return {list_.data(), list_.size()}; }

  const std::vector<Surface<D>> &surfaces() const { return surfaces_; }
  const WallPose<D> &pose_of(const Surface<D> &surface) const { return poses_[static_cast<size_t>(surface.wall)]; }

  // Where the force at place p of the list is noted. Those at other places are none.
  SurfacePush<D> *pushes() { return pushes_.data(); }
  void clear_pushes() { pushes_.assign(list_.size(), {}); }
  // Adds up what has been noted, in the order of the list whatever the threads, and the work on the way here.
  void sum_up();

  // Planes that press move on; all others go by the time.
  void press(double step);

  // Where walls stand, for those of the same name in the next stage.
  std::vector<NamedPlace> named_places() const;
  // What contacts with the same surfaces remember from the stage before, under their numbers here.
  ContactMemory taken_over(const Beginning &beginning) const;

  std::vector<WallReport> reports() const;
  double work() const;  // of all walls on particles
  size_t bytes() const;

  void save(Checkpoint &checkpoint) const;
  void restore(const Checkpoint &checkpoint);

 private:
  // What a wall goes on from; nothing but numbers, as in checkpoints.
  struct State {
    double pressed = 0, press_speed = 0;  // along the normal
    double shift[3]{}, angle = 0;         // when forces were last summed up
    double push[3]{}, torque = 0, work = 0;
    double known = 0;  // 1: those are of a step
  };

  WallPlace place_of(size_t wall) const;
  double way_between(size_t wall, const WallPlace &from, const WallPlace &to) const;

  std::vector<WallBody> walls_;
  std::vector<State> states_;
  std::vector<WallPose<D>> poses_;
  std::vector<Surface<D>> resting_, surfaces_;  // where the scene puts them, and now
  double time_ = 0;
  std::vector<double> reach_;         // of each wall, how far a mesh reaches from its pivot
  std::vector<WallPlace> listed_at_;  // where walls were when the list was made
  std::vector<hg_pair> list_;
  std::vector<SurfacePush<D>> pushes_;
};

}  // namespace dem
